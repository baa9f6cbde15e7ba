# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Momentum of particles and fluid together, through both programs: a block of
spheres shoots through a fluid at rest in a box that is periodic all around."""

import os

import numpy as np

from validation.lib.checks import coupled, momenta, plots

TITLE = "momentum of particles and fluid in a periodic box, both programs, each force model"

RHO, BOX, CELLS = 1000.0, (0.0192, 0.0192, 0.0576), 192
RUNS = {
    "drag": ["forces=pressureGradient"],
    "all": ["forces=pressureGradient+viscous+addedMass+saffmanMei+magnus+torque", "spin_y=100"],
    "light": ["forces=pressureGradient+addedMass", "density=50", "across_z=16"],
    "modelB": ["model=B", "forces=addedMass", "density=500"],
    "lag": ["forces=pressureGradient+viscous", "answer_lag=7"],
    "first": ["forces=pressureGradient+addedMass", "overlap=no"],
    "flux": ["forces=pressureGradient+viscous", "ddt_void_fraction=particleFlux"],
    "centre": ["forces=pressureGradient", "void_fraction=centre"],
    "kernel": ["forces=pressureGradient+addedMass", "smoothing=diffusion", "bandwidth=6e-3"],
}
SCENE = ["bottom=cyclic", "top=cyclic", "gravity=0", "speed_z=0.05", "speed_x=0.03", "across_x=6",
         "across_y=6", "across_z=8", "origin_z=0.012", "stagger=1", "dem_step=2e-5", "coupling_steps=10",
         "end=0.02", "frames=4"]


def run(checks):
    lines = []
    for name, settings in RUNS.items():
        words = [w for s in SCENE + settings for w in ("--set", s)]
        folder = coupled.finished("lattice-scene", os.path.join("momentum", name), "--no-pictures", *words)
        rows = momenta.momenta(folder, RHO, BOX, CELLS)
        density = next((float(s.split("=")[1]) for s in settings if s.startswith("density")), 2600.0)
        count = 36 * next((int(s.split("=")[1]) for s in settings if s.startswith("across_z")), 8)
        start = count * density * 4 / 3 * np.pi * 1e-9 * np.array([0.03, 0.0, 0.05])
        size = np.linalg.norm(start)
        drift = float(np.max([np.linalg.norm(p + f + owed - start) for _, p, f, owed in rows])) / size
        checks.at_most(f"{name}: drift of the sum of both momenta, over the start's", drift, 1e-10)
        checks.at_least(f"{name}: part of the momentum that changed hands",
                        np.linalg.norm(rows[-1][2]) / size, 0.02)
        checks.at_most(f"{name}: largest residual of the ledger",
                       coupled.summary(folder)["max_momentum_residual"], 1e-10)
        if name == "all":
            t = [r[0] for r in rows]
            for k, axis in ((0, "x"), (2, "z")):
                lines += [(f"particles, {axis}", t, [r[1][k] / size for r in rows], "dots"),
                          (f"fluid, {axis}", t, [(r[2] + r[3])[k] / size for r in rows], "dots"),
                          (f"both, {axis}", t, [(r[1] + r[2] + r[3])[k] / size for r in rows], "line")]
    checks.picture(plots.compare(os.path.join(coupled.RUNS, "momentum", "momentum.png"), lines, "t [s]",
                                 "momentum over that of the start", "what the spheres lose, the fluid gains"))
