# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Chung and Ooi's tests 1 and 2: elastic impacts of two spheres, and of one on a rigid wall."""

import os

import numpy as np

from validation.lib.checks import coupled, plots, reference

TITLE = "elastic impacts by Hertz's law: force, overlap, duration"


def run(checks):
    r = reference.table("chung_ooi2011_test1_2_hertz")
    curves = []
    for k, material in enumerate(r["material"]):
        wall, speed, radius, tc = int(r["test"][k] == 2), r["v_rel_m_per_s"][k], r["radius_m"][k], r["t_contact_s"][k]
        folder = coupled.dem("hertz-impact", f"hertz-impact/{material}", wall=wall, young=repr(r["E_Pa"][k]),
                             poisson=r["nu"][k], density=r["rho_kg_per_m3"][k], radius=radius, speed=speed,
                             dt=repr(tc / 2000), steps=2200)
        t = {key: np.array(v) for key, v in
             coupled.columns(os.path.join(folder, "DEM", "trajectory.csv")).items()}
        share = 1 if wall else 2   # of the overlap, and of the approach, that one sphere sees
        overlap = share * (radius - t["x_m"])
        inside = np.flatnonzero(overlap > 0)
        first, last = inside[0], inside[-1]
        begin = np.interp(0, overlap[first - 1:first + 1], t["time_s"][first - 1:first + 1])
        end = np.interp(0, overlap[last + 1:last - 1:-1], t["time_s"][last + 1:last - 1:-1])
        name = f"test {r['test'][k]:.0f}, {material}"
        checks.close(f"{name}: largest force [N]", t["f_N"].max(), r["F_max_N"][k], 0.01)
        checks.close(f"{name}: largest overlap [m]", overlap.max(), r["delta_max_m"][k], 0.01)
        checks.close(f"{name}: duration [s]", end - begin, tc, 0.01)
        checks.close(f"{name}: speed after [m/s]", share * t["v_m_per_s"][-1], speed, 0.01)
        some = slice(first, last, 60)
        curves += [(name, overlap[some] / r["delta_max_m"][k], t["f_N"][some] / r["F_max_N"][k], "dots")]
    d = np.linspace(0, 1, 100)
    curves += [("Hertz", d, d ** 1.5, "dashed")]
    checks.picture(plots.compare(os.path.join(coupled.RUNS, "hertz-impact", "force.png"), curves,
                                 "overlap / its largest by theory", "force / its largest by theory",
                                 "elastic impacts, in and out"))
