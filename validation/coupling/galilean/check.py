# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""One scene in two frames: a block of spheres that moves through a fluid at rest,
and the same with 0.1 m/s added to everything, through a periodic box."""

import os

import numpy as np

from cases.lib.output import spheres
from validation.lib.checks import coupled, plots

TITLE = "Galilean invariance: one scene in two frames of a periodic box"
LONG = True

FRAME, SPEED, LENGTH = 0.1, 0.05, 0.0576
MODELS = {"drag": ("pressureGradient", 0), "all": ("pressureGradient+addedMass+saffmanMei+magnus+torque", 100)}


def block(where, forces, spin, frame, cells):
    words = [w for s in ("bottom=cyclic", "top=cyclic", "gravity=0", f"forces={forces}", f"spin_y={spin}",
                         f"speed_z={SPEED + frame}", f"start_velocity={frame}", "across_x=6", "across_y=6",
                         "across_z=8", "origin_z=0.012", "stagger=1", "dem_step=2e-5", "coupling_steps=10",
                         f"cells_x={4 * cells}", f"cells_y={4 * cells}", f"cells_z={12 * cells}",
                         "end=0.04", "frames=4", "smoothing=diffusion", "bandwidth=6e-3")
             for w in ("--set", s)]
    folder = coupled.finished("lattice-scene", os.path.join("galilean", where), "--no-pictures", *words)
    last = spheres.read(spheres.dumps(folder)[-1][1])
    m = coupled.columns(os.path.join(folder, "DEM", "means.csv"))
    order = np.argsort(last["id"])
    mass = 288 * 2600 * 4 / 3 * np.pi * 1e-9
    return (np.array([last[k][order] for k in ("x", "y", "z")]), np.array([last[k][order] for k in ("vx", "vy", "vz")]),
            np.array(m["t"]), np.array(m["pz"]) / mass)


def frames(name, cells):
    """(difference of the mean speeds at the end, of the places, of the velocities; speed lost; curves)"""
    forces, spin = MODELS[name]
    x, v, t, mean = block(f"{name}-{cells}-rest", forces, spin, 0.0, cells)
    y, w, _, other = block(f"{name}-{cells}-moving", forces, spin, FRAME, cells)
    apart = y - x - np.array([[0], [0], [FRAME * t[-1]]])
    apart[2] = (apart[2] + LENGTH / 2) % LENGTH - LENGTH / 2  # to the nearest image
    travelled = np.sum(mean) * (t[1] - t[0])
    lost = SPEED - mean[-1]
    drift = w - v - np.array([[0], [0], [FRAME]])
    return (float(abs(other[-1] - FRAME - mean[-1]) / lost), float(np.sqrt((apart**2).sum(axis=0).mean()) / travelled),
            float(np.sqrt((drift**2).sum(axis=0).mean()) / lost), float(lost / SPEED), (t, mean, other - FRAME))


def run(checks):
    lines = []
    checks.note("The frames differ by about 2 % of the speed lost. Neither finer cells nor a shorter coupling interval "
                "(0.1 to 0.4 ms) takes that away; its cause is not found.")
    for name in MODELS:
        coarse, fine = frames(name, 1), frames(name, 2)
        checks.at_least(f"{name}: speed lost to the fluid, of the start's", fine[3], 0.1)
        checks.at_most(f"{name}: mean speed in both frames, difference over the speed lost", fine[0], 0.03)
        checks.at_most(f"{name}: places in both frames, root mean square over the way travelled", fine[1], 0.015)
        checks.at_most(f"{name}: velocities in both frames, root mean square over the speed lost", fine[2], 0.05)
        checks.close(f"{name}: order in the mesh of the difference of the mean speeds",
                     float(np.log2(coarse[0] / fine[0])), 1.0, 0.35)
        checks.at_most(f"{name}: that difference, extrapolated to fine meshes", abs(2 * fine[0] - coarse[0]), 0.01)
        t, mean, other = fine[4]
        lines += [(f"{name}, fluid at rest", t, mean, "line"), (f"{name}, all at 0.1 m/s more", t, other, "dashed")]
    checks.picture(plots.compare(os.path.join(coupled.RUNS, "galilean", "galilean.png"), lines, "t [s]",
                                 "mean speed against the frame [m/s]", "a block of spheres in two frames"))
