# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Compressibility e(s) and permeability kappa(e) of a sediment from a run's own profiles.

e is that of the solid fraction, a mean over the slices of four sphere diameters (clumps lie in layers); s what
contacts and charges carry, a median over five times. Points count from the begin of consolidation on, where s is
above 2 % of the whole weight and something is above; next to the floor, within two diameters, layers lie otherwise
than in the bed. kappa is that of the profile, which knows one for each layer of the mesh, at the mean e there, over all
times, up to the suspension's e. Both laws are least squares of the logarithms; intervals (95 %) from drawing whole
slices, and whole layers, anew: times of one slice are no independent points.
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

from cases.lib.case.errors import CaseError
from cases.lib.theory import carrying
from cases.lib.theory.gibson import PowerLaws

_WINDOW, _FLOOR = 4.0, 2.0   # diameters
_LEAST = 0.02                # of the whole weight
_POINTS = 30
_TOP = 0.99                  # quantile of the points' void ratios that the gel point may have
STEEPEST = 20.0              # B beyond which the law is as good as an exponential
_LOOSEST = 200.0             # void ratio above which solids are strays


@dataclass(frozen=True)
class Points:
    """What laws are fitted to: of each point the void ratio, the value, the slice (or layer) it is of."""

    e: np.ndarray
    value: np.ndarray
    of: np.ndarray


@dataclass(frozen=True)
class Fit:
    """The laws, their intervals {name: (low, high)}, the points, the laws' misfit {law: rms of the logarithm},
    the part of the weight that walls hold, and the range {law: (lowest, highest e)} of the points."""

    laws: PowerLaws
    intervals: dict
    compression: Points
    flow: Points
    misfit: dict
    walls: float

    def range_of(self, law):
        """Lowest and highest void ratio of the points."""
        e = (self.compression if law == "compressibility" else self.flow).e
        return float(np.min(e)), float(np.max(e))


def _even(rows, width):
    """The mean over so many slices, of rows (times, slices); fewer at the ends."""
    half = width // 2
    total = np.cumsum(np.pad(rows, ((0, 0), (half + 1, half)), mode="constant"), axis=1)
    counts = np.cumsum(np.pad(np.ones(rows.shape[1]), (half + 1, half), mode="constant"))
    span = 2 * half + 1
    return (total[:, span:] - total[:, :-span]) / (counts[span:] - counts[:-span])


def window(columns, diameter):
    """An odd number of slices, as thick as four diameters if need be."""
    z = columns["height_m"]
    slices = _WINDOW * diameter / (z[1] - z[0])
    return max(1, 2 * math.floor(slices / 2) + 1)


def fractions(columns, diameter):
    """Solid fractions (times, slices), smooth in time and height."""
    return _even(carrying.smoothed(columns["solid_fraction"]), window(columns, diameter))


def compression_points(columns, diameter, begin):
    """Points of the compressibility: e and effective stress [Pa]."""
    phi = fractions(columns, diameter)
    stress = carrying.smoothed(columns["contact_Pa"] + columns["coulomb_Pa"])
    weight = carrying.smoothed(columns["weight_Pa"])
    z = columns["height_m"]
    there = (stress > _LEAST * np.max(weight)) & (phi > 1 / (1 + _LOOSEST)) & (weight > _LEAST * np.max(weight))
    there &= (columns["time_s"] >= begin)[:, None] & (z > _FLOOR * diameter)[None, :]
    where = np.nonzero(there)
    return Points((1 - phi[where]) / phi[where], stress[where], where[1])


def flow_points(columns, suspension):
    """Points of the permeability: e and kappa [m2], a mean over the slices that have the same; none looser than the
    suspension was, which are slices half empty."""
    kappa, phi = columns["permeability_m2"], columns["solid_fraction"]
    e, value, layer = [], [], []
    for k in range(len(kappa)):
        edges = np.concatenate([[0], np.nonzero(np.diff(kappa[k]))[0] + 1, [kappa.shape[1]]])
        for a, b in zip(edges[:-1], edges[1:]):
            mean = float(np.mean(phi[k, a:b]))
            if np.isfinite(kappa[k, a]) and mean > 0.95 / (1 + suspension):
                e.append((1 - mean) / mean)
                value.append(kappa[k, a])
                layer.append(a)
    return Points(np.array(e), np.array(value), np.array(layer, dtype=int))


def _compressibility(points, suspension):
    """(A, B, Z) of log e = log A - B log(s + Z), by least squares that strays do not pull; at s = 0 no looser
    than the suspension was, or the loosest of the points."""
    log_e, s = np.log(points.e), points.value
    middle = float(np.median(s))

    def off(x):  # log of e at s = 0, B, log Z
        return x[0] - x[1] * np.log1p(s / math.exp(x[2])) - log_e

    best, top = None, max(math.log(suspension), float(np.quantile(log_e, _TOP)))
    for part in (1e-3, 1e-1, 1.0):
        bounds = [top - 10, 1e-3, math.log(1e-4 * middle)], [top, STEEPEST, math.log(1e2 * middle)]
        found = least_squares(off, [top - 0.1, 0.3, math.log(part * middle)], loss="soft_l1", f_scale=0.2,
                              bounds=bounds)
        best = found if best is None or found.cost < best.cost else best
    level, b, z = best.x
    return math.exp(level + b * z), b, math.exp(z)


def _permeability(points):
    """(C, D) of log kappa = log C + D log e."""
    x, y = np.log(points.e), np.log(points.value)
    found = least_squares(lambda p: p[0] + p[1] * (x - x.mean()) - y, [y.mean(), 2.0], loss="soft_l1", f_scale=0.3)
    return math.exp(found.x[0] - found.x[1] * x.mean()), float(found.x[1])


def _drawn(points, rng):
    """Points of slices drawn anew."""
    every = np.unique(points.of)
    rows = np.concatenate([np.nonzero(points.of == k)[0] for k in rng.choice(every, len(every))])
    return Points(points.e[rows], points.value[rows], points.of[rows])


def wall_share(columns, begin):
    """Part of the weight above that walls hold, over all heights from the begin of consolidation on."""
    after = columns["time_s"] >= begin
    weight = np.sum(columns["weight_Pa"][after])
    return float(np.clip(np.sum(columns["wall_Pa"][after]) / max(weight, 1e-300), 0.0, 0.95))


def fit(columns, settings, begin, samples=100, seed=1):
    """The Fit of a run's profile; settings of the run, begin of consolidation [s]."""
    diameter, viscosity = 2 * settings["sphere_radius"], settings["viscosity"]
    suspension = 1 / settings["solid_fraction"] - 1
    compression, flow = compression_points(columns, diameter, begin), flow_points(columns, suspension)
    for points, what in ((compression, "effective stress"), (flow, "permeability")):
        if len(points.e) < _POINTS or np.ptp(np.log(points.e)) < 0.1:
            span = math.exp(np.ptp(np.log(points.e))) if len(points.e) else 1
            raise CaseError(f"{len(points.e)} points of {what} in profile.csv, over void ratios by a factor of "
                            f"{span:.3g}; {_POINTS} and 1.1 are needed: run longer, or with more profile_rows")
    a, b, z = _compressibility(compression, suspension)
    c, d = _permeability(flow)
    laws = PowerLaws(a, b, z, c, d, viscosity)
    rng, drawn = np.random.default_rng(seed), []
    for _ in range(samples):
        drawn.append([*_compressibility(_drawn(compression, rng), suspension), *_permeability(_drawn(flow, rng))])
    low, high = np.quantile(np.array(drawn), (0.025, 0.975), axis=0) if samples else np.full((2, 5), np.nan)
    misfit = {
        "compressibility": float(np.sqrt(np.mean(np.log(laws.void_ratio(compression.value) / compression.e)**2))),
        "permeability": float(np.sqrt(np.mean(np.log(laws.permeability(flow.e) / flow.value)**2)))}
    return Fit(laws, {k: (float(x), float(y)) for k, x, y in zip("ABZCD", low, high)}, compression, flow, misfit,
               wall_share(columns, begin))


def state(columns, diameter, time, cells=60):
    """(faces z [m of solids], void ratios) of a run's profile at that time, in cells of equal solids."""
    k = int(np.argmin(np.abs(columns["time_s"] - time)))
    phi = np.maximum(fractions(columns, diameter)[k], 0.0)
    height = columns["height_m"][1] - columns["height_m"][0]
    solids = np.concatenate([[0.0], np.cumsum(phi * height)])
    # above that there are strays
    whole = solids[-1]
    edges = height * np.arange(len(phi) + 1)
    keep = np.concatenate([[True], np.diff(solids) > 1e-4 * whole])
    z = np.linspace(0, whole, cells + 1)
    x = np.interp(z, solids[keep], edges[keep])
    return z, np.maximum(np.diff(x) / np.diff(z) - 1.0, 0.3)
