# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres in a box, evenly at random: thrown in, as many in one height as in
another, then pushed apart by springs until none overlaps, first as larger
spheres so that none crowd."""

import numpy as np
from scipy.spatial import cKDTree

from cases.lib.packing.pack_shapes import NotPacked

MARGIN = 1e-3    # spheres are packed this much too large, so that no overlap is left
STIRRED = 0.45   # solid fraction at which thinner suspensions are pushed apart
_STEPS = 4000


def place(radius, count, size, cyclic, seed, say):
    """Centres, shape (count, 3), in the box from 0 to `size` [m]; cyclic: the
    upright sides are periodic, else walls. NotPacked if they do not come apart."""
    size = np.asarray(size, dtype=float)
    fraction = count * 4 / 3 * np.pi * radius**3 / np.prod(size)
    large = radius * (1 + MARGIN) * max(1.0, (STIRRED / fraction)**(1 / 3))
    # at the walls they keep only their own distance
    wall = np.array([0.0 if cyclic else radius * (1 + MARGIN)] * 2 + [radius * (1 + MARGIN)])
    rng = np.random.default_rng(seed)
    x = rng.uniform(wall, size - wall, (count, 3))
    # as many in one height as in another
    x[:, 2] = wall[2] + (np.arange(count) + rng.uniform(size=count)) / count * (size[2] - 2 * wall[2])
    x, left = _relax(x, large, wall, size, cyclic, 0.05 * radius if large > 1.01 * radius else MARGIN * radius, say)
    x, left = _relax(x, radius * (1 + MARGIN), wall, size, cyclic, MARGIN * radius, say)
    if left > 2 * MARGIN * radius:
        raise NotPacked(1 - left / radius, "the spheres jam")
    return x


def overlap(x, radius, size, cyclic):
    """The largest overlap of two spheres over their diameter, 0 if none touch."""
    x, box = x.copy(), None
    if cyclic:
        x[:, :2] %= size[:2]
        box = [size[0], size[1], 0.0]
    near = cKDTree(x, boxsize=box).query(x, 2)[0][:, 1].min() if len(x) > 1 else np.inf
    return max(0.0, 1 - near / (2 * radius))


def _relax(x, radius, wall, size, cyclic, goal, say):
    """Steps down the springs' energy (FIRE, Bitzek and others, Phys. Rev. Lett. 97,
    170201, 2006) until no overlap is above goal; the places and the overlap left."""
    box = np.array([size[0], size[1], 0.0]) if cyclic else None
    v, step, mixing, good, at = np.zeros_like(x), 0.1, 0.1, 0, None
    for k in range(_STEPS):
        if cyclic:
            x[:, :2] %= size[:2]
        if at is None or np.abs(x - at).max() > 0.2 * radius:
            ij = cKDTree(x, boxsize=box).query_pairs(2.7 * radius, output_type="ndarray")
            at = x.copy()
        i, j = ij.T
        d = x[i] - x[j]
        if cyclic:
            d[:, :2] -= size[:2] * np.round(d[:, :2] / size[:2])
        far = np.sqrt((d * d).sum(1))
        depth = np.maximum(2 * radius - far, 0)
        push = d * (depth / np.maximum(far, 1e-12 * radius))[:, None]
        f = np.empty_like(x)
        for c in range(3):
            f[:, c] = np.bincount(i, push[:, c], len(x)) - np.bincount(j, push[:, c], len(x))
        out = np.maximum(wall - x, 0) - np.maximum(x - (size - wall), 0)
        if cyclic:
            out[:, :2] = 0
        f += out
        left = max(depth.max(initial=0), np.abs(out).max())
        if left <= goal:
            break
        if k % 50 == 0:
            say(f"overlap left {left / (2 * radius):.1e} d")
        power = (f * v).sum()
        if power > 0:
            v = (1 - mixing) * v + mixing * np.sqrt((v * v).sum() / (f * f).sum()) * f
            good += 1
            if good > 5:
                step, mixing = min(1.1 * step, 0.5), 0.99 * mixing
        else:
            v[:] = 0
            step, mixing, good = 0.5 * step, 0.1, 0
        v += step * f
        move = step * v
        move /= max(1.0, np.abs(move).max() / (0.3 * radius))
        x = x + move
    return x, left
