# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""profile.csv: what both halves have measured over height and time, in one table.

The DEM half writes solids.csv (fix settling/profile), the CFD half
CFD/postProcessing/fluid/*/fluid.dat (heightProfile), at the same times. The
fluid's rows are those of the mesh's layers: between them values are linear, and
beyond the outermost ones the slope goes on. The excess pore pressure is 0 at
the top of the tube.
"""

import csv
import glob
import os

import numpy as np

from cases.lib.case import files
from cases.lib.case.errors import CaseError

FLUID = ("void_fraction", "fluid_velocity_m_s", "fluid_flux_m_s", "excess_pressure_Pa", "permeability_m2")
_SOLIDS = 0.02   # solid fraction below which there is no permeability
_SLOPE = 0.02    # and slope of the pressure, over the solids' buoyant weight by volume


def solids(folder):
    """solids.csv's columns by name, shape (times, slices) each; time_s (times,) and height_m (slices,)."""
    path = os.path.join(folder, "solids.csv")
    with open(path, encoding="utf-8") as f:
        names, lines = f.readline().strip().split(","), [line for line in f if line.endswith("\n")]
    rows = [line.split(",") for line in lines]
    numbers = np.array([r for r in rows if len(r) == len(names)], dtype=float).reshape(-1, len(names))
    times, counts = np.unique(numbers[:, 0], return_counts=True)
    slices = int(counts.max()) if len(counts) else 0
    whole = np.isin(numbers[:, 0], times[counts == slices])
    numbers = numbers[whole].reshape(-1, max(slices, 1), len(names))
    if not numbers.size:
        raise CaseError(f"{path}: holds no profile")
    columns = {name: numbers[:, :, k] for k, name in enumerate(names)}
    columns["time_s"], columns["height_m"] = numbers[:, 0, 0], numbers[0, :, 1]
    return columns


def fluid(folder):
    """{time [s]: rows of height [m], n, n Uz [m/s], p [m2/s2]} of the CFD half."""
    found = {}
    for path in glob.glob(os.path.join(glob.escape(folder), "CFD", "postProcessing", "fluid", "*", "fluid.dat")):
        with open(path, encoding="utf-8") as f:
            for line in f:
                words = line.split()
                if line.endswith("\n") and len(words) == 5 and not line.startswith("#"):
                    found.setdefault(float(words[0]), []).append([float(w) for w in words[1:]])
    return {t: np.array(rows) for t, rows in found.items()}


def _at(heights, z, values):
    """Values at heights, linear between z and on beyond the ends."""
    found = np.interp(heights, z, values)
    if len(z) > 1:
        for outside, a, b in ((heights < z[0], 0, 1), (heights > z[-1], -1, -2)):
            found[outside] = values[a] + (heights[outside] - z[a]) * (values[b] - values[a]) / (z[b] - z[a])
    return found


def permeability(fraction, solid_velocity, flux, slope, viscosity, unit_weight):
    """Permeability [m2] by Darcy's law: flux of the fluid [m/s] against solids that move [m/s], slope of
    the excess pore pressure [Pa/m]; nan where there is next to nothing of one of them."""
    against = flux - (1 - fraction) * solid_velocity
    there = (fraction > _SOLIDS) & (np.abs(slope) > _SLOPE * unit_weight * fraction) & (against * slope < 0)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(there, -viscosity * against / slope, np.nan)


def joined(folder, values):
    """All columns, as of solids(), with the fluid's at those times that both have; nan at others."""
    columns = solids(folder)
    times, z = columns["time_s"], columns["height_m"]
    for name in FLUID:
        columns[name] = np.full((len(times), len(z)), np.nan)
    rows = fluid(folder)
    known = np.array(sorted(rows))
    density, height = values["fluid_density"], values["tube_height"]
    unit_weight = (values["density"] - density) * values["gravity"]
    for k, t in enumerate(times):
        near = known[np.argmin(np.abs(known - t))] if len(known) else np.inf
        if abs(near - t) > 0.5 * values["dem_step"] + 1e-6 * t:
            continue
        levels, n, flux, p = rows[near].T
        pressure = density * (_at(z, levels, p) - _at(np.array([height]), levels, p)[0])
        slope = density * np.gradient(p, levels) if len(levels) > 1 else np.zeros(len(levels))
        columns["void_fraction"][k] = np.clip(_at(z, levels, n), 0, 1)
        columns["fluid_flux_m_s"][k] = _at(z, levels, flux)
        columns["fluid_velocity_m_s"][k] = columns["fluid_flux_m_s"][k] / np.maximum(columns["void_fraction"][k], 1e-3)
        columns["excess_pressure_Pa"][k] = pressure
        moving = np.nan_to_num(columns["velocity_m_s"][k])
        # of the layers, in which the fluid knows no finer solids
        shares = [np.abs(z - level) <= 0.5 * height / len(levels) for level in levels]
        solid = np.array([np.average(moving[s], weights=columns["solid_fraction"][k][s] + 1e-12) if s.any() else 0.0
                          for s in shares])
        of_layers = permeability(1 - n, solid, flux, slope, values["viscosity"], unit_weight)
        columns["permeability_m2"][k] = of_layers[np.argmin(np.abs(z[:, None] - levels[None, :]), axis=1)]
    return columns


def write(folder, columns):
    """profile.csv: a row a slice and time."""
    names = list(columns)
    times, z = columns["time_s"], columns["height_m"]
    with files.writing(os.path.join(folder, "profile.csv"), newline="") as f:
        out = csv.writer(f, lineterminator="\n")
        out.writerow(names)
        for k, t in enumerate(times):
            for j, h in enumerate(z):
                out.writerow([f"{t:.9g}", f"{h:.7g}"] + [f"{columns[c][k][j]:.6g}" for c in names[2:]])


def read(folder):
    """profile.csv's columns, as of solids()."""
    path = os.path.join(folder, "profile.csv")
    with open(path, encoding="utf-8") as f:
        names = f.readline().strip().split(",")
        numbers = np.array([line.split(",") for line in f], dtype=float)
    slices = int(np.count_nonzero(numbers[:, 0] == numbers[0, 0]))
    numbers = numbers.reshape(-1, slices, len(names))
    columns = {name: numbers[:, :, k] for k, name in enumerate(names)}
    columns["time_s"], columns["height_m"] = numbers[:, 0, 0], numbers[0, :, 1]
    return columns


def imbalance(columns, last=1):
    """What contacts, charges, walls and excess pore pressure lack of the weight above, or have too much, over
    the whole weight, by slice: the mean of so many last times."""
    def mean(name):
        return np.mean(columns[name][-last:], axis=0)
    weight = mean("weight_Pa")
    carried = mean("contact_Pa") + mean("coulomb_Pa") + mean("wall_Pa") + mean("excess_pressure_Pa")
    return (carried - weight) / np.max(weight)
