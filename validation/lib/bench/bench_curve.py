# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of settling curves, and the front of run time against error."""

import numpy as np


def difference(curve, reference, key="interface_m"):
    """Root mean square distance of two curves over what the reference has sunk,
    over the time they share."""
    end = min(curve["time_s"][-1], reference["time_s"][-1])
    t = reference["time_s"][reference["time_s"] <= end * (1 + 1e-9)]
    wanted = reference[key][:len(t)]
    found = np.interp(t, curve["time_s"], curve[key])
    sunk = reference[key][0] - reference[key].min()
    if not sunk > 0:
        raise ValueError(f"{key}: the reference has not sunk at all")
    return float(np.sqrt(np.mean((found - wanted)**2)) / sunk)


def spread(curves, key="interface_m"):
    """Root mean square distance of curves of several seeds from their mean, each
    counted from where it begins; relative as in difference(), n - 1 for n."""
    if len(curves) < 2:
        raise ValueError("the spread wants two curves at least")
    t = curves[0]["time_s"]
    h = np.array([np.interp(t, c["time_s"], c[key]) - c[key][0] for c in curves])
    mean = h.mean(axis=0)
    sunk = mean[0] - mean.min()
    return float(np.sqrt(((h - mean)**2).sum(axis=0).mean() / (len(curves) - 1)) / sunk)


def front(points, floor=0.0):
    """Which of the points (time, error) no other one beats in both. Errors below
    the floor are not told apart; of equal points all are on it."""
    seen = [(t, max(e, floor)) for t, e in points]
    return [not any((a <= t and b < e) or (a < t and b <= e) for a, b in seen) for t, e in seen]


def ratios(times, baselines):
    """Of runs made in turn with a baseline: each over the mean of the baseline's
    runs before and after it. baselines holds one more than times."""
    if len(baselines) != len(times) + 1:
        raise ValueError("each run must have a baseline's before and after it")
    return [2 * t / (a + b) for t, a, b in zip(times, baselines, baselines[1:])]
