# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""MFiX-DEM's case DEM04: a sphere thrown along a rough floor slips, then rolls."""

import os

import numpy as np

from validation.lib.checks import coupled, plots, reference

TITLE = "from slipping to rolling (MFiX DEM04)"
SPEED, RADIUS, GRAVITY = 0.2, 5e-4, 9.81


def run(checks):
    r = reference.table("mfix_dem04_rolling_on_rough_surface")
    curves = []
    for k, mu in enumerate(r["mu"]):
        scale = SPEED / (mu * GRAVITY)
        folder = coupled.dem("rolling", f"rolling/{mu:g}", mu=mu, speed=SPEED, dt=1e-6, steps=int(0.4 * scale / 1e-6))
        t = {key: np.array(v) for key, v in
             coupled.columns(os.path.join(folder, "DEM", "trajectory.csv")).items()}
        time, v, spin = t["time_s"] / scale, t["v_m_per_s"] / SPEED, t["omega_per_s"] * RADIUS / SPEED
        slip = v - spin
        n = np.flatnonzero(slip <= 0)[0]
        end = np.interp(0, slip[n:n - 2:-1], time[n:n - 2:-1])
        after = time > end
        checks.close(f"friction {mu:g}: end of slip, t mu g/u0", end, r["t_end_analytic_nd"][k], 0.01)
        checks.close(f"friction {mu:g}: speed then, u/u0", v[after].mean(), r["u_end_analytic_nd"][k], 0.01)
        checks.close(f"friction {mu:g}: spin then, R omega/u0", spin[after].mean(), r["omega_end_analytic_nd"][k], 0.01)
        if mu in (0.2, 1.0):
            some = slice(0, None, max(1, len(time) // 60))
            curves += [(f"u/u0, friction {mu:g}", time[some], v[some], "dots"),
                       (f"R omega/u0, friction {mu:g}", time[some], spin[some], "dots")]
    x = np.array([0, 2 / 7, 0.4])
    curves += [("exact", x, [1, 5 / 7, 5 / 7], "dashed"), (None, x, [0, 5 / 7, 5 / 7], "dashed")]
    checks.picture(plots.compare(os.path.join(coupled.RUNS, "rolling", "slip.png"), curves, "t mu g/u0",
                                 "speed, spin over u0", "a sphere thrown along a rough floor"))
