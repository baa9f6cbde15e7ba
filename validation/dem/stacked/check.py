# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""MFiX-DEM's case DEM03: two spheres squeezed between floor and roof."""

import os

import numpy as np

from validation.lib.checks import coupled, plots, reference

TITLE = "two squeezed spheres (MFiX DEM03)"


def run(checks):
    r = reference.table("mfix_dem03_two_stacked_compressed")
    folder = coupled.dem("stacked", "stacked", dt=1e-7, steps=int(r["time_s"][-1] / 1e-7) + 20)
    t = coupled.columns(os.path.join(folder, "DEM", "trajectory.csv"))
    curves = []
    for k, name in ((1, "lower"), (2, "upper")):
        wanted = r[f"y{k}_ref_m"]
        found = np.interp(r["time_s"], t["time_s"], t[f"z{k}_m"])
        reach = np.ptp(wanted)
        checks.at_most(f"{name} sphere: largest error over the reach of its motion",
                       np.max(np.abs(found - wanted)) / reach, 0.01)
        checks.close(f"{name} sphere: reach of its motion [m]", np.ptp(found), reach, 0.01)
        checks.close(f"{name} sphere: height at the end [m]", found[-1], wanted[-1], 0.01)
        curves += [(name, np.array(t["time_s"]) * 1e3, 1e6 * (np.array(t[f"z{k}_m"]) - wanted[0]), "line"),
                   (f"{name}, reference", r["time_s"] * 1e3, 1e6 * (wanted - wanted[0]), "dots")]
    checks.picture(plots.compare(os.path.join(coupled.RUNS, "stacked", "height.png"), curves, "time [ms]",
                                 "height over that at the start [um]", "two squeezed spheres, e = 1"))
