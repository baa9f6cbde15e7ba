# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Free clumps, larger than a cell, that fall at intervals of many relaxation times: a run of
stress-scene, and the mean velocity of what its dumps hold."""

import os

import numpy as np

from validation.lib.checks import coupled, fronts
from validation.lib.checks.verdicts import Broken
from validation.lib.stress import stress_run

STEPS, FRAMES = 8000, 4
POINT = {"diameter": 1e-4, "density_ratio": 2.65, "viscosity": 1e-2, "solids": 0.07, "stiffness": 5.0,
         "step_ratio": 0.5, "interval_ratio": 1.0, "charge_factor": 0.0, "cell": 2.4, "jump": 0.0,
         "shape": "clumps", "drag": "Beetstra", "scheme": "exactOverlap", "model": "A", "overlap": "yes",
         "sides": "cyclic"}


def velocity(where, every, **more):
    """Mean vertical velocity [m/s] of the clumps over the last quarter of a run that is
    coupled every so many steps of 2 us, and the relaxation times of such an interval."""
    folder = os.path.join(coupled.RUNS, where)
    step = 2e-6
    _, run = stress_run.make({**POINT, **more}, folder, dem_step=step, coupling_steps=every,
                             end=step * STEPS, frames=FRAMES)
    status, why = stress_run.execute(run)
    if status != 0:
        raise Broken(f"{where}: {why or 'hung'}")
    z = {round(t / (step * STEPS) * FRAMES): np.mean(z) for t, z, _ in fronts.dumps(folder, step)}
    return ((z[FRAMES] - z[FRAMES - 1]) / (step * STEPS / FRAMES),
            coupled.cfd(folder)["interval_over_relaxation_max"])
