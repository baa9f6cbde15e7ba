# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What a bed under a rising flow shows: pressure_drop.csv, bed.json, bed.png."""

import csv
import json
import math
import os

import numpy as np

from cases.lib.case.errors import CaseError


def inlet(folder):
    """Time [s], kinematic pressure [m2/s2], superficial velocity [mm/s], as the
    function object `inlet` wrote them."""
    path = os.path.join(folder, "CFD", "postProcessing", "inlet", "0", "surfaceFieldValue.dat")
    try:
        with open(path, encoding="utf-8") as f:
            rows = [x.replace("(", " ").replace(")", " ").split() for x in f if not x.startswith("#")]
    except OSError:
        raise CaseError(f"{path} is missing: did controlDict keep its function object?") from None
    table = np.array(rows, dtype=float)
    return table[:, 0], table[:, 1], table[:, 4]


def weight(v):
    """Buoyant weight of the bed over its cross-section [Pa]."""
    one = 4 / 3 * math.pi * v["sphere_radius"]**3
    return v["spheres"] * one * (v["density"] - v["fluid_density"]) * v["gravity"] / (v["size_x"] * v["size_y"])


def ergun(v, porosity, height, velocity):
    """Ergun's drop over a bed [Pa]."""
    d, rho, mu, e = 2 * v["sphere_radius"], v["fluid_density"], v["viscosity"], porosity
    return height * (150 * (1 - e)**2 / e**3 * mu * velocity / d**2 + 1.75 * (1 - e) / e**3 * rho * velocity**2 / d)


def onset(velocity, drop, most):
    """Where the drop of the fixed bed, a U + b U2 fitted up to 0.8 of the buoyant
    weight `most`, reaches it: u_mf [m/s], or None if the ramp stays below."""
    top = int(np.argmax(drop > 0.8 * most)) if np.any(drop > 0.8 * most) else 0
    if top < 5:
        return None
    u = velocity[:top]
    a, b = np.linalg.lstsq(np.column_stack([u, u**2]), drop[:top], rcond=None)[0]
    square = a * a + 4 * b * most
    if square < 0 or abs(b) * most < 1e-9 * a * a:
        return float(most / a)
    return float((math.sqrt(square) - a) / (2 * b))


def finish(folder, v, curve, title):
    """Writes the three files; curve holds the columns of settling.csv. Returns lines to print."""
    t, p, u = inlet(folder)
    drop = v["fluid_density"] * p
    height = np.interp(t, curve["time_s"], curve["interface_m"])
    with open(os.path.join(folder, "pressure_drop.csv"), "w", encoding="utf-8", newline="") as f:
        out = csv.writer(f, lineterminator="\n")
        out.writerow(("time_s", "velocity_m_per_s", "pressure_drop_Pa", "bed_height_m"))
        out.writerows([f"{x:.8g}" for x in row] for row in zip(t, u, drop, height))

    most, rest = weight(v), height[0]
    solid = v["spheres"] * 4 / 3 * math.pi * v["sphere_radius"]**3 / (v["size_x"] * v["size_y"])
    uniform = 2 * curve["mean_height_m"][0]  # of a uniform bed with the same mean
    porosity = 1 - solid / uniform
    ramp = t > 0.5 * v["hold"]
    umf = onset(u[ramp], drop[ramp], most) if ramp.any() else None
    beyond = ramp & (u > 1.2 * umf) if umf else np.zeros(len(u), dtype=bool)
    found = {"buoyant_weight_Pa": most, "height_at_rest_m": float(uniform), "porosity_at_rest": float(porosity),
             "u_mf_m_per_s": umf,
             "fluidised_drop_over_weight": float(drop[beyond].mean() / most) if beyond.any() else None,
             "interface_at_rest_m": float(rest), "interface_at_end_m": float(height[-1])}
    with open(os.path.join(folder, "bed.json"), "w", encoding="utf-8") as f:
        json.dump(found, f, indent=2)
        f.write("\n")
    if not ramp.any():  # the run ended before the flow began to rise
        return [("bed height", f"{1e3 * rest:.1f} mm; the ramp was not reached")]
    _draw(os.path.join(folder, "bed.png"), v, (u[ramp], drop[ramp], height[ramp]), found, title)
    over = found["fluidised_drop_over_weight"]
    return [("u_mf", f"{umf:.4g} m/s" if umf else "not reached"),
            ("fluidised", f"drop {over:.3f} of the buoyant weight on the mean beyond 1.2 u_mf" if over else "not"),
            ("bed height", f"{1e3 * rest:.1f} mm, at the end {1e3 * height[-1]:.1f} mm")]


def _draw(path, v, ramp, found, title):
    from cases.lib.output.plotting import plt, titled
    u, drop, height = ramp
    fig, (ax, low) = plt.subplots(2, 1, figsize=(6.4, 6.4), sharex=True)
    u = 1e3 * u
    ax.plot(u, drop, lw=1.6, label="clayFoam")
    ax.axhline(found["buoyant_weight_Pa"], color="0.4", ls=":", label="buoyant weight")
    line = np.linspace(0, u.max(), 50)
    law = ergun(v, found["porosity_at_rest"], found["height_at_rest_m"], 1e-3 * line)
    keep = law < 1.4 * found["buoyant_weight_Pa"]
    ax.plot(line[keep], law[keep], "k--", lw=1.2, label=f"Ergun, mean porosity {found['porosity_at_rest']:.3f}")
    if found["u_mf_m_per_s"] and 1e3 * found["u_mf_m_per_s"] < u.max():
        for a in (ax, low):
            a.axvline(1e3 * found["u_mf_m_per_s"], color="C3", lw=1, label="u_mf" if a is ax else None)
    ax.set_ylabel("pressure drop [Pa]")
    ax.legend(fontsize=8)
    low.plot(u, 1e3 * height, lw=1.6)
    low.set_ylabel("bed height [mm]")
    low.set_xlabel("superficial velocity [mm/s]")
    for a in (ax, low):
        a.grid(alpha=0.3)
    titled(ax, title, 8)
    fig.tight_layout()
    fig.savefig(path, dpi=150)
    plt.close(fig)
