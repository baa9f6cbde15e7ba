# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Drag coefficients of falling spheres against those measured by Roos and Willmarth."""

import os

import numpy as np

from validation.lib.checks import plots, single_sphere
from validation.lib.checks.coupled import RUNS
from validation.lib.checks.reference import table

TITLE = "Roos and Willmarth 1971: drag coefficients of spheres, from their fall in coupled runs"
D, RHO, SOLID, G = 1e-3, 1000.0, 2600.0, 9.81


def _cd(re):
    """Of Schiller and Naumann, to choose viscosities that give about re."""
    return 24 / re * (1 + 0.15 * re**0.687) if re < 1000 else 0.44


def run(checks):
    ref = table("roos_willmarth1971_spheres")
    re, cd = (np.asarray(ref[k]) for k in ("reynolds_number", "drag_coefficient"))
    found = []
    for wanted in (5.5, 20.0, 70.0, 200.0, 600.0, 2000.0):
        speed = np.sqrt(4 / 3 * G * D * (SOLID / RHO - 1) / _cd(wanted))
        viscosity = RHO * speed * D / wanted
        # Euler's response: tau = speed/(g (1 - rho/rho_p)); ten of them
        end = float(f"{10 * speed / (G * (1 - RHO / SOLID)):.1g}")
        folder = single_sphere.run(f"roos-willmarth/Re{wanted:.0f}", size_x=0.05, size_y=0.05, size_z=0.5, cells_x=5,
                                   cells_y=5, cells_z=50, sides="slip", sphere_radius=0.5 * D, at_z=0.95,
                                   viscosity=float(viscosity), end=end, dem_step=float(end / 4000), coupling_steps=10,
                                   self_disturbance="latticeMemory", frames=2, curve_rows=200)
        v = float(np.mean(-single_sphere.path(folder)[2][-20:]))
        found.append((v * D * RHO / viscosity, 4 / 3 * G * D * (SOLID / RHO - 1) / v**2))
    runs = np.array(found)

    # between the runs the law is smooth in log-log: their Cd Re/24 - 1 goes as a power of Re
    excess = np.log(np.maximum(runs[:, 1] * runs[:, 0] / 24 - 1, 1e-9))
    inside = (re >= runs[0, 0]) & (re <= 1000)
    fitted = 24 / re[inside] * (1 + np.exp(np.interp(np.log(re[inside]), np.log(runs[:, 0]), excess)))
    error = fitted / cd[inside] - 1
    checks.close("Re below 1000: mean error of C_D", float(np.mean(error)), 0.0, 0.03, relative=False)
    checks.at_most("Re below 1000: rms error of C_D", float(np.sqrt(np.mean(error**2))), 0.07)
    checks.at_least("Stokes's law instead: rms error of C_D",
                    float(np.sqrt(np.mean((24 / re[inside] / cd[inside] - 1)**2))), 0.07)
    checks.picture(plots.compare(os.path.join(RUNS, "roos-willmarth", "drag.png"),
                                 [("measured", re, cd, "dots"), ("coupled runs", runs[:, 0], runs[:, 1], "line")],
                                 "Re", "C_D", TITLE, logx=True, logy=True))
