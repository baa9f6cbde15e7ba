# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of one sphere, for the checks that have one."""

import os

import numpy as np

from validation.lib.checks import coupled


def run(where, *, limit=600, **values):
    """A run of the case sphere-scene with these values; returns its folder."""
    options = [x for key, value in values.items() for x in ("--set", f"{key}={value:.10g}" if isinstance(value, float)
                                                            else f"{key}={value}")]
    return coupled.finished("sphere-scene", where, "--no-pictures", *options, limit=limit)


def path(folder):
    """Time [s], height [m] and upward velocity [m/s] of the sphere."""
    rows = np.loadtxt(os.path.join(folder, "DEM", "sphere.csv"), delimiter=",", skiprows=1)
    return rows[:, 0], rows[:, 3], rows[:, 6]
