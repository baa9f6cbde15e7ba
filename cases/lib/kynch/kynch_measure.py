# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Fronts, speeds and times of meeting of a run's column, read alike for all.

The interface of Kynch's theory is a shock. In a run it is smeared, so two
readings are taken: the top of the solids (interface_m of settling.csv), and
the height at which the solid fraction, averaged over two diameters, falls
through half of phi_0, the place of a smeared shock. The bed's front is where
it falls through the middle between phi_0 and the bed's. Both are read from the
dumps, since bed_m of settling.csv stands for a solid fraction of 0.2, which a
dense suspension has by itself.

Speeds are least-squares slopes over a window that no curve's looks decide: from
when the start-up from rest is over (theory.startup, within 1 %) to when the
interface has come 80 % of its way to the bed's final height. From there on
little suspension is left between interface and bed.
"""

import json
import os

import numpy as np

from cases.lib.case.errors import CaseError
from cases.lib.case.places import called
from cases.lib.output import spheres
from cases.lib.run import runs

#: Part of the interface's way at which the window ends.
LAST = 0.8

# of a run's settings; without the particles', of which kynch_column.refuse tells
_NEEDED = ("seed", "end", "drag", "solid_fraction", "fill_height", "tube_radius", "tube_height", "density",
           "fluid_density", "viscosity", "dem_step")


class Record:
    """A finished run: values, settling.csv as t, top, bed_m, mean [s, m]."""

    def __init__(self, folder):
        self.folder = folder
        try:
            with open(os.path.join(folder, "summary.json"), encoding="utf-8") as f:
                summary = json.load(f)
            self.case, self.values = summary["case"], summary["settings"]
            self.title = summary.get("title", self.case)
            missing = [k for k in _NEEDED if k not in self.values]
        except OSError:
            raise CaseError(f"{folder}: holds no summary.json; name the folder of a finished run of "
                            f"{called('run')}") from None
        except (ValueError, KeyError, TypeError):
            raise CaseError(f"{folder}/summary.json: was not written by {called('run')}") from None
        if summary.get("complete") is False:
            raise CaseError(f"{folder}: is not complete: {summary.get('reason', 'it was stopped')}; "
                            "name a finished run")
        if missing:
            raise CaseError(f"{folder}/summary.json: has no setting {missing[0]}; "
                            "name a run of a column of spheres")
        rows = runs.curve(folder)
        if "mean_height_m" not in rows:
            raise CaseError(f"{folder}/settling.csv: has no column mean_height_m")
        self.t, self.top, self.mean = rows["time_s"], rows["interface_m"], rows["mean_height_m"]
        self.seed = self.values["seed"]

    def settled(self):
        """Height [m] of the bed at the end; CaseError when it still sinks."""
        end = self.t > 0.95 * self.t[-1]
        final = float(np.mean(self.top[end]))
        if np.ptp(self.top[end]) > 0.02 * final:
            raise CaseError(f"{self.folder}: the column does not rest at its end, {self.t[-1]:g} s: "
                            f"take a longer one, --set end={1.5 * self.t[-1]:.3g}")
        return final

    @property
    def packed(self):
        """Solid fraction of the settled bed, two diameters off its floor and its top, where single spheres stand
        out; of a bed below six diameters, its mean."""
        v, top = self.values, self.settled()
        edge = 4 * v["sphere_radius"]
        if top < 3 * edge:
            return v["solid_fraction"] * v["fill_height"] / top
        *_, (_, path) = spheres.dumps(self.folder)
        low, high = profile(spheres.read(path), v["sphere_radius"], np.pi * v["tube_radius"]**2,
                            np.array([edge, top - edge]))
        return float(high - low) / (top - 2 * edge)


def profile(s, radius, area, edges):
    """Solids volume [m3] below each edge [m] over the cross-section's area
    [m2], so a height of solids: exact for spheres that the edges cut."""
    order = np.argsort(s["z"])
    z = s["z"][order]
    whole = np.searchsorted(z, edges - radius)
    touched = np.searchsorted(z, edges + radius)
    volume = 4 / 3 * np.pi * radius**3
    below = whole * volume
    for k in np.flatnonzero(touched > whole):
        x = (edges[k] - z[whole[k]:touched[k]]) / radius
        below[k] += np.sum(0.25 * (2 + 3 * x - x**3)) * volume
    return below / area


def _crossing(z, phi, k, level):
    """Height between samples k and k + 1 where phi is level."""
    step = phi[k + 1] - phi[k]
    return z[k] + (level - phi[k]) / step * (z[k + 1] - z[k]) if step else z[k]


def fronts(record, phi_m):
    """(t, interface, bed) of the dumps, shape (m,) [s, m]: heights of the
    smeared shocks; bed is nan while it is thinner than two diameters."""
    v = record.values
    radius, phi_0 = v["sphere_radius"], v["solid_fraction"]
    step, wide = 0.25 * radius, 16
    edges = np.arange(0.0, v["tube_height"] + 6 * radius, step)
    z = edges[wide // 2:-wide // 2]
    found = []
    for number, path in spheres.dumps(record.folder):
        below = profile(spheres.read(path), radius, np.pi * v["tube_radius"]**2, edges)
        phi = (below[wide:] - below[:-wide]) / (wide * step)
        high = np.flatnonzero(phi > 0.5 * phi_0)[-1]
        level = 0.5 * (phi_0 + phi_m)
        packed = phi > level
        end = int(np.argmin(packed)) - 1 if packed[0] else -1
        bed = _crossing(z, phi, end, level) if end >= 0 else np.nan
        found.append((number * v["dem_step"], _crossing(z, phi, high, 0.5 * phi_0),
                      bed if bed > 4 * radius else np.nan))
    return np.array(found).T


def line(t, z, inside):
    """(slope, height at t = 0) of the least-squares line; nan with no points."""
    inside = inside & np.isfinite(z)
    if np.count_nonzero(inside) < 4:
        return np.nan, np.nan
    slope, height = np.polyfit(t[inside], z[inside], 1)
    return float(slope), float(height)


class Measured:
    """What is read from one run, held against one kynch_column.Column.

    numbers  the quantities by name, SI units
    """

    def __init__(self, record, column):
        self.record, self.column = record, column
        self.t, self.interface, self.bed = fronts(record, column.phi_m)
        height, final = column.height, column.kynch.final_height
        begin, stop = column.start.settled, height - LAST * (height - final)
        self.window = begin, float(record.t[np.argmax(record.top < stop)])

        def inside(t, a=0.0, b=1.0):
            return (t >= begin + a * (self.window[1] - begin)) & (t <= begin + b * (self.window[1] - begin))

        if np.count_nonzero(inside(self.t)) < 8:
            remedy = "take more of them, --set frames=N"
            if not np.any(record.top < stop):
                remedy = "the run ends too early, take a longer one, --set end=T"
            raise CaseError(f"{record.folder}: fewer than 8 dumps between {begin:.3g} and {self.window[1]:.3g} s, "
                            f"the window of the fit: {remedy}")
        t, top = record.t, record.top
        shock = line(self.t, self.interface, inside(self.t))
        bed = line(self.t, self.bed, inside(self.t))
        whole = line(t, top, inside(t))
        self.lines = shock, bed
        meet = (bed[1] - shock[1]) / (shock[0] - bed[0])
        k, late = column.kynch, column.late
        shown = t <= k.t_c + column.start.lag

        def rms(a, b):
            return float(np.sqrt(np.mean((a - b)[shown]**2)))

        self.numbers = {
            "interface_speed": -shock[0],
            "interface_speed_early": -line(self.t, self.interface, inside(self.t, 0, 0.5))[0],
            "interface_speed_late": -line(self.t, self.interface, inside(self.t, 0.5, 1))[0],
            "top_speed": -whole[0],
            "top_speed_early": -line(t, top, inside(t, 0, 0.5))[0],
            "top_speed_late": -line(t, top, inside(t, 0.5, 1))[0],
            "bed_speed": bed[0],
            "lag": (shock[1] - height) / -shock[0],
            "meeting_time": meet,
            "meeting_height": bed[1] + bed[0] * meet,
            "rms_over_height": rms(top, k.interface(t)) / height,
            "rms_over_height_late": rms(top, k.interface(late(t))) / height,
            "mean_height_rms_late": rms(record.mean, k.mean_height(late(t), 400)) / height,
            "packed": record.packed,
        }
