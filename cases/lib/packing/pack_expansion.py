# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Radial expansion: particles begin small, inserted at random, and grow to their
size in stages, each of which pushes them apart until none overlaps.

Overlaps are springs between rigid particles and at the tube's wall; a stage seeks
rest with FIRE (Bitzek and others, Phys. Rev. Lett. 97, 170201, 2006).
"""

import numpy as np

from cases.lib.packing import pack_random
from cases.lib.packing.pack_shapes import NotPacked, pairs, turned

MARGIN = 1e-3      # spheres are packed this much too large, so that no overlap is left
_FIRST = 0.05      # solid fraction of the first stage, by random insertion
_STAGE = 0.05      # more solid fraction a stage, and at most
_GROWTH = 1.3      # times as much: clumps that reach through each other stay so
_FINEST = 0.005    # given up when a stage this small does not come to rest
_STEPS = 2000      # of FIRE in a stage; near the densest many are needed
_WINDOW = 200    # given up when in so many steps less than a quarter of the energy goes
_SKIN = 0.25       # of a diameter: neighbours listed beyond contact


def place(shape, count, tube, seed, say, solid_fraction):
    """Centres and rotations of `count` particles; NotPacked if not all find room.

    solid_fraction: that of the particles at their full size.
    """
    large = shape.scaled(1.0)
    large.radius *= 1 + MARGIN
    reached, stage = min(_FIRST, solid_fraction), _STAGE

    def grown(fraction):
        return large.scaled((fraction / solid_fraction)**(1 / 3))

    try:
        x, q = pack_random.place(grown(reached), count, tube, seed, say)
    except NotPacked as e:
        raise NotPacked(e.share * reached / solid_fraction, e.at) from None
    while reached < solid_fraction:
        now = min(reached + stage, _GROWTH * reached, solid_fraction)
        found = _relax(grown(now), x, q, tube, lambda left: say(
            f"solid fraction {now:.3f} of {solid_fraction:.3f}, overlap left {left:.1e} d"))
        if found is not None:
            x, q = found
            reached = now
        else:
            stage = min(stage, now - reached) / 2
            if stage < _FINEST:
                raise NotPacked(reached / solid_fraction, "the particles jam")
    return x, q


class _Contacts:
    """The springs between spheres, from a list of neighbours that is made anew
    when a sphere has moved far."""

    def __init__(self, shape, tube):
        self.shape, self.tube = shape, tube
        self.ij, self.at = None, None

    def forces(self, points):
        """Force on each sphere, unit stiffness, the largest overlap and the energy."""
        r, tube = self.shape.radius, self.tube
        if self.at is None or ((points - self.at)**2).sum(1).max() > (_SKIN * r)**2:
            self.ij = pairs(points, 2 * r * (1 + _SKIN), len(self.shape.centres))
            self.at = points.copy()
        i, j = self.ij.T
        d = points[i] - points[j]
        square = (d * d).sum(1)
        close = square < 4 * r * r
        i, j, d = i[close], j[close], d[close]
        distance = np.sqrt(square[close])
        depth = 2 * r - distance
        push = d * (depth / np.maximum(distance, 1e-12 * r))[:, None]
        n = len(points)
        f = np.empty_like(points)
        for k in range(3):
            f[:, k] = np.bincount(i, push[:, k], n) - np.bincount(j, push[:, k], n)

        rho = np.hypot(points[:, 0], points[:, 1])
        wall = np.maximum(rho + r - tube.radius, 0)
        f[:, :2] -= points[:, :2] * (wall / np.maximum(rho, r))[:, None]
        floor = np.maximum(r - points[:, 2], 0)
        top = np.maximum(points[:, 2] + r - tube.height, 0)
        f[:, 2] += floor - top
        most = max(depth.max(initial=0), wall.max(), floor.max(), top.max())
        energy = sum((over * over).sum() for over in (depth, wall, floor, top))
        return f, most, energy


def _relax(shape, x, q, tube, say):
    """The particles without overlaps beyond the margin, or None if they do not
    come apart."""
    n = len(shape.centres)
    # a turn counts as the way of its lever, so that all move alike
    lever = max(np.sqrt((shape.centres**2).sum(1).mean()), shape.radius)
    contacts = _Contacts(shape, tube)
    goal = MARGIN * shape.radius / (1 + MARGIN)
    v = np.zeros((len(x), 6))
    before = np.inf
    step, most_step, mixing, good = 0.1, 0.5 if n == 1 else 0.35, 0.1, 0
    for k in range(_STEPS):
        points = shape.spheres(x, q)
        f, left, energy = contacts.forces(points)
        if left <= goal:
            return x, q
        if k % _WINDOW == 0:
            if energy > 0.75 * before:
                return None
            before = energy
        if k % 20 == 0:
            say(left / (2 * shape.radius))
        force = np.empty_like(v)
        arms = points.reshape(-1, n, 3) - x[:, None, :]
        force[:, :3] = f.reshape(-1, n, 3).sum(1)
        force[:, 3:] = np.cross(arms, f.reshape(-1, n, 3)).sum(1) / lever

        power = (force * v).sum()
        if power > 0:
            size = np.sqrt((force * force).sum())
            v = (1 - mixing) * v + mixing * np.sqrt((v * v).sum()) / size * force
            good += 1
            if good > 5:
                step = min(1.1 * step, most_step)
                mixing *= 0.99
        else:
            v[:] = 0
            step, mixing, good = 0.5 * step, 0.1, 0
        v += step * force
        move = step * v
        # no particle jumps over another
        far = np.abs(move).max() / (0.3 * shape.radius)
        if far > 1:
            move /= far
        x = x + move[:, :3]
        if n > 1:
            q = turned(q, move[:, 3:] / lever)
    return None
