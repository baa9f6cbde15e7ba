# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Order of convergence in the coupling interval and the DEM step, of the relaxation
of an even slip between spheres and fluid; the mesh, of a falling cloud."""

import os

import numpy as np
from scipy.integrate import solve_ivp

from validation.lib.checks import coupled, plots

TITLE = "observed order of convergence: coupling interval, DEM step; the mesh"

RHO, RHO_P, D, MU, SPEED, EDGE = 1000.0, 2600.0, 2e-3, 0.02, 0.05, 0.0288
PHI = 512 * np.pi / 6 * D**3 / EDGE**3
# a lattice of which every cell holds eight spheres, for as long as none crosses a face
EVEN = ["bottom=cyclic", "top=cyclic", "gravity=0", f"speed_z={SPEED}", "spacing=3.6e-3", "across_x=8", "across_y=8",
        "across_z=8", f"size_x={EDGE}", f"size_y={EDGE}", f"size_z={EDGE}", "cells_x=4", "cells_y=4", "cells_z=4",
        f"viscosity={MU}", "end=0.012"]


def scene(where, *settings):
    """Times, and momentum of the spheres upwards."""
    words = [w for s in settings for w in ("--set", s)]
    folder = coupled.finished("lattice-scene", os.path.join("convergence", where), "--no-pictures", *words)
    m = coupled.columns(os.path.join(folder, "DEM", "means.csv"))
    return np.array(m["t"]), np.array(m["pz"])


def relaxation(t, cm):
    """Speed of the spheres: k (u - v) and added mass, and the opposite on the fluid, with
    Wen and Yu's k at n = 0.91; no pressure gradient in a periodic box."""
    n = 1 - PHI
    inertia = np.array([[RHO_P + cm * RHO, -cm * RHO], [-PHI * cm * RHO, n * RHO + PHI * cm * RHO]])

    def rate(_, y):
        slip = y[1] - y[0]
        k = 18 * MU / D**2 * n**-2.7 * (1 + 0.15 * (n * abs(slip) * D * RHO / MU)**0.687)
        return np.linalg.solve(inertia, [k * slip, -PHI * k * slip])
    return solve_ivp(rate, (0, t[-1]), [SPEED, 0.0], t_eval=t, rtol=1e-10, atol=1e-14).y[0]


def error(where, cm, step, interval):
    forces = "pressureGradient+addedMass" if cm else "pressureGradient"
    t, pz = scene(where, *EVEN, f"forces={forces}", f"dem_step={step}", f"coupling_steps={interval}")
    v = pz / (512 * RHO_P * np.pi / 6 * D**3)
    return float(np.abs(v - relaxation(t, cm)).max() / SPEED), float(v[-1])


def run(checks):
    lines = []
    for cm in (0.0, 0.5):
        name = f"added mass {cm:g}"
        steps = (80, 40, 20)
        errors = [error(f"interval-{cm:g}-{n}", cm, 1.5e-5, n)[0] for n in steps]
        intervals = [1.5e-5 * n for n in steps]
        checks.close(f"{name}: order in the coupling interval, 1.2 to 0.3 ms",
                     float(np.polyfit(np.log(intervals), np.log(errors), 1)[0]), 1.0, 0.1)
        checks.at_most(f"{name}: error at 0.3 ms, over the speed at the start", errors[-1], 0.0015)
        lines += [(f"{name}: error, coupling interval", intervals, errors, "dots"), (None, intervals, errors, "line")]
        steps = (3e-4, 1.5e-4, 7.5e-5)
        ends = [error(f"step-{cm:g}-{n}", cm, s, n)[1] for n, s in zip((1, 2, 4), steps)]
        checks.close(f"{name}: order in the DEM step, 0.3 to 0.075 ms",
                     float(np.log2((ends[0] - ends[1]) / (ends[1] - ends[2]))), 1.0, 0.1)
        changes = [abs(a - b) / SPEED for a, b in zip(ends, ends[1:])]
        lines += [(f"{name}: change on halving the DEM step", steps[:-1], changes, "dots"),
                  (None, steps[:-1], changes, "dashed")]

    cloud = ["bottom=wall", "top=wall", "sides=slip", "across_x=4", "across_y=4", "across_z=6", "origin_z=0.0264",
             "stagger=1", "smoothing=diffusion", "bandwidth=6e-3", "forces=pressureGradient+buoyancy",
             "coupling_steps=20",
             "end=0.04"]
    last = [scene(f"mesh-{n}", *cloud, f"cells_x={n}", f"cells_y={n}", f"cells_z={3 * n}")[1][-1] for n in (4, 6, 8)]
    for n, pz in zip((4, 6), last):
        checks.close(f"speed of a falling cloud, diffusion over 6 mm: cells of {19.2 / n:.1f} mm against 2.4 mm",
                     pz / last[2], 1.0, 0.01)
    checks.picture(plots.compare(os.path.join(coupled.RUNS, "convergence", "convergence.png"), lines,
                                 "coupling interval or DEM step [s]",
                                 "over the speed at the start", "relaxation of an even slip", logx=True, logy=True))
