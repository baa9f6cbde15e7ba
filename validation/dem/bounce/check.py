# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""MFiX-DEM's case DEM02: heights of six bounces for three stiffnesses and six restitutions."""

import os

import numpy as np

from validation.lib.checks import coupled, plots, reference

TITLE = "heights of bounces on a floor (MFiX DEM02)"
RADIUS, START, GRAVITY, MASS = 0.1, 0.5, 9.81, 2600 * np.pi / 6 * 0.2 ** 3


def rebound(v, kn, gamma):
    """Speed after the impact at v of a linear contact under gravity, and its duration."""
    b, w = gamma / (2 * MASS), np.sqrt(kn / MASS - (gamma / (2 * MASS)) ** 2)
    rest = MASS * GRAVITY / kn     # overlap at rest

    def overlap(t):
        # x'' + 2b x' + k/m x = g, x(0) = 0, x'(0) = v
        return rest + np.exp(-b * t) * (-rest * np.cos(w * t) + (v - b * rest) / w * np.sin(w * t))
    low, high = 0.5 * np.pi / w, 0.5 * np.pi / w
    while overlap(high) > 0:
        high += 0.001 * np.pi / w
        if high > 2 * np.pi / w:
            return None, None      # stays in contact
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if overlap(middle) > 0 else (low, middle)
    step = 1e-6 / w
    return -(overlap(low + step) - overlap(low - step)) / (2 * step), low


def heights(kn, gamma, bounces):
    """Exact heights after each bounce, and the time they take."""
    h, time, found = START, 0.0, []
    for _ in range(bounces):
        v = np.sqrt(2 * GRAVITY * (h - RADIUS))
        u, lasts = rebound(v, kn, gamma)
        if u is None:
            break
        found.append(RADIUS + u * u / (2 * GRAVITY))
        time += v / GRAVITY + lasts + u / GRAVITY
        h = found[-1]
    return found, time


def run(checks):
    r = reference.table("mfix_dem02_bounce_height")
    curves, mfix = [], []
    for kn in np.unique(r["kn_N_per_m"]):
        for e in np.unique(r["restitution"])[::-1]:
            of = (r["kn_N_per_m"] == kn) & (r["restitution"] == e) & (r["bounce"] > 0)
            gamma = -2 * np.log(e) / np.hypot(np.pi, np.log(e)) * np.sqrt(MASS * kn)
            exact, time = heights(kn, gamma, 6)
            dt = np.pi * np.sqrt(MASS / kn) / 600
            folder = coupled.dem("bounce", f"bounce/{kn:.0f}-{e:g}", kn=kn, gamman=repr(gamma / MASS), dt=repr(dt),
                                 steps=int((time + 0.05) / dt), every=max(1, int(2e-4 / dt)))
            t = coupled.columns(os.path.join(folder, "DEM", "trajectory.csv"))
            s, z, v = (np.array(t[k]) for k in ("time_s", "z_m", "v_m_per_s"))
            # between two rows it flies: its top from either
            tops = np.flatnonzero((v[:-1] > 0) & (v[1:] <= 0) & (z[:-1] > RADIUS))
            found = (z[tops] + v[tops] ** 2 / (2 * GRAVITY))[:6]
            name = f"k = {kn:g} N/m, e = {e:g}"
            # a soft floor that takes much lets the sphere go no more after some bounces
            if not checks.equal(f"{name}: bounces", len(found), len(exact)):
                continue
            checks.at_most(f"{name}: largest error of the heights, to the exact spring",
                           np.max(np.abs(found / exact - 1)), 0.01)
            mfix.append(np.max(np.abs(found / r["height_mfix_m"][of][:len(found)] - 1)))
            if kn == 5e6:
                checks.at_most(f"{name}: largest error of the heights, to hard spheres",
                               np.max(np.abs(found / r["height_analytic_m"][of] - 1)), 0.01)
                if e in (1, 0.8, 0.5):
                    curves += [(f"e = {e:g}", s[::20], z[::20], "line"),
                               ("hard spheres" if e == 1 else None, s[tops][:6], r["height_analytic_m"][of], "dots")]
    checks.note(f"MFiX's own heights lie within {100 * max(mfix):.1f} % of these, those at k = 5e6 N/m within "
                f"{100 * max(mfix[-6:]):.1f} %; a softer floor lies below the hard spheres' heights, "
                "as the exact spring does, by up to 8 %.")
    checks.picture(plots.compare(os.path.join(coupled.RUNS, "bounce", "height.png"), curves,
                                 "time [s]", "height of the centre [m]", "bounces, k = 5 MN/m"))
