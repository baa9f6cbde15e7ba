# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Momentum of grains and fluid in a column one cell wide, from the dumps and the fields alone."""

import os

import numpy as np

from cases.lib.case import openfoam
from validation.lib.checks import fields
from validation.lib.checks.fed_column import AREA, CELL, R, RHO, RHO_P, cells

MASS = 4 / 3 * np.pi * R**3 * RHO_P


def states(folder):
    """The states of DEM/steps.dump: {tag: (z, velocity)} a step."""
    found, now = [], None
    with open(os.path.join(folder, "DEM", "steps.dump"), encoding="utf-8") as f:
        for line in f:
            words = line.split()
            if line.startswith("ITEM: ATOMS"):
                now = {}
                found.append(now)
            elif line.startswith("ITEM:"):
                now = None
            elif now is not None:
                x = np.array(words[1:], dtype=float)
                now[int(words[0])] = (x[2], x[3:6])
    return found


def drift(folder, count, speed=0.2, steps=20):
    """(largest drift of the sum of both momenta over what the fluid has got at most, spheres that came,
    spheres that were deleted), with `steps` DEM steps an interval.

    A sphere comes with its momentum and goes with that of its last whole step. Where it
    comes or goes n jumps at the fluid's velocity, at the exchange that learns of it and before fields are written."""
    all_, sums, came, gone = states(folder), [], 0, 0
    brought = np.zeros(3)
    outputs = openfoam.times(os.path.join(folder, "CFD"))
    for k, (_, at) in enumerate(outputs[1:], 1):  # at first nothing is there
        old, now = all_[(k - 1) * steps], all_[k * steps]
        for a, b in zip(all_[(k - 1) * steps:k * steps], all_[(k - 1) * steps + 1:k * steps + 1]):
            fresh, missing = set(b) - set(a), set(a) - set(b)
            came, gone = came + len(fresh), gone + len(missing)
            brought += len(fresh) * MASS * np.array([0, 0, -speed])
            brought -= sum((MASS * a[i][1] for i in missing), np.zeros(3))
        U, n, owed = (fields.field(at, name, count) for name in ("U", "voidfraction", "couplingImpulse"))
        # the fluid that n is written without already, or with
        for tags, here, sign in ((set(now) - set(old), now, -1), (set(old) - set(now), old, 1)):
            if tags and k < len(outputs) - 1:  # no interval begins at the end
                share = cells(np.array([here[i][0] for i in tags]), count).sum(axis=0)
                brought = brought + sign * RHO * (share[:, None] * U).sum(axis=0)
        fluid = RHO * AREA * CELL * (n[:, None] * U).sum(axis=0)
        grains = sum((MASS * v for _, v in now.values()), np.zeros(3))
        sums.append((grains + fluid + AREA * CELL * owed.sum(axis=0) - brought, fluid))
    drifts = [np.linalg.norm(s) for s, _ in sums]
    return max(drifts) / max(np.linalg.norm(f) for _, f in sums), came, gone
