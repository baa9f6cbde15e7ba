# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Ten Cate's spheres: a law without walls must give its own velocity."""

import os

import numpy as np

from cases.lib.theory import drag
from validation.lib.checks import plots, single_sphere
from validation.lib.checks.coupled import RUNS
from validation.lib.checks.reference import table

TITLE = "ten Cate 2002: nylon sphere in silicone oil, an unbounded law's own velocity"
LONG = True
D = 0.015


def run(checks):
    ref = table("tencate2002_settling_sphere")
    series = []
    for k, name in enumerate(ref["case"]):
        rho, mu, fast = (float(ref[c][k]) for c in ("rho_f_kg_per_m3", "mu_Pa_s", "u_inf_m_per_s"))
        most = float(ref["u_max_experiment_m_per_s"][k])
        end = round(0.09 / fast / 1e-2) * 1e-2
        law = drag.terminal_velocity(D, 1120.0, rho, mu, drag_law="SchillerNaumann")
        # cells of 2 d in a box so wide that its walls do not show
        cells, side = 16, 16 * 2 * D
        folder = single_sphere.run(f"ten-cate/{name}", size_x=side, size_y=side, size_z=side, cells_x=cells,
                                   cells_y=cells, cells_z=cells, sides="slip", bottom="slip", top="slip",
                                   sphere_radius=0.5 * D, density=1120, fluid_density=rho, viscosity=mu, at_x=0.52,
                                   at_y=0.52, at_z=0.6, end=end, dem_step=2e-4, coupling_steps=10,
                                   self_disturbance="latticeMemory", frames=2, curve_rows=200)
        t, _, v = single_sphere.path(folder)
        last = float(np.mean(-v[-len(v) // 4:]))
        checks.close(f"{name}: terminal velocity against Schiller and Naumann", last, law, 0.02)
        checks.at_least(f"{name}: above the wall-retarded maximum measured, by", last / most - 1, 0.0)
        series += [(f"{name}", t, -v, "line"), (None, [0, t[-1]], [law, law], "dashed")]
    checks.picture(plots.compare(os.path.join(RUNS, "ten-cate", "velocity.png"), series, "time / s",
                                 "fall velocity / (m/s)", "ten Cate's E1 to E4; dashed: Schiller and Naumann"))
