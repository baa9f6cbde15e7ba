# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""One scene in two frames: a block of spheres that moves through a fluid at rest,
and the same with 0.1 m/s added to everything, through a periodic box; and the
block that moves with its fluid."""

import os

import numpy as np

from cases.lib.output import spheres
from validation.lib.checks import coupled, momenta, plots

TITLE = "Galilean invariance: one scene in two frames of a periodic box, a block that moves with its fluid"
LONG = True

FRAME, SPEED, LENGTH = 0.1, 0.05, 0.0576
RHO, BOX = 1000.0, (0.0192, 0.0192, LENGTH)
MODELS = {"drag": ("pressureGradient", 0), "all": ("pressureGradient+addedMass+saffmanMei+magnus+torque", 100)}
CELLS = {1: "cells of 4.8 mm", 2: "cells of 2.4 mm"}
MASS = 288 * 2600 * 4 / 3 * np.pi * 1e-9


def block(where, forces, spin, speed, fluid, cells):
    """(places, velocities, times, mean speeds, drift of both momenta) of a block of that speed [m/s] in that fluid."""
    words = [w for s in ("bottom=cyclic", "top=cyclic", "gravity=0", f"forces={forces}", f"spin_y={spin}",
                         f"speed_z={speed}", f"start_velocity={fluid}", "across_x=6", "across_y=6",
                         "across_z=8", "origin_z=0.012", "stagger=1", "dem_step=2e-5", "coupling_steps=10",
                         f"cells_x={4 * cells}", f"cells_y={4 * cells}", f"cells_z={12 * cells}",
                         "end=0.04", "frames=4", "smoothing=diffusion", "bandwidth=9.6e-3")
             for w in ("--set", s)]
    folder = coupled.finished("lattice-scene", os.path.join("galilean", where), "--no-pictures", *words)
    last = spheres.read(spheres.dumps(folder)[-1][1])
    m = coupled.columns(os.path.join(folder, "DEM", "means.csv"))
    order = np.argsort(last["id"])
    count = 192 * cells**3
    start = MASS * speed + RHO * fluid * (np.prod(BOX) - MASS / 2600)
    drift = max(abs(p[2] + f[2] + owed[2] - start) for _, p, f, owed in momenta.momenta(folder, RHO, BOX, count))
    return (np.array([last[k][order] for k in ("x", "y", "z")]), np.array([last[k][order] for k in ("vx", "vy", "vz")]),
            np.array(m["t"]), np.array(m["pz"]) / MASS, drift / (MASS * SPEED))


def frames(name, cells):
    """(difference of the mean speeds at the end, of the places, of the velocities; speed lost; curves; momentum)"""
    forces, spin = MODELS[name]
    x, v, t, mean, kept = block(f"{name}-{cells}-rest", forces, spin, SPEED, 0.0, cells)
    y, w, _, other, moving = block(f"{name}-{cells}-moving", forces, spin, SPEED + FRAME, FRAME, cells)
    apart = y - x - np.array([[0], [0], [FRAME * t[-1]]])
    apart[2] = (apart[2] + LENGTH / 2) % LENGTH - LENGTH / 2  # to the nearest image
    travelled = np.sum(mean) * (t[1] - t[0])
    lost = SPEED - mean[-1]
    drift = w - v - np.array([[0], [0], [FRAME]])
    return (float(abs(other[-1] - FRAME - mean[-1]) / lost), float(np.sqrt((apart**2).sum(axis=0).mean()) / travelled),
            float(np.sqrt((drift**2).sum(axis=0).mean()) / lost), float(lost), (t, mean, other - FRAME),
            float(max(kept, moving)))


def run(checks):
    lines = []
    for name in MODELS:
        for cells, size in CELLS.items():
            found = frames(name, cells)
            say = f"{name}, {size}: "
            checks.at_least(say + "speed lost to the fluid, of the start's", found[3] / SPEED, 0.1)
            checks.at_most(say + "mean speed in both frames, difference over the speed lost", found[0], 0.005)
            checks.at_most(say + "places in both frames, root mean square over the way travelled", found[1], 0.015)
            checks.at_most(say + "velocities in both frames, root mean square over the speed lost", found[2], 0.05)
            checks.at_most(say + "drift of the sum of both momenta, over the block's", found[5], 1e-10)
            *_, speeds, kept = block(f"{name}-{cells}-together", MODELS[name][0], 0, FRAME, FRAME, cells)
            checks.at_most(say + "block that moves with its fluid, change of its speed over the speed lost",
                           float(np.max(np.abs(speeds - FRAME))) / found[3], 0.001)
            checks.at_most(say + "block that moves with its fluid, drift of the sum of both momenta", kept, 1e-10)
        t, mean, other = found[4]
        lines += [(f"{name}, fluid at rest", t, mean, "line"), (f"{name}, all at 0.1 m/s more", t, other, "dashed")]
    checks.picture(plots.compare(os.path.join(coupled.RUNS, "galilean", "galilean.png"), lines, "t [s]",
                                 "mean speed against the frame [m/s]", "a block of spheres in two frames"))
