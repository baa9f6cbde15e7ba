# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Charge and time scale from a measured curve and runs at several charges.

Emulator: at every moment the height, over that at the start, is a parabola in
the charge, by least squares over all runs (a line for two charges). Each run has a
packing of its own, so what is left over is the spread of the packings, with
its correlation in time.

Estimate: weighted least squares over charge q and log of the time scale s. A
point's weight is that of its stage, the same for each stage, over the variance
of noise and spread there.

Intervals: to first order the estimate's error is A e, A = (J'WJ)^-1 J'W, e the
data's deviation from the mean curve. A r_k, r_k what is left over of run k, is
what such a deviation did to the estimate in each of n runs: for every q it is
a regression on p coefficients, whose prediction interval for a new run is
t(n - p) sqrt(sum (A r_k)^2/(n - p) (1 + h)), h the leverage at q (Draper and
Smith 1998, Applied Regression Analysis, ch. 3). Independent noise of the data
adds |A|^2 times its variance. A charge q0 belongs to the interval when the
step from it towards the estimate is within that width there: the test is
inverted, so a flat misfit gives a wide interval, not a wrong one. The interval
of s is the projection of the elliptic region over all such q0. Where the curve
fits worse than noise and spread let expect, the widths grow by that factor.
"""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import minimize_scalar
from scipy.stats import t as student

from cases.lib.calibration.caldata import DAY

_GRID = 600
_TRIALS = 81


class Emulator:
    """The mean curve over charge; charges shape (n,), curves n pairs (t, y)."""

    def __init__(self, charges, curves):
        self.charges = np.asarray(charges, dtype=float)
        self.end = min(t[-1] for t, _ in curves)
        self.t = np.linspace(0.0, self.end, _GRID + 1)
        self.y = np.array([np.interp(self.t, t, y) for t, y in curves])
        self.low, self.high = self.charges.min(), self.charges.max()
        self.p = min(3, len(np.unique(self.charges)))
        basis = self.basis(self.charges)
        self.inverse = np.linalg.inv(basis.T @ basis)
        self.c = self.inverse @ basis.T @ self.y
        self.left = self.y - basis @ self.c
        last = self.t[-_GRID // 4:] - np.mean(self.t[-_GRID // 4:])
        self.slope = last / (last @ last)  # times a curve's last quarter: its slope there
        self.dof = len(self.charges) - self.p
        self.variance = np.sum(self.left**2, axis=0) / self.dof if self.dof else np.full(_GRID + 1, np.nan)

    def basis(self, q):
        x = (np.atleast_1d(q) - self.low) / max(self.high - self.low, 1e-300)
        return x[:, None] ** np.arange(self.p)

    def leverage(self, q):
        b = self.basis(q)[0]
        return float(b @ self.inverse @ b)

    def mean(self, q):
        return (self.basis(q) @ self.c)[0]

    def at(self, curve, t):
        """A curve of the grid at other times; on along its last quarter after the end."""
        slope = min(0.0, self.slope @ curve[-_GRID // 4:])
        return np.interp(t, self.t, curve) + slope * np.maximum(t - self.end, 0.0)

    def scalar(self, values, q):
        """Regression of one number a run: its mean at q, and its standard error for a new run."""
        basis = self.basis(self.charges)
        c = self.inverse @ basis.T @ values
        spread = np.sum((values - basis @ c)**2) / self.dof if self.dof else np.inf
        return float((self.basis(q) @ c)[0]), float(np.sqrt(spread * (1 + self.leverage(q))))


@dataclass(frozen=True)
class Fit:
    """q [C] and s with their intervals; `q_edges` tells whether the lowest and
    the highest charge tried lie in the interval. region: rows q, ln s, half
    width of ln s over the charges of the interval. rms, expected: misfit of y."""

    q: float
    s: float
    q_interval: tuple
    s_interval: tuple
    q_edges: tuple
    correlation: float
    rms: float
    expected: float
    dof: int
    region: np.ndarray
    covariance: np.ndarray
    factor: float
    level: float

    @property
    def known(self):
        """Whether there are intervals at all."""
        return bool(np.all(np.isfinite([*self.q_interval, *self.s_interval])))

    @property
    def determined(self):
        """Whether the interval of q ends inside the charges tried."""
        return self.known and not any(self.q_edges)


class Problem:
    """The fit of an emulator to data; level is that of the intervals."""

    def __init__(self, emulator, data, level=0.95):
        self.e, self.level = emulator, level
        self.tau = data.days[data.used] * DAY
        self.y, self.noise = data.y[data.used], data.noise
        counts = np.bincount(data.stage[data.used])
        self.share = 1.0 / counts[data.stage[data.used]]
        self.weight = self.share / self.share.sum()

    def residual(self, q, logs):
        return self.y - self.e.at(self.e.mean(q), self.tau * np.exp(-logs))

    def misfit(self, q, logs):
        return self._misfit(self.e.mean(q), logs)

    def _misfit(self, curve, logs):
        return float(self.weight @ (self.y - self.e.at(curve, self.tau * np.exp(-logs)))**2)

    def best_scale(self, q, near=None):
        """ln s of the least misfit at a charge."""
        curve = self.e.mean(q)
        if near is None:
            trial = np.log(self.tau[-1] / self.e.end) + np.linspace(-3.5, 3.5, 141)
        else:
            trial = near + np.linspace(-0.25, 0.25, 11)
        found = trial[np.argmin([self._misfit(curve, x) for x in trial])]
        step = trial[1] - trial[0]
        return float(minimize_scalar(lambda x: self._misfit(curve, x), bounds=(found - step, found + step),
                                     method="bounded", options={"xatol": 1e-6}).x)

    def estimate(self):
        """(q, ln s) of the least misfit."""
        charges = np.linspace(self.e.low, self.e.high, 25)
        scales = [self.best_scale(q) for q in charges]
        k = int(np.argmin([self.misfit(q, x) for q, x in zip(charges, scales)]))
        step = charges[1] - charges[0]
        bounds = (max(self.e.low, charges[k] - step), min(self.e.high, charges[k] + step))
        q = minimize_scalar(lambda q: self.misfit(q, self.best_scale(q, scales[k])), bounds=bounds,
                            method="bounded", options={"xatol": 1e-5 * self.e.high}).x
        return float(q), self.best_scale(q, scales[k])

    def slopes(self, q, logs):
        """J: how the curve changes with q (in units of the range) and ln s, shape (m, 2)."""
        unit = self.e.high - self.e.low

        def curve(q, x):
            return self.e.at(self.e.mean(q), self.tau * np.exp(-x))

        a, b = max(self.e.low, q - 0.02 * unit), min(self.e.high, q + 0.02 * unit)
        return np.column_stack([(curve(b, logs) - curve(a, logs)) / ((b - a) / unit),
                                (curve(q, logs + 0.01) - curve(q, logs - 0.01)) / 0.02])

    def _spread(self, gain, q, logs):
        """Covariance of gain e: of packings with the emulator, of noise; gain shape (k, m)."""
        t = self.tau * np.exp(-logs)
        moved = np.array([np.interp(t, self.e.t, r) for r in self.e.left]) @ gain.T
        return (moved.T @ moved / self.e.dof * (1 + self.e.leverage(q)), self.noise**2 * gain @ gain.T)

    def _width(self, packings, noise):
        """Half of an interval, of variances; degrees of freedom after Satterthwaite."""
        total = packings + noise
        dof = self.e.dof * (total / max(packings, 1e-300))**2
        return float(student.ppf(0.5 + 0.5 * self.level, min(dof, 1e6)) * np.sqrt(total))

    def _gain(self, q, logs):
        j = self.slopes(q, logs)
        normal = (j.T * self.weight) @ j
        normal += 1e-12 * np.trace(normal) * np.eye(2)
        return np.linalg.solve(normal, j.T * self.weight), j

    def solve(self):
        """The Fit. With as many coefficients as runs there are no intervals yet."""
        q, logs = self.estimate()
        if not self.e.dof:
            return self._unknown(q, logs)
        for _ in range(2):  # the weights are those at the estimate
            t = self.tau * np.exp(-logs)
            spread = np.interp(t, self.e.t, self.e.variance) + self.noise**2
            self.weight = self.share / (spread + 0.1 * spread.mean())
            self.weight /= self.weight.sum()
            q, logs = self.estimate()
        rms = float(np.sqrt(np.mean(self.residual(q, logs)**2)))
        expected = float(np.sqrt(np.mean(spread)))
        factor = max(1.0, rms / expected)

        unit = self.e.high - self.e.low
        trials = np.unique(np.append(np.linspace(self.e.low, self.e.high, _TRIALS), q))
        scale, ratio, half = (np.zeros(len(trials)) for _ in range(3))
        near = logs
        middle = int(np.searchsorted(trials, q))
        for i in [*range(middle, len(trials)), *range(middle - 1, -1, -1)]:
            near = logs if i in (middle, middle - 1) else near
            near = scale[i] = self.best_scale(trials[i], near)
            gain, j = self._gain(trials[i], near)
            packings, noise = self._spread(gain, trials[i], near)
            step = (gain @ self.residual(trials[i], near))[0]
            ratio[i] = abs(step) / max(factor * self._width(packings[0, 0], noise[0, 0]), 1e-300)
            alone = (j[:, 1] * self.weight / (self.weight @ j[:, 1]**2))[None, :]
            a, b = self._spread(alone, trials[i], near)
            half[i] = factor * self._width(a[0, 0], b[0, 0])
        # the estimate itself belongs to it, at an end of the range, too
        ratio[middle] = min(ratio[middle], 0.999)
        inside = np.flatnonzero(ratio <= 1)
        interval = tuple(self._edge(trials, ratio, k, way) for k, way in ((inside[0], -1), (inside[-1], 1)))
        region = np.column_stack([trials[inside], scale[inside],
                                  half[inside] * np.sqrt(1 - ratio[inside]**2)])
        ends = [[edge, np.interp(edge, trials, scale), 0.0] for edge in interval]
        region = np.vstack([ends[0], region, ends[1]])
        s_interval = (float(np.exp(np.min(region[:, 1] - region[:, 2]))),
                      float(np.exp(np.max(region[:, 1] + region[:, 2]))))
        gain, _ = self._gain(q, logs)
        both = factor**2 * sum(self._spread(gain, q, logs)) * np.array([[unit**2, unit], [unit, 1]])
        correlation = float(both[0, 1] / np.sqrt(both[0, 0] * both[1, 1]))
        return Fit(q, float(np.exp(logs)), interval, s_interval,
                   (bool(ratio[0] <= 1), bool(ratio[-1] <= 1)), correlation, rms, expected,
                   self.e.dof, region, both, factor, self.level)

    @staticmethod
    def _edge(trials, ratio, k, way):
        """Where the ratio passes 1, between trial k and its neighbour outside."""
        j = k + way
        if not 0 <= j < len(trials):
            return float(trials[k])
        part = (1 - ratio[k]) / max(ratio[j] - ratio[k], 1e-300)
        return float(trials[k] + part * (trials[j] - trials[k]))

    def _unknown(self, q, logs):
        none = (-np.inf, np.inf)
        rms = float(np.sqrt(np.mean(self.residual(q, logs)**2)))
        edge = 1e-3 * (self.e.high - self.e.low)
        return Fit(q, float(np.exp(logs)), none, none, (q < self.e.low + edge, q > self.e.high - edge),
                   np.nan, rms, np.nan, 0, np.array([[q, logs, np.inf]]), np.full((2, 2), np.inf), 1.0, self.level)
