# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A bed at rest: no drag, the floor carries the buoyant weight, no flow."""

import math
import os

import numpy as np

from validation.lib.checks import coupled, fields, plots

TITLE = "bed at rest: zero drag, the floor carries the buoyant weight, hydrostatics"
LONG = True

_WEIGHT = 400 * math.pi / 6 * 1e-9 * (2500 - 1000) * 9.81  # buoyant weight [N]
_AREA = 1e-4                                               # of the box [m2]
_FALL = 0.1                                                # m/s, about a sphere's terminal velocity


def _flow(folder):
    """Largest speed of the fluid [m/s] and dynamic pressure [Pa] at the end."""
    cells = len(fields.centres(folder))
    at = fields.times(folder)[-1][1]
    speed = np.linalg.norm(fields.field(at, "U", cells), axis=1)
    p = fields.field(at, "p", cells)
    return float(speed.max()), float(1000.0 * np.ptp(p))


def run(checks):
    curves = []
    for name, model, top in (("model A, open", "A", "open"), ("model B, closed", "B", "wall")):
        folder = coupled.finished("bed-at-rest", "bed-at-rest/" + model, "--set", f"model={model}", "--set",
                                  f"top={top}")
        rows = coupled.columns(os.path.join(folder, "DEM", "floor.csv"))
        t, push = np.array(rows["time_s"]), np.array(rows["floor_N"])
        late = float(push[t > 0.15].mean())
        checks.close(f"{name}: force on the floor [N]", late, _WEIGHT, 1e-3)
        speed, p = _flow(folder)
        checks.at_most(f"{name}: largest velocity of the fluid over {_FALL} m/s", speed / _FALL, 1e-2)
        checks.at_most(f"{name}: dynamic pressure over the bed's buoyant weight an area", p / (_WEIGHT / _AREA), 1e-3)
        checks.at_most(f"{name}: momentum residual", coupled.summary(folder)["max_momentum_residual"], 1e-10)
        curves.append((name, t, push / _WEIGHT, "line"))
        # spheres as heavy as the fluid, none touching: gravity and buoyancy cancel
        words = [w for x in (f"model={model}", f"top={top}", "bottom=wall", "held=0", "fluid_density=2000",
                             "velocity_from=0",
                             "velocity_to=0", "end=0.02") for w in ("--set", x)]
        still = coupled.finished("fixed-bed-scene", "bed-at-rest/neutral-" + model, *words)
        speed, p = _flow(still)
        checks.at_most(f"{name}, spheres as heavy as the fluid: largest velocity of the fluid [m/s]", speed, 1e-14)
        checks.at_most(f"{name}, the same: dynamic pressure [Pa]", p, 1e-10)
        drift = coupled.columns(os.path.join(still, "DEM", "rise.csv"))["velocity_m_per_s"]
        checks.at_most(f"{name}, the same: velocity of the spheres [m/s]", float(np.max(np.abs(drift))), 1e-14)
    checks.picture(plots.compare(os.path.join(coupled.RUNS, "bed-at-rest", "floor.png"), curves, "time [s]",
                                 "force on the floor over the buoyant weight", "a bed that lies still, in water"))
