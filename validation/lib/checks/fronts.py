# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Heights of the fronts of a settling column in a box, read from its dumps."""

import glob
import os

import numpy as np


def dumps(folder, step):
    """(time [s], heights of the spheres [m], their radius [m]) of each dump; step: the DEM's [s]."""
    for path in sorted(glob.glob(os.path.join(glob.escape(folder), "DEM", "spheres.*.dump"))):
        table = np.loadtxt(path, skiprows=9)
        yield int(path.split(".")[-2]) * step, table[:, 5], float(table[0, 9])


def solids_below(z, radius, area, edges):
    """Height of solids [m] below each edge [m]: spheres that an edge cuts count with their part below."""
    z = np.sort(z)
    whole, touched = np.searchsorted(z, edges - radius), np.searchsorted(z, edges + radius)
    below = whole.astype(float)
    for k in np.flatnonzero(touched > whole):
        x = (edges[k] - z[whole[k]:touched[k]]) / radius
        below[k] += np.sum(0.25 * (2 + 3 * x - x**3))
    return below * 4 / 3 * np.pi * radius**3 / area


def profile(z, radius, area, height, over=2):
    """Heights [m] and the solid fraction there, a mean over so many diameters."""
    part, wide = 0.25 * radius, 8 * over
    edges = np.arange(0.0, height + 6 * radius, part)
    below = solids_below(z, radius, area, edges)
    return edges[wide // 2:-wide // 2], (below[wide:] - below[:-wide]) / (wide * part)


def _crossing(z, phi, k, level):
    """Height between k and k + 1 at which phi falls through level."""
    return z[k] + (phi[k] - level) / (phi[k] - phi[k + 1]) * (z[k + 1] - z[k])


def fronts(folder, step, area, height, upper, bed, over=2):
    """(t, z_upper, z_bed): where the solid fraction falls through `upper` for the last time
    from below, and, as a mean over `over` diameters, first through `bed`; nan where it does not."""
    found = []
    for t, z, radius in dumps(folder, step):
        fine, phi = profile(z, radius, area, height)
        high = np.flatnonzero(phi > upper)
        top = _crossing(fine, phi, high[-1], upper) if high.size else np.nan
        at, phi = profile(z, radius, area, height, over)
        # a packing's own unevenness in the lowest two diameters is passed over
        low = np.flatnonzero((phi <= bed) & (at > max(3, over) * radius))
        k = low[0] - 1 if low.size else -1
        packed = k >= 0 and phi[k] > bed
        found.append((t, top, _crossing(at, phi, k, bed) if packed else np.nan))
    return np.array(found).T


def line(t, z, begin, end):
    """(slope [m/s], height at t = 0 [m]) of the least-squares line between two times."""
    inside = (t >= begin) & (t <= end) & np.isfinite(z)
    slope, at = np.polyfit(t[inside], z[inside], 1)
    return float(slope), float(at)


def packed(folder, step, area, height):
    """Solid fraction of the bed in the last dump, two diameters off its floor and its top."""
    *_, (_, z, radius) = dumps(folder, step)
    low, high = 4 * radius, np.max(z) - 5 * radius
    below = solids_below(z, radius, area, np.array([low, high]))
    return float((below[1] - below[0]) / (high - low))
