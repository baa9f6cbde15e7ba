# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Brownian spheres: diffusion at kT/K for steps short and long, temperature, nothing between windows."""

import glob
import os

import numpy as np

from validation.lib.checks import coupled, plots

TITLE = "Brownian motion: diffusion at kT/K for any step"
K_B, T, MU, A = 1.380649e-23, 293.0, 1e-3, 1e-6
K, MASS = 6 * np.pi * MU * A, 2600 * 4 / 3 * np.pi * A ** 3
RELAX, D = MASS / K, K_B * T / K


def frames(folder, columns=8):
    """Rows of the dumps in the order of time: array of shape (times, spheres, columns)."""
    names = glob.glob(os.path.join(folder, "DEM", "spheres.*.dump"))
    names.sort(key=lambda n: int(n.split(".")[-2]))
    found = []
    for name in names:
        with open(name, encoding="utf-8") as f:
            found.append(np.fromstring(f.read().split("\n", 9)[9], sep=" ").reshape(-1, columns))
    return np.array(found)


def run(checks):
    curves = []
    for part, steps, windows in ((0.1, 100, 9), (1.0, 20, 9), (30.0, 5, 9)):
        dt = part * RELAX
        folder = coupled.dem("brownian-diffusion", f"brownian-diffusion/{part:g}", side=16, a=A, mu=MU, T=T, seed=7,
                             dt=repr(dt), settle=int(6 / part) + 6, steps=steps, windows=windows)
        f = frames(folder)
        name = f"step {part:g} relaxation times"
        moved = np.diff(f[:, :, 1:4], axis=0)
        # in discrete time a velocity with memory q = exp(-dt/relax)
        q, n = np.exp(-part), steps
        wanted = 2 * D * dt * (n - 2 * q * (1 - q ** n) / (1 - q * q))
        checks.close(f"{name}: mean square displacement of {steps} steps [m2]", np.mean(moved ** 2), wanted, 0.01)
        # over all of the run: no window knows of another
        far, all_steps = f[-1, :, 1:4] - f[0, :, 1:4], steps * (len(f) - 1)
        checks.close(f"{name}: diffusion coefficient [m2/s]", np.mean(far ** 2) / (2 * dt)
                     / (all_steps - 2 * q * (1 - q ** all_steps) / (1 - q * q)), D, 0.03)
        checks.at_most(f"{name}: mean displacement over its deviation",
                       np.max(np.abs(far.mean(axis=0))) / np.sqrt(2 * D * all_steps * dt / f.shape[1]), 4)
        if part < 1:
            # velocities at whole steps are means of two: low by half a step's loss
            for kind, y, energy in (("kinetic temperature", part, MASS * f[:, :, 4:7] ** 2),
                                    ("temperature of the spin", part / 0.3, 0.4 * MASS * A * A * f[:, :, 7] ** 2)):
                seen = np.tanh(y / 2) / (y / 2) * (1 + np.exp(-y)) / 2
                checks.close(f"{name}: {kind} [K]", np.mean(energy) / K_B / seen, T, 0.01)
        times = np.arange(1, len(f)) * steps * dt
        square = [np.mean((f[k:, :, 1:4] - f[:-k, :, 1:4]) ** 2) for k in range(1, len(f))]
        curves += [(name, times / RELAX, np.array(square) / (2 * D * RELAX), "dots")]
    # through both programs: K is what the CFD half's drag law says, in a fluid that gets every reaction
    folder = coupled.finished("brownian-scene", "brownian-diffusion/coupled", "--no-pictures")
    f = frames(folder, 12)
    dt, steps = 6e-7, 200
    q = np.exp(-dt / RELAX)
    moved = np.diff(f[:, :, 9:12], axis=0)
    checks.close("coupled: mean square displacement of 200 steps [m2]", np.mean(moved[1:] ** 2),
                 2 * D * dt * (steps - 2 * q * (1 - q ** steps) / (1 - q * q)), 0.01)
    checks.at_most("coupled: max_momentum_residual", coupled.summary(folder)["max_momentum_residual"], 1e-10)
    square = [np.mean((f[k + 1:, :, 9:12] - f[1:-k, :, 9:12]) ** 2) for k in range(1, len(f) - 1)]
    curves += [("coupled, step 1 relaxation time", np.arange(1, len(f) - 1) * steps * dt / RELAX,
                np.array(square) / (2 * D * RELAX), "dots")]
    x = np.geomspace(5, 2000, 50)
    curves += [("2 D (t - relaxation time)", x, x - 1 + np.exp(-x), "dashed")]
    checks.picture(plots.compare(os.path.join(coupled.RUNS, "brownian-diffusion", "displacement.png"), curves,
                                 "time over relaxation time", "mean square displacement over 2 D m/K",
                                 "Brownian spheres, 4096 of 2 um", logx=True, logy=True))
