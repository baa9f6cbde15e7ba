# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Stages 1, 2, 3 of a settling curve, numbered alike for all curves.

theory.stages finds near-linear segments. Of those, a slow start before the
first stage is set aside, and a stage has to fall at most half as fast as the
one before, and the second to last at least half as long as the first, which a
mere knee does not: else the curve is fitted with a segment less.
"""

from dataclasses import dataclass

import numpy as np

_MOST = 3
_SLOWER = 0.5
_LONGER = 0.5


@dataclass(frozen=True)
class Stages:
    """start: end of the slow start, or the curve's first time; slopes shape
    (k,), breaks (k - 1,), with bounds slopes_ci, breaks_ci; near_linear (k,)."""

    start: float
    slopes: np.ndarray
    slopes_ci: np.ndarray
    breaks: np.ndarray
    breaks_ci: np.ndarray
    near_linear: np.ndarray

    @property
    def count(self):
        return len(self.slopes)


def _started(slopes):
    """How many segments at the beginning fall more slowly than the next."""
    k = 0
    while k + 1 < len(slopes) and slopes[k + 1] < slopes[k]:
        k += 1
    return k


def _stages(slopes, lengths):
    """Whether segments are stages."""
    return (len(slopes) <= _MOST
            and all(b >= _SLOWER * min(a, 0.0) for a, b in zip(slopes[:-1], slopes[1:]))
            and all(b >= _LONGER * a for a, b in zip(lengths[:-2], lengths[1:-1])))


def of(time, height, samples=200):
    """Stages of a curve; samples of the bootstrap that bounds them."""
    from cases.lib.theory.stages import detect
    for most in (4, 3, 2, 1):
        fit = detect(time, height, most=most, samples=0)
        k = _started(fit.slopes)
        if _stages(fit.slopes[k:], np.diff(fit.knots[k:])):
            break
    if samples:
        fit = detect(time, height, most=most, samples=samples)
    return Stages(float(fit.knots[k]), fit.slopes[k:], fit.slopes_ci[k:], fit.breaks[k:], fit.breaks_ci[k:],
                  fit.linear[k:])
