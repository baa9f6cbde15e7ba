# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A sphere as dense as the fluid stays where it is, in either model."""

import os

import numpy as np

from validation.lib.checks import plots, single_sphere
from validation.lib.checks.coupled import RUNS, summary

TITLE = "a neutrally buoyant sphere stays, and goes with a stream"


def run(checks):
    series = []
    for name, more in (("A", {}), ("B", {"model": "B"}), ("A, corrected", {"self_disturbance": "latticeMemory"})):
        folder = single_sphere.run("neutral-sphere/" + name.replace(", ", "-"), density=1000, end=1.0, dem_step=1e-4,
                                   coupling_steps=10, frames=2, curve_rows=200, sphere_radius=1e-3, **more)
        t, z, v = single_sphere.path(folder)
        checks.at_most(f"model {name}: way in 1 s over the diameter", float(np.max(np.abs(z - z[0]))) / 2e-3, 1e-6)
        checks.at_most(f"model {name}: momentum residual", summary(folder)["max_momentum_residual"], 1e-10)
        series.append((f"model {name}", t, z - z[0], "line"))
    # at rest in a stream it takes the stream's velocity
    folder = single_sphere.run("neutral-sphere/stream", density=1000, end=1.0, dem_step=1e-4, coupling_steps=10,
                               frames=2, curve_rows=200, sphere_radius=5e-4, size_z=0.1, cells_z=40, sides="slip",
                               bottom="inlet", inlet_velocity=0.02, start_velocity=0.02, at_z=0.3,
                               self_disturbance="latticeMemory")
    t, z, v = single_sphere.path(folder)
    checks.close("in a stream: velocity over the stream's", float(v[-1]) / 0.02, 1.0, 0.01)
    series.append(("in a stream of 0.02 m/s", t, z - z[0], "line"))
    checks.picture(plots.compare(os.path.join(RUNS, "neutral-sphere", "way.png"), series, "time / s", "way up / m",
                                 TITLE))
