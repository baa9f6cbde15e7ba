# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What is packed, and into what: rigid groups of equal spheres, and the tube."""

import math
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree


@dataclass
class Shape:
    """A sphere, or a clump of equal spheres."""
    centres: np.ndarray  # (n, 3), about the centre of mass [m]
    radius: float        # of the spheres [m]

    @property
    def reach(self):
        """Radius [m] of the sphere around it."""
        return float(np.linalg.norm(self.centres, axis=1).max()) + self.radius

    def scaled(self, factor):
        return Shape(factor * self.centres, factor * self.radius)

    def spheres(self, x, q):
        """Centres (N n, 3) of the spheres of N particles, the first one's first."""
        turned = np.einsum("kij,sj->ksi", rotations(q), self.centres)
        return (x[:, None, :] + turned).reshape(-1, 3)


@dataclass
class Tube:
    """The upright cylinder that is filled, from z = 0 to its height."""
    radius: float
    height: float

    def beyond(self, points, sphere):
        """How far [m] each sphere sticks out of the wall, the floor and the top; not below 0."""
        r = np.hypot(points[:, 0], points[:, 1])
        out = np.maximum(r + sphere - self.radius,
                         np.maximum(sphere - points[:, 2], points[:, 2] + sphere - self.height))
        return np.maximum(out, 0)

    def centres(self, rng, count, sphere):
        """Random centres of spheres that stay inside."""
        r = (self.radius - sphere) * np.sqrt(rng.random(count))
        a = 2 * math.pi * rng.random(count)
        z = sphere + (self.height - 2 * sphere) * rng.random(count)
        return np.column_stack([r * np.cos(a), r * np.sin(a), z])


class NotPacked(Exception):
    """Not all found room. share: how much of the asked solids did; at: what was
    done when it was given up."""

    def __init__(self, share, at):
        super().__init__(at)
        self.share, self.at = share, at


def single(radius):
    """A sphere."""
    return Shape(np.zeros((1, 3)), radius)


def plate(radius, layer_spacing):
    """A clump of particletemplate/clay: two hexagonal layers of seven, axis along z."""
    ring = [(0.0, 0.0)] + [(2 * radius * math.cos(k * math.pi / 3), 2 * radius * math.sin(k * math.pi / 3))
                           for k in range(6)]
    return Shape(np.array([(x, y, z) for z in (-0.5 * layer_spacing, 0.5 * layer_spacing)
                           for x, y in ring]), radius)


def rotations(q):
    """Matrices (N, 3, 3) of unit quaternions (N, 4), scalar part first."""
    w, x, y, z = q.T
    return np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
                     2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                     2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)], axis=1).reshape(-1, 3, 3)


def turned(q, angle):
    """Quaternions after a small further turn about space axes, angle (N, 3) [rad]."""
    half = 0.5 * np.linalg.norm(angle, axis=1, keepdims=True)
    v = 0.5 * np.sinc(half / math.pi) * angle
    w = np.cos(half)
    new = np.concatenate([w * q[:, :1] - (v * q[:, 1:]).sum(1, keepdims=True),
                          w * q[:, 1:] + q[:, :1] * v + np.cross(v, q[:, 1:])], axis=1)
    return new / np.linalg.norm(new, axis=1, keepdims=True)


def random_turns(rng, count):
    """Uniformly distributed rotations, as quaternions."""
    q = rng.normal(size=(count, 4))
    return q / np.linalg.norm(q, axis=1, keepdims=True)


def pairs(points, distance, per_particle):
    """Pairs (M, 2) of spheres of different particles, nearer than the distance."""
    found = cKDTree(points).query_pairs(distance, output_type="ndarray")
    return found[found[:, 0] // per_particle != found[:, 1] // per_particle]


def overlaps(shape, x, q):
    """Largest overlap [m] of two spheres of different particles, 0 without any,
    and which particles overlap: pairs (M, 2)."""
    points = shape.spheres(x, q)
    ij = pairs(points, 2 * shape.radius, len(shape.centres))
    depth = 2 * shape.radius - np.linalg.norm(points[ij[:, 0]] - points[ij[:, 1]], axis=1)
    return float(depth.max(initial=0.0)), ij // len(shape.centres)
