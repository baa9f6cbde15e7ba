# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Near-linear stages of a settling curve, height against time.

A continuous line of 1 to 4 straight segments is fitted by least squares. The
search over break points is exhaustive on a grid that is even half in time and
half in fall, and is then refined (Muggeo 2003, Stat. Med. 22, 3055-3071). The
number of segments is the smallest whose BIC, n log(rss/n) + p log n, lies
within 6 of the least ("strong" evidence of Kass and Raftery 1995, J. Am. Stat.
Assoc. 90, 773-795) and whose neighbouring slopes differ. n is the number of
independent points: points over the autocorrelation time of the residuals, so
that correlated noise does not pass for structure. p counts 2 for the first
line and 3 for every break: its slope, its place, and the search for it.
Confidence intervals come from a wild bootstrap that turns the sign of whole
blocks of residuals, which keeps their correlation and their size in place
(Shao 2010, J. Am. Stat. Assoc. 105, 218-235). A segment whose slope changes by
half of itself is not near-linear, and the message says so.
"""

from dataclasses import dataclass

import numpy as np

from cases.lib.theory.segments import Search, basis_of, measure, thin


@dataclass(frozen=True)
class StageFit:
    """Result of `detect`; s is the number of segments.

    count        s
    knots        shape (s + 1,): start, breaks, end [s]
    heights      shape (s + 1,): height of the fitted line there [m]
    slopes       shape (s,), as dz/dt: falling is negative [m/s]
    breaks_ci    shape (s - 1, 2), slopes_ci shape (s, 2): bounds at `level`
    linear       shape (s,) of bool: segment near-linear
    bic          numbers of segments tried and their BIC
    rms          of the residuals [m]
    independent  number of independent points
    message      plain words
    """

    count: int
    knots: np.ndarray
    heights: np.ndarray
    slopes: np.ndarray
    breaks_ci: np.ndarray
    slopes_ci: np.ndarray
    linear: np.ndarray
    bic: dict
    rms: float
    independent: float
    level: float
    message: str

    @property
    def breaks(self):
        """Break points [s], shape (s - 1,)."""
        return self.knots[1:-1]

    @property
    def ordered(self):
        """Whether every stage falls more slowly than the one before."""
        return bool(np.all(np.diff(self.slopes) > 0.0))

    @property
    def three(self):
        """Whether there are three near-linear stages or more, in order."""
        return self.count >= 3 and bool(np.all(self.linear)) and self.ordered

    def height(self, t):
        """Height [m] of the fitted line at t [s], any shape."""
        return np.interp(t, self.knots, self.heights)


def correlation_time(residual):
    """Autocorrelation time in points, 1 or more. residual shape (m,).

    The greater of 1 + 2 sum of rho_k up to the first rho_k below 0.05, and
    (1 + rho_1)/(1 - rho_1), that of first-order autoregression: the sum comes
    out short when a fit has taken the slow part of the noise.
    """
    r = residual - np.mean(residual)
    power = np.sum(r**2)
    if power <= 0.0:
        return 1.0
    total, first = 1.0, np.sum(r[1:] * r[:-1]) / power
    for k in range(1, r.size // 2):
        rho = np.sum(r[k:] * r[:-k]) / power
        if rho < 0.05:
            break
        total += 2.0 * rho
    return float(max(total, (1.0 + first) / max(1.0 - first, 1e-6)))


def _differ(c, distinct):
    """Whether all neighbouring slopes differ by a part of the steeper one."""
    slopes = np.cumsum(c[1:])
    steeper = np.maximum(np.abs(slopes[1:]), np.abs(slopes[:-1]))
    return bool(np.all(np.abs(np.diff(slopes)) >= distinct * steeper))


def _near_linear(t, z, low, high, slope, size, effective, bend):
    """Whether the curve between low and high is near-linear: a parabola's
    slope changes by less than `bend` of the segment's, or its sag is below
    1 % of the whole fall, or below twice its own standard error."""
    inside = (t >= low) & (t <= high)
    if np.count_nonzero(inside) < 6:
        return True
    x = (t[inside] - 0.5 * (low + high)) / (high - low)
    basis = np.column_stack([np.ones_like(x), x, x**2])
    c = np.linalg.lstsq(basis, z[inside], rcond=None)[0]
    residual = z[inside] - basis @ c
    error = np.sqrt(np.linalg.inv(basis.T @ basis)[2, 2] * effective
                    * np.sum(residual**2) / (x.size - 3))
    change = 2.0 * abs(c[2]) / (high - low)
    return bool(change < bend * abs(slope) or abs(c[2]) / 4.0 < 0.01 * size
                or abs(c[2]) < 2.0 * error)


def detect(time, height, most=4, level=0.95, samples=200, seed=1,
           resolution=5e-4, distinct=0.15, bend=0.5, points=400,
           candidates=36):
    """Stages of the curve height(time); returns a StageFit.

    time, height  shape (m,), m >= 12, time rising [s], height [m]
    most          greatest number of segments tried, 1 ... 4
    level         of the confidence intervals; samples of the bootstrap; seed
    resolution    rms misfit, as a part of the whole fall, below which a
                  finer fit counts for nothing
    distinct      part of the steeper slope by which neighbours must differ
    bend          part of its slope that a near-linear segment may change by
    points        more points than this are put into bins first
    candidates    size of the grid of break points
    ValueError on lists that do not fit these.
    """
    t = np.asarray(time, dtype=float)
    z = np.asarray(height, dtype=float)
    if t.ndim != 1 or t.shape != z.shape or t.size < 12:
        raise ValueError("time and height should be two lists of equal length,"
                         f" 12 or more, here {t.shape} and {z.shape}")
    if not (np.all(np.isfinite(t)) and np.all(np.isfinite(z))):
        raise ValueError("time and height should be finite")
    if np.any(np.diff(t) <= 0.0):
        raise ValueError("time should rise from each point to the next")
    if most not in (1, 2, 3, 4):
        raise ValueError(f"most = {most} should be 1, 2, 3 or 4")
    if not 0.0 < level < 1.0:
        raise ValueError(f"level = {level} should lie between 0 and 1")
    begin, end = t[0], t[-1]
    t, z = thin(t, z, points)
    size = max(float(np.ptp(z)), 1e-300)
    unit = end - begin
    x, y = (t - begin) / unit, (z - z[0]) / size

    spacing = max(4, round(0.02 * x.size))
    grid = np.interp(np.linspace(0.0, 1.0, candidates + 2)[1:-1],
                     measure(x, y) + 1e-12 * np.arange(x.size), x)
    search = Search(x, np.unique(grid), spacing, most)
    fits = {k + 1: search.best(y, k) for k in search.sets}
    floor = x.size * resolution**2
    finest = fits[max(fits)]
    effective = correlation_time(y - basis_of(x, finest[0]) @ finest[1])
    if finest[2] < floor:
        effective = 1.0
    independent = max(x.size / effective, 8.0)
    bic = {s: float(independent * np.log(max(fit[2], floor) / x.size)
                    + (3 * s - 1) * np.log(independent))
           for s, fit in fits.items()}
    allowed = [s for s, fit in fits.items() if _differ(fit[1], distinct)]
    least = min(bic[s] for s in allowed)
    count = min(s for s in allowed if bic[s] <= least + 6.0)
    knots, c, rss = fits[count]

    line = basis_of(x, knots) @ c
    residual = y - line
    block = int(np.clip(np.ceil(2.0 * correlation_time(residual)), 5,
                        max(x.size // 4, 5)))
    taken = 3 * count - 1
    residual *= np.sqrt(independent / max(independent - taken,
                                          0.5 * independent))
    rng = np.random.default_rng(seed)
    drawn_knots, drawn_slopes = [], []
    for _ in range(samples):
        numbers = (np.arange(x.size) + rng.integers(block)) // block
        sign = rng.choice((-1.0, 1.0), numbers[-1] + 1)[numbers]
        k, b, _ = search.best(line + sign * residual, count - 1)
        drawn_knots.append(k)
        drawn_slopes.append(np.cumsum(b[1:]))
    tails = [0.5 * (1.0 - level), 0.5 * (1.0 + level)]

    def interval(values, width):
        if not samples:
            return np.full((width, 2), np.nan)
        return np.quantile(np.array(values), tails, axis=0).T.reshape(width, 2)

    slopes = np.cumsum(c[1:])
    edges = np.concatenate([[0.0], knots, [1.0]])
    linear = np.array([_near_linear(x, y, a, b, s, 1.0, effective, bend)
                       for a, b, s in zip(edges[:-1], edges[1:], slopes)])
    heights = z[0] + size * (basis_of(edges, knots) @ c)
    return StageFit(
        count, begin + unit * edges, heights, size / unit * slopes,
        begin + unit * interval(drawn_knots, count - 1),
        size / unit * interval(drawn_slopes, count), linear, bic,
        float(size * np.sqrt(rss / x.size)), float(independent), level,
        _message(count, linear, slopes))


def _message(count, linear, slopes):
    words = f"{count} segment" + ("s" if count > 1 else "")
    words += (", all near-linear" if np.all(linear) else
              f", {np.count_nonzero(linear)} of them near-linear")
    if not np.all(linear):
        words += ("; the curve bends throughout segment "
                  + ", ".join(str(k + 1) for k in np.flatnonzero(~linear)))
    if np.any(np.diff(slopes) <= 0.0):
        words += "; a later segment falls faster than the one before"
    return words
