# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Films between spheres, and between a sphere and a wall: the approach against exact solutions."""

import os

import numpy as np

from validation.lib.checks import coupled, plots

TITLE = "approach through a film: sphere to sphere, sphere to wall"
A, MU = 5e-4, 1.0
STOKES = 6 * np.pi * MU * A
MASS = 2600 * 4 / 3 * np.pi * A ** 3


def brenner(gap, rigid):
    """Exact drag over Stokes's of a sphere that moves towards a plane, a wall or a free surface (which
    is the plane between two equal spheres that meet); gap over the radius. Brenner, Chem. Eng. Sci. 16 (1961) 242."""
    alpha = np.arccosh(1 + gap)
    n = np.arange(1, int(60 / alpha) + 20)
    x, s = (2 * n + 1) * alpha, np.sinh(alpha)
    with np.errstate(over="ignore", invalid="ignore"):
        if rigid:
            term = ((2 * np.sinh(x) + (2 * n + 1) * np.sinh(2 * alpha))
                    / (4 * np.sinh(x / 2) ** 2 - (2 * n + 1) ** 2 * s ** 2) - 1)
        else:
            term = ((4 * np.cosh(x / 2) ** 2 + (2 * n + 1) ** 2 * s ** 2)
                    / (2 * np.sinh(x) - (2 * n + 1) * np.sinh(2 * alpha)) - 1)
    return 4 / 3 * s * np.sum(n * (n + 1) / ((2 * n - 1) * (2 * n + 3)) * np.nan_to_num(term, nan=0))


def approach(where, **variables):
    folder = coupled.dem("lubrication-approach", "lubrication-approach/" + where, **variables)
    t = coupled.columns(os.path.join(folder, "DEM", "trajectory.csv"))
    return np.array(t["time_s"][1:]), np.array(t["gap_m"][1:])


def run(checks):
    curves = []
    # the term in 1/h alone: dh/dt = -F h/(6 pi mu (a/2)^2), whatever the step
    start = 0.02 * A
    resistance = STOKES * A / 4
    relax = MASS / 2 * start / resistance
    T = 4000 * relax
    for part in (0.2, 2.0, 20.0):
        dt = part * relax
        time, gap = approach(f"leading-{part:g}", gap=repr(start), force=repr(resistance / T),
                             start=repr(start / T / 2), law=["logarithm no shifted no"], dt=repr(dt),
                             steps=int(3 * T / dt), every=max(1, int(0.02 * T / dt)))
        exact = start * np.exp(-time / T)
        checks.at_most(f"two spheres, 1/h: largest error of the gap to 0.05 of the first, step {part:g} relaxation "
                       "times",
                       np.max(np.abs(gap / exact - 1)), 0.01)
        if part == 20:
            curves += [("two spheres, 1/h alone", time / T, gap / A, "line"),
                       ("exp(-t/T)", time[::8] / T, exact[::8] / A, "dots")]

    # all terms and Stokes's drag against the exact resistance: time from one gap to the next
    for name, wall, first in (("wall", 1, 0.2), ("two spheres", 0, 0.02)):
        force = MASS * 9.81
        unit = STOKES * A / force                 # time for a radius by Stokes's law alone
        exact = np.vectorize(lambda h: brenner(h if wall else h / 2, bool(wall)))
        share = 1 if wall else 2                  # of the approach: two spheres move
        gaps = np.geomspace(1e-3, first, 300)
        slow = exact(gaps) / share
        wanted = np.concatenate([[0], np.cumsum(np.diff(gaps) * (slow[1:] + slow[:-1]) / 2)]) * unit
        wanted = wanted[-1] - wanted              # time from the first gap on
        dt = 1e-5
        time, gap = approach(name.replace(" ", "-"), wall=wall, gap=repr(first * A), force=repr(force), K=repr(STOKES),
                             start=repr(A / unit / slow[-1] / share), law=["shifted no"], dt=dt,
                             steps=int(1.05 * wanted[0] / dt), every=200)
        for at in (0.3 * first, 0.1 * first, 1.001e-3):
            checks.close(f"{name}: time from gap {first:g} a to {at:g} a [s]",
                         np.interp(-at, -gap / A, time), np.interp(at, gaps, wanted), 0.01)
        curves += [(name, time / wanted[0], gap / A, "line"),
                   (f"{name}, exact", wanted[::12] / wanted[0], gaps[::12], "dots")]
    checks.picture(plots.compare(os.path.join(coupled.RUNS, "lubrication-approach", "gap.png"), curves,
                                 "time over T, or over that of the approach", "gap over radius",
                                 "approach through a film", logy=True))
