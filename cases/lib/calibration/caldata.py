# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Measured settling curves: reading, stages, noise, and made-up ones."""

import math
import os
from dataclasses import dataclass

import numpy as np

from cases.lib.calibration import curvefile, stagefit
from cases.lib.case.casefile import text
from cases.lib.case.errors import CaseError
from cases.lib.run import runs

DAY = 86400.0
_MADE_UP = "# made up, not measured:"
LEAST_ROWS = 12  # what the search for stages wants


@dataclass(frozen=True)
class Data:
    """A measured curve. days, height shape (m,); height0 is what heights are
    divided by; y the result; stage 1 ... of each point; breaks [days] between
    the stages, slopes [height/day] of them."""

    path: str
    days: np.ndarray
    height: np.ndarray
    height0: float
    stage: np.ndarray
    breaks: np.ndarray
    slopes: np.ndarray

    @property
    def y(self):
        return self.height / self.height0

    @property
    def used(self):
        """The points of stages 1 and 2."""
        return self.stage <= 2

    @property
    def noise(self):
        """Standard deviation of y's noise, from how far each point lies off
        the line between its neighbours; half of the points may lie at bends."""
        t, y = self.days, self.y
        part = (t[1:-1] - t[:-2]) / (t[2:] - t[:-2])
        off = y[1:-1] - (1 - part) * y[:-2] - part * y[2:]
        off /= np.sqrt(1 + part**2 + (1 - part)**2)
        return float(1.4826 * np.median(np.abs(off)))


def read(path, height0=None):
    """A CSV of days and heights; # starts a comment, one line of names may lead."""
    rows = []
    for number, cells in curvefile.rows(path, f"--data {path}")[1]:
        where, line = f"--data {path}, line {number}", ",".join(cells)
        if len(cells) != 2:
            raise CaseError(f"{where}: '{line}': must be days and height with a comma between")
        try:
            row = [float(c) for c in cells]
        except ValueError:
            raise CaseError(f"{where}: '{line}': must be two numbers, days and height") from None
        if not all(math.isfinite(x) for x in row):
            raise CaseError(f"{where}: '{line}': must be finite numbers")
        if row[0] < 0:
            raise CaseError(f"{where}: day {text(row[0])}: must be 0 or more")
        if row[1] <= 0:
            raise CaseError(f"{where}: height {text(row[1])}: must be above 0")
        if rows and row[0] <= rows[-1][0]:
            raise CaseError(f"{where}: day {text(row[0])} does not come after day {text(rows[-1][0])}")
        rows.append(row)
    if len(rows) < LEAST_ROWS:
        raise CaseError(f"--data {path}: {len(rows)} rows; must be at least {LEAST_ROWS}")
    if height0 is not None and not height0 > 0:
        raise CaseError(f"--height0 {height0}: must be above 0")
    days, height = np.array(rows).T
    data = of(path, days, height, height0 or float(height[0]))
    if data.slopes[0] >= 0:
        raise CaseError(f"--data {path}: the curve does not fall in its first stage, up to day "
                        f"{text(data.days[data.stage == 1][-1])}; it must settle")
    return data


def of(path, days, height, height0):
    """A Data with its stages found; a slow start counts as part of the first."""
    found = stagefit.of(days, height, samples=0)
    stage = 1 + np.searchsorted(found.breaks, days, side="right")
    return Data(path, days, height, height0, stage, found.breaks, found.slopes)


def check_new(path):
    """Refuses to write over a file that `make` has not written."""
    if os.path.isdir(path):
        raise CaseError(f"--make-data {path}: is a folder; name a file")
    if os.path.exists(path):
        with open(path, encoding="utf-8", errors="replace") as f:
            if not f.readline().startswith(_MADE_UP):
                raise CaseError(f"--make-data {path}: is there and was not made by this program; name a new file")


def make(path, name, changes, curve, height0, time_scale, noise, seed, rows):
    """Writes a made-up measurement: a run's curve, its time stretched by
    time_scale, with independent normal noise [m]. Its name: see check_new."""
    t = np.linspace(0.0, curve["time_s"][-1], rows)
    z = np.interp(t, curve["time_s"], curve["interface_m"])
    z += noise * np.random.default_rng(seed).standard_normal(rows)
    os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
    with open(path, "w", encoding="utf-8") as f:
        f.write(f"{_MADE_UP} the case {name} with {runs.words(changes)}\n"
                f"# time_scale={text(time_scale)}, noise of {text(noise)} m; take --height0 {text(height0)}\n"
                "days,height_m\n")
        f.writelines(f"{d:.8g},{h:.8g}\n" for d, h in zip(t * time_scale / DAY, np.maximum(z, 1e-6)))
