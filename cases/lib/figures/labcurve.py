# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The curves of Figure 11: the user's, or made-up ones, and their time scale."""

import os
from dataclasses import dataclass

import numpy as np

from cases.lib.calibration import caldata
from cases.lib.case.errors import CaseError

SAMPLES = ("rp-04a", "rp-05a", "rp-07a", "rp-15a")
#: Packing and noise [m] of a made-up curve; seeds of the figures' runs are 1.
MADE_SEED, MADE_NOISE, MADE_ROWS = 1001, 5e-4, 66


@dataclass(frozen=True)
class Curve:
    """days and heights over that at the start, shape (m,); says where from."""

    days: np.ndarray
    y: np.ndarray
    says: str
    made_up: bool


def read(words):
    """{sample: Curve} of `--data [SAMPLE=]FILE`; a file whose name holds a
    sample's needs no SAMPLE."""
    found = {}
    for word in words or ():
        sample, sign, path = word.partition("=")
        if not sign:
            path = word
            name = os.path.basename(path).lower().replace("_", "-")
            sample = next((s for s in SAMPLES if s in name or s.replace("-", "") in name), "")
        sample = sample.strip().lower()
        if sample not in SAMPLES:
            raise CaseError(f"--data {word}: which sample? Use SAMPLE=FILE, SAMPLE one of {', '.join(SAMPLES)}")
        if sample in found:
            raise CaseError(f"--data {word}: a second curve for {sample}")
        if not os.path.isfile(path):
            raise CaseError(f"--data {path}: is not there")
        data = caldata.read(path)
        found[sample] = Curve(data.days, data.y, f"data: {os.path.basename(path)}", False)
    return found


def made_up(run, last):
    """A made-up curve from a run of another packing, up to day `last`: its
    interface with independent normal noise."""
    t, z = run.curve["time_s"], run.curve["interface_m"]
    days = np.linspace(0.0, min(last, t[-1] * run.days), MADE_ROWS)
    noise = MADE_NOISE * np.random.default_rng(MADE_SEED).standard_normal(days.size)
    z = np.interp(days / run.days, t, z) + noise
    return Curve(days, z / run.values["fill_height"], "made-up data, no measurement", True)


def time_scale(run, curve):
    """(time scale, rms misfit): the scale by which the run's curve comes nearest
    to the data, over the data's days that the run reaches, half of them at least."""
    t, y = run.curve["time_s"], run.curve["interface_m"] / run.values["fill_height"]

    def misfit(scale):
        reached = curve.days * caldata.DAY / scale <= t[-1]
        if np.count_nonzero(reached) < max(caldata.LEAST_ROWS, 0.5 * reached.size):
            return np.inf
        return float(np.sqrt(np.mean((np.interp(curve.days[reached] * caldata.DAY / scale, t, y)
                                      - curve.y[reached])**2)))

    scales = run.values["time_scale"] * np.geomspace(0.01, 100.0, 401)
    for _ in range(3):
        off = [misfit(s) for s in scales]
        best = int(np.argmin(off))
        low, high = scales[max(best - 1, 0)], scales[min(best + 1, len(scales) - 1)]
        found = scales[best], off[best]
        scales = np.geomspace(low, high, 41)
    return float(found[0]), found[1]
