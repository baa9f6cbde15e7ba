# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""One sphere falls into rising gas (MFiX's DEM06): frozen gas, two-way, two-way corrected."""

import os

import numpy as np

from validation.lib.checks import plots, single_sphere
from validation.lib.checks.coupled import RUNS, summary
from validation.lib.checks.reference import table

TITLE = "MFiX DEM06: one sphere in rising gas, from rest to its terminal velocity"


def _run(where, **more):
    values = {"size_x": 0.01, "size_y": 0.01, "size_z": 0.1, "cells_x": 5, "cells_y": 5, "cells_z": 20,
              "sides": "slip", "bottom": "inlet", "top": "open", "inlet_velocity": 0.4, "start_velocity": 0.4,
              "sphere_radius": 5e-5, "density": 2000, "fluid_density": 1.2, "viscosity": 1.8e-5,
              "at_z": 0.6, "end": 0.3, "dem_step": 5e-5, "coupling_steps": 20, "frames": 2, "curve_rows": 200,
              "rows": 300, **more}
    folder = single_sphere.run(f"mfix-dem06/{where}", **values)
    return single_sphere.path(folder), folder


def run(checks):
    ref = table("mfix_dem06_terminal_velocity")
    t, v = (np.asarray(ref[k]) for k in ("time_s", "rk4_vel_m_per_s"))
    chosen = (t > 0) & (t <= 0.3)
    errors, curves = {}, []
    for where, name, gate, more in (
            ("frozen", "gas frozen", 0.005, {"frozen_fluid": "yes"}),
            ("two-way", "two-way, corrected", 0.01, {"self_disturbance": "latticeMemory"}),
            ("plain", "two-way, not corrected", None, {})):
        (time, _, speed), folder = _run(where, **more)
        found = np.interp(t[chosen], time, speed)
        errors[where] = float(np.max(np.abs(found / v[chosen] - 1)))
        if gate:
            checks.at_most(f"{name}: largest error of the velocity", errors[where], gate)
            checks.close(f"{name}: velocity at 0.3 s", float(found[-1]), float(v[chosen][-1]), gate)
        curves.append((name, time, speed, "line"))
        checks.at_most(f"{name}: momentum residual", summary(folder)["max_momentum_residual"], 1e-10)
    checks.at_least("two-way, not corrected: largest error of the velocity", errors["plain"], 0.01)
    checks.picture(plots.compare(os.path.join(RUNS, "mfix-dem06", "velocity.png"),
                                 curves + [("Runge-Kutta", t[chosen], v[chosen], "dots")],
                                 "time / s", "velocity, upwards / (m/s)", TITLE))
