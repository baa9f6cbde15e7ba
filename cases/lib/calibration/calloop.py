# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Which runs a calibration makes, and what it concludes from them.

A few charges first; then runs where the estimate is, each with a packing of
its own, until the interval of the charge is as narrow as wanted, or shrinks no
more and the estimate has come to rest in it. Charges beyond those tried are added when the estimate or
its interval goes to an end of them.
"""

from dataclasses import dataclass, field

import numpy as np
from scipy.stats import t as student

from cases.lib.calibration import calfit
from cases.lib.calibration.caldata import DAY

LEAST_DOF = 3  # with less, intervals are mostly the t distribution's tails
_EXTEND = {0: 0.65, 1: 1.35}
_EXTENSIONS = 2  # of each end
_FAR = 3.0  # a misfit over what is expected beyond which the fit says nothing of later days
_REST = 0.01  # the part of the whole fall that is left at the end of consolidation


@dataclass
class Outcome:
    """A calibration: the runs' charges, seeds and curves, the last fit, and
    the history of (runs, q, half of q's interval)."""

    charges: list
    seeds: list
    curves: list
    fit: object = None
    problem: object = None
    history: list = field(default_factory=list)
    why: str = ""


def search(data, curves_of, charges, seeds=1, batch=1, most=10, within=0.1, level=0.95,
           tell=print):
    """Calibrates: curves_of([(charge, seed), ...]) gives the runs' (t, height).

    charges to begin with, `seeds` runs of each; then `batch` runs at a time, to
    at most `most` runs, or until the charge is known `within` a part of itself.
    """
    made = Outcome([], [], [])
    extended = [0, 0]

    def add(wanted):
        first = len(made.charges) + 1
        pairs = [(float(f"{q:.4g}"), first + i) for i, q in enumerate(wanted)]
        made.curves += curves_of(pairs)
        made.charges += [q for q, _ in pairs]
        made.seeds += [s for _, s in pairs]
        made.problem = calfit.Problem(calfit.Emulator(made.charges, made.curves), data, level)
        f = made.fit = made.problem.solve()
        half = 0.5 * (f.q_interval[1] - f.q_interval[0])
        made.history.append((len(made.charges), f.q, half))
        tell(f"{len(made.charges)} runs: charge {f.q:.4g} C" + (f" +- {half:.2g}" if f.known else "")
             + f", time scale {f.s:.4g}")

    add([q for q in charges for _ in range(seeds)])
    while True:
        f, e = made.fit, made.problem.e
        room = most - len(made.charges)
        beyond = _beyond(f, e, extended)
        if f.known and f.dof >= LEAST_DOF and not any(beyond) and len(made.history) > 1:
            (_, before, wide), (_, now, half) = made.history[-2:]
            if f.determined and half < within * now:
                made.why = f"the charge is known within {100 * within:.3g} %"
                return made
            if half > 0.85 * wide and abs(now - before) < half:
                made.why = ("more runs shrink the interval of the charge no more" if f.determined else
                            "the curve does not bound the charge within those tried")
                return made
        if room < 1:
            made.why = f"{most} runs are the most that were allowed"
            return made
        if any(beyond):
            wanted = []
            for i, b in enumerate(beyond):
                if b and len(wanted) < room:
                    extended[i] += 1
                    wanted.append((e.low, e.high)[i] * _EXTEND[i])
            add(wanted)
        else:
            add([f.q] * min(batch, room))


def _beyond(f, e, extended):
    """Whether a charge below, above those tried is wanted."""
    near = 0.05 * (e.high - e.low)
    wanted = [f.q < e.low + near, f.q > e.high - near]
    if f.known and f.dof >= LEAST_DOF:
        # an interval of all charges tried is none that further ones would bound
        wanted = [False, False] if all(f.q_edges) else [a or b for a, b in zip(wanted, f.q_edges)]
    return [w and n < _EXTENSIONS for w, n in zip(wanted, extended)]


def scale_determined(made):
    """Whether the interval of s is the data's, not that of the charges tried:
    where these end the charge's interval, s is followed to the charge that
    would be tried next, and must not move by a quarter of its interval."""
    f, e = made.fit, made.problem.e
    if not f.known:
        return False
    low, high = np.log(f.s_interval)
    for edge, k in ((e.low, 0), (e.high, 1)):
        if f.q_edges[k]:
            inner = edge + (0.2, -0.2)[k] * (e.high - e.low)
            at, before = (made.problem.best_scale(q, np.log(f.s)) for q in (edge, inner))
            moved = (at - before) / (edge - inner) * (_EXTEND[k] - 1) * edge
            if abs(moved) > 0.25 * (high - low):
                return False
    return True


def falling(y):
    """The falling curve nearest to y, by least squares (pooled neighbours)."""
    values, counts = [], []
    for x in y:
        values.append(float(x))
        counts.append(1)
        while len(values) > 1 and values[-2] < values[-1]:
            v, c = values.pop(), counts.pop()
            values[-1] = (values[-1] * counts[-1] + v * c) / (counts[-1] + c)
            counts[-1] += c
    return np.repeat(values, counts)


def rest(t, y):
    """The end of consolidation in a run: the moment [s] from which the falling
    curve has less than 1 % of its whole fall to go, and whether the run is at
    rest: its last quarter falls by less than half of that."""
    g = falling(y)
    whole = g[0] - g[-1]
    k = int(np.argmax(g - g[-1] <= _REST * whole))
    last = t >= t[-1] - 0.25 * (t[-1] - t[0])
    slope = np.polyfit(t[last], y[last], 1)[0]
    return float(t[k]), bool(-slope * 0.25 * (t[-1] - t[0]) < 0.5 * _REST * whole and t[k] < 0.9 * t[-1])


def unpredictable(made):
    """Why nothing beyond the measured curve can be told, "" when it can: the best curve is off by far more than noise
    and packings explain, or charge or scale is where no further one was tried."""
    f, e = made.fit, made.problem.e
    if f.known and f.factor > _FAR:
        return f"the best curve is {f.factor:.1f} times as far off as noise and spread of packings explain"
    edge = 1e-3 * (e.high - e.low)
    for at, word in ((f.q < e.low + edge, "lowest"), (f.q > e.high - edge, "highest")):
        if at:
            return f"the charge of the best curve, {f.q:.4g} C, is the {word} tried"
    return ""


def end_of_consolidation(made):
    """Day of it with bounds; where the mean curve is not at rest at its end, it
    is only known to come later than the runs reach."""
    f, e = made.fit, made.problem.e
    if unpredictable(made):
        return {"reached": False, "days": None, "low": None, "high": None}
    charges = (f.q, *f.q_interval) if f.known else (f.q,)
    if not all(rest(e.t, e.mean(q))[1] for q in charges):
        day = f.s_interval[0] * e.end / DAY if f.known else None
        return {"reached": False, "days": None, "low": day, "high": None}
    values = np.log([max(rest(t, y)[0], 1e-12) for t, y in made.curves])
    middle, _ = e.scalar(values, f.q)
    day = f.s * np.exp(middle) / DAY
    if not f.known:
        return {"reached": True, "days": float(day), "low": None, "high": None}
    factor = student.ppf(0.5 + 0.5 * f.level, f.dof)
    bounds = []
    for q, logs, half in f.region:
        at, error = e.scalar(values, q)
        wide = np.hypot(half, factor * error)
        bounds += [logs + at - wide, logs + at + wide]
    return {"reached": True, "days": float(day), "low": float(np.exp(min(bounds)) / DAY),
            "high": float(np.exp(max(bounds)) / DAY)}


def band(made, days):
    """Fitted curve and its band over days: what a further packing would give,
    with charge and time scale anywhere in their region. Shapes (m,), heights
    over the first."""
    f, e = made.fit, made.problem.e
    tau = np.asarray(days) * DAY
    middle = e.at(e.mean(f.q), tau / f.s)
    if not f.known:
        return middle, np.full_like(middle, np.nan), np.full_like(middle, np.nan)
    ways = np.array([e.at(e.mean(q), tau * np.exp(-logs - sign * half))
                     for q, logs, half in f.region for sign in (-1, 0, 1)])
    one = student.ppf(0.5 + 0.5 * f.level, f.dof) * np.sqrt(
        np.interp(tau / f.s, e.t, e.variance) * (1 + e.leverage(f.q)) + made.problem.noise**2)
    return (middle, middle - np.hypot(one, middle - ways.min(axis=0)),
            middle + np.hypot(one, ways.max(axis=0) - middle))
