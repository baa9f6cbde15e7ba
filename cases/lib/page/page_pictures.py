# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of a run's page alone: the curve with theory and stages, profiles of the solid fraction."""

import io

import numpy as np

from cases.lib.calibration import stagefit
from cases.lib.case.errors import CaseError
from cases.lib.output import pictures, spheres
from cases.lib.output.plotting import plt

_LEAST_ROWS = 12


def _png(fig):
    """A figure as the bytes of a PNG."""
    found = io.BytesIO()
    fig.savefig(found, format="png", dpi=130)
    plt.close(fig)
    return found.getvalue()


def theory(case_name, values):
    """Kynch's column with the flux of the run's drag law, None where no theory is known."""
    from cases.lib.kynch import kynch_column
    try:
        kynch_column.refuse(case_name, values)
        return kynch_column.Column(values, kynch_column.POURED)
    except (CaseError, KeyError):
        return None


def stages(curve):
    """The stages of the upper interface, None of a curve with too few rows or without a fall."""
    t, z = curve["time_s"], curve["interface_m"]
    return stagefit.of(t, z) if t.size >= _LEAST_ROWS and np.ptp(z) > 0 else None


def settling(curve, found, column):
    """The upper interface, the lines of its stages, and theory where there is one; a PNG."""
    fig, ax = plt.subplots(figsize=(8, 4.6), layout="constrained")
    t, z = curve["time_s"], 1e3 * curve["interface_m"]
    ax.plot(t, z, color="#56B4E9", lw=2.6, label="upper interface")
    if found is not None:
        edges = np.concatenate([[found.start], found.breaks, [t[-1]]])
        line = np.concatenate([[0.0], np.cumsum(1e3 * found.slopes * np.diff(edges))])
        inside = t >= found.start
        line += np.mean(z[inside] - np.interp(t[inside], edges, line))
        ax.plot(edges, line, color="black", lw=1.0, label="its stages")
        for at in found.breaks:
            ax.axvline(at, color="#D55E00", lw=0.8, ls="--")
    if column is not None:
        ax.plot(t, 1e3 * column.kynch.interface(column.late(t)), color="#009E73", lw=1.4, ls=":",
                label="Kynch, flux of the drag law, from rest")
    ax.set_xlabel("time simulated [s]")
    ax.set_ylabel("height [mm]")
    ax.set_xlim(0, t[-1])
    ax.set_ylim(bottom=0)
    ax.grid(alpha=0.3)
    ax.legend(fontsize=8)
    return _png(fig)


def area_and_height(v):
    """Cross-section [m2] and height [m] of a case's room."""
    if "tube_radius" in v:
        return np.pi * v["tube_radius"]**2, v["tube_height"]
    return v["size_x"] * v["size_y"], v["size_z"]


def solid_fraction(s, v):
    """(heights [m] of the middles of layers two diameters high, solid fraction in each) of a dump's spheres, which
    count where their centres are, each by its share of its body's volume."""
    area, height = area_and_height(v)
    count = max(4, min(60, int(height / (4 * v["sphere_radius"]))))
    edges = np.linspace(0, height, count + 1)
    each = 4 / 3 * np.pi * s["radius"]**3
    if "body_mass" in v and "clumps" in v:
        each = np.full(len(s["radius"]), v["body_mass"] / v["density"] / 14)
    held = np.histogram(s["z"], edges, weights=each)[0]
    return 0.5 * (edges[1:] + edges[:-1]), held / (area * np.diff(edges))


def profiles(folder, values, torn):
    """Solid fraction over height at up to six times; a PNG, None without whole dumps."""
    found, step = [], values["dem_step"]
    try:
        dumps = spheres.dumps(folder)
        for i in pictures.telling(folder, [n * step for n, _ in dumps], 6):
            try:
                found.append((dumps[i][0] * step, *solid_fraction(spheres.read(dumps[i][1]), values)))
            except CaseError:
                if not torn:
                    raise
    except (CaseError, OSError):
        if not torn:
            raise
    if not found:
        return None
    fig, ax = plt.subplots(figsize=(8, 4.6), layout="constrained")
    for k, (time, z, phi) in enumerate(found):
        ax.plot(phi, 1e3 * z, color=plt.cm.viridis(0.9 * k / max(1, len(found) - 1)), label=f"{time:.3g} s")
    ax.set_xlabel("solid fraction by volume, in layers of two diameters")
    ax.set_ylabel("height [mm]")
    ax.set_xlim(left=0)
    ax.set_ylim(bottom=0)
    ax.grid(alpha=0.3)
    ax.legend(fontsize=8)
    return _png(fig)
