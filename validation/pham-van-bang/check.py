# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Batch settling from a solid fraction of 0.5 against the interfaces that were
measured by MRI, in units of H and H/v_Stokes."""

import os

import numpy as np

import coupled
import fronts
import plots
import reference

TITLE = "interfaces of a dense suspension against measurements in silicone oil"
LONG = True
# the experiment: height, Stokes velocity [m, m/s]; the run's box, Stokes velocity, DEM step
LAB_H, LAB_V = 0.054, 2.285e-4
H, AREA, STEP = 0.06, 1e-4, 4e-5
V = 1600.0 * 9.81 * 1e-3**2 / (18 * 0.01)


def run(checks):
    lab = reference.table("phamvanbang_interfaces")
    time = lab["t_sedfoam_s"] * LAB_V / LAB_H
    upper_lab, bed_lab = lab["y_upper_interface_m"], lab["y_bed_front_m"]
    series = [("measured", time, 1e3 * upper_lab, "dots"), (None, time, 1e3 * bed_lab, "dots")]
    for law in ("Gidaspow", "Beetstra"):
        folder = coupled.finished("pham-van-bang", f"pham-van-bang/{law}", "--no-pictures", "--set", f"drag={law}",
                                  limit=3000)
        # the contours at which the measurements are read
        t, upper, bed = fronts.fronts(folder, STEP, AREA, H, 0.25, 0.55)
        t, upper, bed = t * V / H, upper * LAB_H / H, bed * LAB_H / H
        shown = (time <= t[-1])
        both = shown & (time >= t[np.isfinite(bed)][0])
        miss = [float(np.sqrt(np.mean((np.interp(time[rows], t[np.isfinite(front)], front[np.isfinite(front)])
                                       - measured[rows])**2)))
                for front, measured, rows in ((upper, upper_lab, shown), (bed, bed_lab, both))]
        if law == "Gidaspow":
            checks.at_most(f"{law}: upper interface, rms [m] of 0.054", miss[0], 0.002)
            checks.at_most(f"{law}: bed front, rms [m] of 0.054", miss[1], 0.002)
            early = (time * LAB_H / LAB_V < 1100)
            mine = (t > time[0]) & (t < time[early][-1])
            speed = -np.polyfit(t[mine], upper[mine] / LAB_H, 1)[0]
            measured = -np.polyfit(time[early], upper_lab[early] / LAB_H, 1)[0]
            checks.close(f"{law}: speed of the upper interface over v_Stokes", float(speed), float(measured), 0.1)
        else:
            checks.at_least(f"{law}, too slow by its own drag: upper interface, rms [m]", miss[0], 0.001)
        style = "line" if law == "Gidaspow" else "dashed"
        series += [(law, t, 1e3 * upper, style), (None, t, 1e3 * bed, style)]
    checks.picture(plots.compare(
        os.path.join(coupled.RUNS, "pham-van-bang", "pham-van-bang.png"), series, "t v_Stokes/H",
        "height, scaled to 54 mm [mm]", "upper interface and bed front, solid fraction 0.5 at the start"))
