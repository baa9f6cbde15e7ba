# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Where a sediment consolidates: where the particles' stresses, of contacts and
charges, carry more than half of the buoyant weight above, from the bottom up.
"""

import warnings

import numpy as np

_SHARE = 0.5
_LEAST = 0.02  # of the whole weight: above that height next to nothing is left to carry


def front(heights, stress, weight):
    """Height [m] up to which, from the bottom on, the stress is more than half of the weight above;
    0 where it is not at the bottom. heights, stress, weight: shape (k,), from the bottom up [m, Pa]."""
    heights, stress, weight = (np.asarray(a, dtype=float) for a in (heights, stress, weight))
    counts = weight > _LEAST * max(np.max(weight), 1e-300)
    if not counts[0]:
        return 0.0
    carried = stress > _SHARE * weight
    top = 0.0
    edges = np.concatenate([[0.0], 0.5 * (heights[1:] + heights[:-1])])
    for k in np.nonzero(counts)[0]:
        if not carried[k]:
            break
        top = edges[k + 1] if k + 1 < len(edges) else heights[k]
    return float(top)


def smoothed(rows, width=5):
    """The median over so many times, of rows (times, slices): impacts come and go. What is nan at a time, as
    the fluid's at the start, is left out of it."""
    rows = np.asarray(rows, dtype=float)
    half = width // 2
    padded = np.concatenate([rows[:1]] * half + [rows] + [rows[-1:]] * half)
    windows = np.stack([padded[k:k + len(rows)] for k in range(2 * half + 1)])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # nothing but nan stays nan
        return np.nanmedian(windows, axis=0)


def boundaries(times, fronts, tops):
    """(begin, end): the times [s] from which on, for good, the front is above the bottom, and within a tenth
    of the top of the solids; None where that is not reached. Shape (m,) each."""
    times, fronts, tops = (np.asarray(a, dtype=float) for a in (times, fronts, tops))

    def from_then_on(held):
        lacking = np.nonzero(~held)[0]
        first = lacking[-1] + 1 if lacking.size else 0
        return float(times[first]) if first < len(times) else None

    return from_then_on(fronts > 0), from_then_on(fronts >= 0.9 * tops)


def of_profile(columns):
    """(times, fronts, begin, end) of a run's profile: columns by name, as cases.lib.output.profile reads them."""
    times, heights = columns["time_s"], columns["height_m"]
    stress = smoothed(columns["contact_Pa"] + columns["coulomb_Pa"])
    weight = smoothed(columns["weight_Pa"])
    fronts = np.array([front(heights, s, w) for s, w in zip(stress, weight)])
    counts = weight > _LEAST * np.max(weight, axis=1, keepdims=True)
    thickness = heights[1] - heights[0] if len(heights) > 1 else 2 * heights[0]
    tops = np.array([heights[row][-1] + 0.5 * thickness if row.any() else 0.0 for row in counts])
    return (times, fronts, *boundaries(times, fronts, tops))
