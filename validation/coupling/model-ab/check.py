# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Model A against model B: drop of a held bed, settling of a free one."""

import os

import numpy as np

from validation.lib.checks import coupled, fields, plots

TITLE = "model A against model B: pressure drop of a held bed, drift of a free one"


def _run(model, name, *settings):
    words = [w for s in (f"model={model}", *settings) for w in ("--set", s)]
    return coupled.finished("fixed-bed-scene", f"model-ab/{name}-{model}", *words)


def run(checks):
    drops, drifts = [], []
    for model in ("A", "B"):
        folder = _run(model, "held", "ramp=0.03", "end=0.04")
        t, p, u = fields.inlet(folder)
        drops.append((u[t > 0.008], 10 * p[t > 0.008]))
        folder = _run(model, "free", "held=0", "end=0.02", "velocity_from=0.008", "velocity_to=0.008",
                      "start_velocity=0.008")
        rise = coupled.columns(os.path.join(folder, "DEM", "rise.csv"))
        drifts.append((np.array(rise["time_s"]), np.array(rise["velocity_m_per_s"])))
    steady = [float(drop[0]) for _, drop in drops]
    checks.close("held: drop at a steady 0.002 m/s, B against A [Pa]", steady[1], steady[0], 1e-3)
    checks.at_most("held: drop over the ramp, largest difference over the largest drop",
                   float(np.max(abs(drops[1][1] - drops[0][1])) / drops[0][1].max()), 0.01)
    checks.close("free: inner spheres' velocity after 20 ms, B against A [m/s]", float(drifts[1][1][-1]),
                 float(drifts[0][1][-1]), 0.01)
    where = os.path.join(coupled.RUNS, "model-ab")
    checks.picture(plots.compare(os.path.join(where, "drop.png"),
                                 [("model A", *drops[0], "dashed"),
                                  ("model B", drops[1][0][::10], drops[1][1][::10], "dots")],
                                 "superficial velocity [m/s]", "drop over the bed [Pa]", "held bed, porosity 0.451"))
    checks.picture(plots.compare(os.path.join(where, "drift.png"),
                                 [("model A", *drifts[0], "dashed"), ("model B", *drifts[1], "dots")],
                                 "time [s]", "mean velocity upwards [m/s]", "the same spheres, let go below u_mf"))
