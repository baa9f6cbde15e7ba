# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Five clumps fall along their axes at the speed of their Stokes resistance."""

import glob
import os

import numpy as np

from validation.lib.checks import plots
from validation.lib.checks.coupled import finished, summary
from validation.lib.checks.reference import table

TITLE = "clumps fall along each axis as their Stokes resistance wants it"
A, DRHO, G = 1e-3, 1000.0, 9.81

# outlines of discs that touch, for the law of Tran-Cong et al.: d_A over the
# discs' diameter, and pi d_A over the outer border
SHADOWS = {("dimer", "x"): (2**0.5, 2**0.5 / 2), ("dimer", "z"): (1, 1),
           ("chain3", "x"): (3**0.5, 3**0.5 / 3), ("chain3", "z"): (1, 1),
           ("hexplate7", "z"): (7**0.5, 7**0.5 / 4)}


def falling(folder):
    """Time and downward speed of each clump's middle, by its number."""
    times, speeds = [], {}
    for path in sorted(glob.glob(os.path.join(folder, "DEM", "spheres.*.dump"))):
        rows = np.loadtxt(path, skiprows=9)
        times.append(int(path.split(".")[-2]))
        for body in np.unique(rows[:, 2]):
            speeds.setdefault(int(body), []).append(-rows[rows[:, 2] == body, 8].mean())
    return np.array(times), {b: np.array(v) for b, v in speeds.items()}


def growth(Re, width, circularity):
    """Tran-Cong, Gay and Michaelides (2004), C_D over its own Stokes limit."""
    X = Re * width
    return (1 + 0.15 * X**0.687 / circularity**0.5 +
            0.42 * width * Re / 24 / (circularity**0.5 * (1 + 4.25e4 * X**-1.16)))


def terminal(mu, N, F, shadow):
    """Speed at which a clump's drag 6 pi mu a F f(Re) v is its weight."""
    d = 2 * A * N**(1 / 3)
    v = stokes = N / F * 2 / 9 * DRHO * G * A**2 / mu
    for _ in range(200):
        v = 0.5 * (v + stokes / growth(1000 * v * d / mu, shadow[0] / N**(1 / 3), shadow[1]))
    return v


def run(checks):
    ref = table("clump_stokes_drag_computed")
    names = list(ref["shape"])
    folder = finished("clump-drag", "clump-drag")
    plain = finished("clump-drag", "clump-drag-sum", "--set", "clump_drag=sphereSum")
    swift = finished("clump-drag", "clump-drag-swift", "--set", "viscosity=0.01", "--set", "dem_step=1e-4", "--set",
                     "stiffness=3", "--end", "0.5")
    shared = finished("clump-drag", "clump-drag-ranks", "--dem", "2", "--cfd", "2")

    times, speeds = falling(folder)
    summed, fast, parts = (falling(f)[1] for f in (plain, swift, shared))
    unit = 2 / 9 * DRHO * G * A**2 / 10
    for i, name in enumerate(names):
        for j, axis in enumerate("xyz"):
            body = 3 * i + j + 1
            wanted = ref["N"][i] / ref["F_" + axis][i] * unit
            checks.close(f"{name}, falling along its {axis}: speed [m/s]", speeds[body][-1], wanted, 0.02)
    off = [100 * (N / F - 1) for axis in "xyz" for N, F in zip(ref["N"], ref["F_" + axis])]
    worst = [100 * (ref["N"][i] / ref["F_" + axis][i] * unit / summed[3 * i + j + 1][-1] - 1)
             for i in range(5) for j, axis in enumerate("xyz")]
    checks.at_least("sphereSum: least slowness of a clump [%]", min(worst), 0.98 * min(off))
    checks.at_least("sphereSum: largest slowness of a clump [%]", max(worst), 0.98 * max(off))

    for (name, axis), shadow in SHADOWS.items():
        i = names.index(name)
        body = 3 * i + "xyz".index(axis) + 1
        wanted = terminal(0.01, ref["N"][i], ref["F_" + axis][i], shadow)
        checks.close(f"{name} along its {axis} at Re {1000 * wanted * 2 * A * ref['N'][i]**(1 / 3) / 0.01:.0f}: "
                     "speed [m/s]", fast[body][-1], wanted, 0.02)

    checks.at_most("2 + 2 ranks, a clump across the border: largest relative difference of a speed (6 digits)",
                   float(np.max([abs(parts[b][-1] / speeds[b][-1] - 1) for b in speeds])), 2e-6)
    for what, where in (("resistance", folder), ("resistance, Re 27 to 52", swift), ("2 + 2 ranks", shared)):
        s = summary(where)
        checks.at_most(f"{what}: momentum residual", s["max_momentum_residual"], 1e-10)
        checks.equal(f"{what}: both halves say which drag it was",
                     s["settings"]["dem"]["clump_drag"] + " " + s["settings"]["cfd"]["clumpDrag"],
                     "resistance resistance")

    picture(checks, os.path.join(folder, "speeds.png"), times / times[-1] * 2, names, ref, speeds, summed, unit)


def picture(checks, path, time, names, ref, speeds, summed, unit):
    """Speeds over that of one sphere, with the reference's ends."""
    fig, ax = plots.plt.subplots(figsize=(6.4, 4.6))
    for i, name in enumerate(names):
        for axis in "xz"[name == "tetrahedron4":]:
            wanted = ref["N"][i] / ref["F_" + axis][i]
            line, = ax.plot(time, speeds[3 * i + "xyz".index(axis) + 1] / unit)
            ax.plot([0.5, time[-1]], [wanted] * 2, **plots.STYLES["dashed"])
            ax.text(2.05, wanted, f"{name}, along {axis}", color=line.get_color(), fontsize=8,
                    va={"chain3": "bottom", "hexplate7": "center"}.get(name, "top"))
    ax.plot(time, summed[15] / unit, **plots.STYLES["dots"])
    ax.text(2.05, 1, "sphereSum, any clump", fontsize=8, va="center")
    ax.set(xlim=(0, 2.9), xlabel="time [ms]", ylabel="speed over that of one sphere")
    ax.set_title("Clumps falling along their axes; dashed: clump_stokes_drag_computed", fontsize=9)
    ax.grid(alpha=0.3)
    checks.picture(plots.save(fig, path))
