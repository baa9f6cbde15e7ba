# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Random insertion: one particle after the other, each at the first random place
where none of its spheres touches another particle or the tube."""

import numpy as np
from scipy.spatial import cKDTree

from cases.lib.packing.pack_shapes import NotPacked, pairs, random_turns

GAP = 1e-6        # room left between two spheres, of a diameter
_BATCH = 4000     # places tried at once; that they are many at once changes nothing
_IN_VAIN = 100000  # places tried since the last one that was free


def place(shape, count, tube, seed, say):
    """Centres and rotations of `count` particles; NotPacked if not all find room."""
    rng = np.random.default_rng(seed)
    apart = 2 * shape.radius * (1 + GAP)
    x, q = np.empty((0, 3)), np.empty((0, 4))
    tried = vain = 0
    while len(x) < count:
        new_x, new_q = _inside(shape, tube, rng)
        tried += _BATCH
        free = _free(shape, x, q, new_x, new_q, apart)
        new_x, new_q = new_x[free], new_q[free]
        chosen = _compatible(shape, new_x, new_q, apart)[:count - len(x)]
        vain = 0 if len(chosen) else vain + _BATCH
        x, q = np.concatenate([x, new_x[chosen]]), np.concatenate([q, new_q[chosen]])
        say(f"{len(x)} of {count} inserted, {tried} places tried")
        if vain >= _IN_VAIN and len(x) < count:
            raise NotPacked(len(x) / count, f"none of the last {vain} places tried was free")
    return x, q


def _inside(shape, tube, rng):
    """Random particles wholly in the tube."""
    x = tube.centres(rng, _BATCH, shape.radius)
    q = random_turns(rng, _BATCH)
    out = tube.beyond(shape.spheres(x, q), shape.radius).reshape(_BATCH, -1).max(axis=1)
    return x[out == 0], q[out == 0]


def _free(shape, x, q, new_x, new_q, apart):
    """Which of the new ones touch none of those that are there."""
    free = np.ones(len(new_x), dtype=bool)
    if len(x) == 0:
        return free
    tree = cKDTree(shape.spheres(x, q))
    # few spheres first: most places are refused by any of them
    n = len(shape.centres)
    for some in (slice(0, n, 7), slice(0, n)):
        left = np.flatnonzero(free)
        if len(left) == 0:
            break
        points = shape.spheres(new_x[left], new_q[left]).reshape(-1, n, 3)[:, some]
        near = tree.query(points.reshape(-1, 3), distance_upper_bound=apart)[0]
        free[left] = np.isinf(near).reshape(len(left), -1).all(axis=1)
    return free


def _compatible(shape, x, q, apart):
    """Indices of those that do not touch an earlier one that is kept."""
    n = len(shape.centres)
    met = np.unique(pairs(shape.spheres(x, q), apart, n) // n, axis=0) if len(x) else np.empty((0, 2), int)
    kept = np.ones(len(x), dtype=bool)
    for i, j in sorted((min(p), max(p)) for p in met.tolist()):
        if kept[i]:
            kept[j] = False
    return np.flatnonzero(kept)
