# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Continuous lines of straight segments: fit and search for the breaks.

t and z are shape (m,) in any units; a line is sum of c_j basis_j(t).
"""

from itertools import combinations

import numpy as np


def measure(t, z):
    """0 ... 1 along the curve, half by time, half by greatest fall so far,
    of the mean over 1/200 of the points lest the noise chooses."""
    width = 2 * (t.size // 400) + 1
    padded = np.pad(z, width // 2, mode="edge")
    smooth = np.convolve(padded, np.full(width, 1.0 / width), "valid")
    fall = smooth[0] - np.minimum.accumulate(smooth)
    time = (t - t[0]) / (t[-1] - t[0])
    return 0.5 * (time + (fall / fall[-1] if fall[-1] > 0.0 else time))


def thin(t, z, points):
    """(t, z) as means over bins even in `measure`, when there are more than
    `points` of them."""
    if t.size <= points:
        return t, z
    bins = np.minimum((measure(t, z) * points).astype(int), points - 1)
    number = np.bincount(bins, minlength=points)
    keep = number > 0

    def mean(x):
        return np.bincount(bins, x, points)[keep] / number[keep]

    return mean(t), mean(z)


def basis_of(t, knots):
    """Columns 1, t and max(t - knot, 0) for each knot, shape (m, 2 + k)."""
    return np.column_stack([np.ones_like(t), t]
                           + [np.maximum(t - k, 0.0) for k in knots])


def fit_line(t, z, knots):
    """Coefficients and sum of squares of the line with those breaks."""
    basis = basis_of(t, knots)
    c = np.linalg.lstsq(basis, z, rcond=None)[0]
    return c, float(np.sum((z - basis @ c) ** 2))


class Search:
    """Exhaustive search over candidate breaks, set up once for its times.

    t           shape (m,), rising
    candidates  breaks tried, in units of t, rising
    spacing     least number of points in a segment
    most        greatest number of segments; `sets` holds the numbers of
                breaks for which the points suffice
    """

    def __init__(self, t, candidates, spacing, most):
        self.t, self.candidates, self.spacing = t, candidates, spacing
        self.basis = basis_of(t, candidates)
        gram = self.basis.T @ self.basis
        inside = np.searchsorted(t, candidates)
        self.sets = {}
        for breaks in range(most):
            picks = list(combinations(range(len(candidates)), breaks))
            chosen = np.array(picks, dtype=int).reshape(len(picks), breaks)
            edges = np.column_stack([np.zeros(len(chosen), int),
                                     inside[chosen],
                                     np.full(len(chosen), len(t))])
            chosen = chosen[np.all(np.diff(edges) >= spacing, axis=1)]
            if len(chosen) == 0:
                break
            columns = np.column_stack([np.zeros(len(chosen), int),
                                       np.ones(len(chosen), int), chosen + 2])
            inverse = np.linalg.pinv(
                gram[columns[:, :, None], columns[:, None, :]],
                rcond=1e-14, hermitian=True)
            self.sets[breaks] = chosen, columns, inverse

    def best(self, z, breaks):
        """(breaks in units of t, coefficients of basis_of, sum of squares)
        of the least-squares line with that number of breaks, refined."""
        chosen, columns, inverse = self.sets[breaks]
        right = (self.basis.T @ z)[columns]
        gain = np.einsum("ki,kij,kj->k", right, inverse, right)
        return self._refine(z, self.candidates[chosen[np.argmax(gain)]])

    def _refine(self, z, knots):
        """Muggeo's steps, halved until the sum of squares falls."""
        t, (c, rss) = self.t, fit_line(self.t, z, knots)
        for _ in range(12 if len(knots) else 0):
            basis = np.column_stack([basis_of(t, knots)]
                                    + [-(t > k).astype(float) for k in knots])
            full = np.linalg.lstsq(basis, z, rcond=None)[0]
            bend = full[2:2 + len(knots)]
            step = full[2 + len(knots):] / np.where(bend == 0.0, np.inf, bend)
            for scale in (1.0, 0.5, 0.25, 0.1):
                trial = knots + scale * step
                places = np.concatenate([[0], np.searchsorted(t, trial),
                                         [len(t)]])
                if np.all(np.diff(places) >= self.spacing):
                    new, less = fit_line(t, z, trial)
                    if less < rss:
                        break
            else:
                break
            done = rss - less < 1e-10 * rss
            knots, c, rss = trial, new, less
            if done:
                break
        return knots, c, rss
