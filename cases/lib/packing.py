# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Random places for the clumps, the same on any number of ranks."""

import math
import os
import random

from casefile import CaseError, text

_TRIES = 20000


def bounding_radius(sphere, layers):
    """Radius [m] of the sphere around a clump of two layers of seven spheres."""
    return math.hypot(2 * sphere, 0.5 * layers) + sphere


def _rotation(rng):
    """A rotation drawn uniformly, as a quaternion."""
    a, b, c = rng.random(), 2 * math.pi * rng.random(), 2 * math.pi * rng.random()
    s, t = math.sqrt(1 - a), math.sqrt(a)
    return s * math.sin(b), s * math.cos(b), t * math.sin(c), t * math.cos(c)


def places(count, around, radius, height, seed):
    """Centres and rotations of clumps that touch neither each other nor the tube."""
    rng = random.Random(seed)
    found = []
    for _ in range(count):
        for _ in range(_TRIES):
            x, y = (rng.uniform(-1, 1) * (radius - around) for _ in range(2))
            z = rng.uniform(around, height - around)
            if math.hypot(x, y) <= radius - around and all(
                    (x - p[0]) ** 2 + (y - p[1]) ** 2 + (z - p[2]) ** 2 >= 4 * around ** 2
                    for p, _ in found):
                found.append(((x, y, z), _rotation(rng)))
                break
        else:
            raise CaseError(f"clumps = {count}: only {len(found)} find room in the tube of radius "
                            f"{text(radius)} m and height {text(height)} m")
    return found


def write(folder, v):
    """packing.liggghts: puts every clump of the case in its place.

    Illite and kaolinite in the asked share, at random; templates ill and kao.
    """
    count = int(v["clumps"])
    around = bounding_radius(v["sphere_radius"], v["layer_spacing"])
    if count < 1:
        raise CaseError(f"clumps = {v['clumps']}: at least one is wanted")
    if not 0 <= v["illite_share"] <= 1:
        raise CaseError(f"illite_share = {v['illite_share']}: a number from 0 to 1 is wanted")
    found = places(count, 1.01 * around, v["tube_radius"], v["tube_height"], v["seed"])
    illite = math.floor(count * v["illite_share"] + 0.5)
    kinds = ["ill"] * illite + ["kao"] * (count - illite)
    random.Random(v["seed"]).shuffle(kinds)

    # LIGGGHTS's own random numbers decide nothing here
    point = 1e-10  # [m], half the side of the box a centre falls into
    with open(os.path.join(folder, "packing.liggghts"), "w", encoding="utf-8") as f:
        f.write("# This file is made by cases/run: a place for every clump\n")
        for kind in sorted(set(kinds)):
            f.write(f"fix only_{kind} all particledistribution/discrete/numberbased 10037 1 {kind} 1.\n")
        for i, ((xyz, q), kind) in enumerate(zip(found, kinds)):
            box = " ".join(f"{c - point:.12g} {c + point:.12g}" for c in xyz)
            f.write(f"region at{i} block {box} units box volume_limit 1e-40\n"
                    f"fix put{i} all insert/pack seed 10039 distributiontemplate only_{kind} "
                    f"insert_every once overlapcheck no all_in no verbose no "
                    f"orientation constant {' '.join(f'{c:.12g}' for c in q)} "
                    f"region at{i} warn_region no ntry_mc 1000 particles_in_region 1\n")
        f.write("run 1\n")
        f.writelines(f"unfix put{i}\nregion at{i} delete\n" for i in range(count))
