# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Head-on impacts of two spheres: restitution, duration and overlap of a linear contact."""

import os

import numpy as np

from validation.lib.checks import coupled, plots, reference

TITLE = "a linear contact's restitution, duration, overlap"
DIAMETER, SPEED = 1e-4, 0.01


def impact(where, **variables):
    """(restitution, duration [s], largest overlap [m], time [s], gap [m])"""
    folder = coupled.dem("restitution", where, **variables)
    t = {k: np.array(v) for k, v in coupled.columns(os.path.join(folder, "DEM", "trajectory.csv")).items()}
    gap = t["x2_m"] - t["x1_m"] - DIAMETER
    inside = np.flatnonzero(gap < 0)
    first, last = inside[0], inside[-1]
    cross = [np.interp(0, [gap[i + 1], gap[i]], [t["time_s"][i + 1], t["time_s"][i]]) if k == 0 else
             np.interp(0, [gap[i], gap[i + 1]], [t["time_s"][i], t["time_s"][i + 1]])
             for k, i in enumerate((first - 1, last))]
    apart = t["v2_m_per_s"] - t["v1_m_per_s"]
    return -apart[-1] / apart[0], cross[1] - cross[0], -gap.min(), t["time_s"] - cross[0], gap


def run(checks):
    r = reference.table("hooke_lsd_restitution_formula")
    curves = []
    for k, e in enumerate(r["e_target"]):
        m, kn, gamma, tc = r["m_star_kg"][k], r["k_n_N_per_m"][k], r["gamma_n_kg_per_s"][k], r["t_c_s"][k]
        w = np.sqrt(kn / m - (gamma / 2 / m) ** 2)
        # overlap where its rate is zero
        late = np.arctan2(w, gamma / 2 / m) / w
        deepest = SPEED / w * np.exp(-gamma / 2 / m * late) * np.sin(w * late)
        for stock, name in enumerate(("gran/lean", "gran hooke")):
            found, lasts, depth, time, gap = impact(
                f"restitution/{name.replace('/', '-').replace(' ', '-')}-{e:g}", stock=stock, e=e, kn=repr(kn),
                gamman=repr(gamma / m),
                dt=repr(tc / 2000), steps=2200)
            checks.close(f"{name}, e = {e:g}: restitution", found, e, 0.01)
            checks.close(f"{name}, e = {e:g}: duration [s]", lasts, tc, 0.01)
            checks.close(f"{name}, e = {e:g}: largest overlap [m]", depth, deepest, 0.01)
        short = slice(0, len(time), 40)
        exact = np.linspace(0, tc, 200)
        curves += [(f"e = {e:g}", time[short] * 1e6, -gap[short] * 1e6, "dots"),
                   ("formula" if k == 0 else None, exact * 1e6,
                    1e6 * SPEED / w * np.exp(-gamma / 2 / m * exact) * np.sin(w * exact), "dashed")]
    checks.picture(plots.compare(os.path.join(coupled.RUNS, "restitution", "overlap.png"), curves,
                                 "time since touch [us]", "overlap [um]", "two spheres, linear contact: overlap"))
