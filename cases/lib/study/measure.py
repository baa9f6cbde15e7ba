# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What the study reads from a run."""

import json
import os
from dataclasses import dataclass

import numpy as np

from cases.lib.calibration import stagefit
from cases.lib.output import profile
from cases.lib.run import runs
from cases.lib.theory import carrying

#: The paper's three stages end after so many days, the first as in the laboratory.
PAPER_DAYS = (10.0, 130.0, 703.0)
_LEFT = 0.01     # of the whole fall
_DRAINED = 0.05  # of the whole weight


@dataclass(frozen=True)
class Measured:
    """Of one run, SI units; None where there is none.

    stages, slope_1, slope_2    number of near-linear stages, falling speeds
    first                       end of the first stage
    height_1, height            interface then, and at the end
    done                        from when on less than 1 % of the whole fall is left
    drained                     from when on the excess pore pressure at the floor is below 5 % of the weight
    falling                     falling speed in the last tenth of the time
    half                        from when on stresses carry over half of the weight at the bottom
    reynolds                    largest of the run
    end                         of the run
    """

    stages: int
    slope_1: float
    slope_2: float
    first: float
    height_1: float
    height: float
    done: float
    drained: float
    falling: float
    half: float
    reynolds: float
    end: float

    @property
    def ratio(self):
        """Whole settling over the first stage, which the paper has as 70."""
        return None if self.first is None else self.done / self.first


def from_then_on(times, held):
    """The first of the times from which on it is held to the end, None where it is not."""
    lacking = np.nonzero(~held)[0]
    first = lacking[-1] + 1 if lacking.size else 0
    return float(times[first]) if first < len(times) else None


def of(folder):
    """The Measured of a run."""
    curve, columns = runs.curve(folder), profile.read(folder)
    t, z = curve["time_s"], curve["interface_m"]
    stages = stagefit.of(t, z, samples=0)
    first = float(stages.breaks[0]) if stages.count > 1 else None
    last = t > t[-1] - 0.1 * (t[-1] - t[0])
    pressure = carrying.smoothed(columns["excess_pressure_Pa"])[:, 0]
    weight = float(np.max(columns["weight_Pa"]))
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as f:
        reynolds = json.load(f)["reynolds_max"]
    return Measured(
        stages.count, float(-stages.slopes[0]), float(-stages.slopes[1]) if stages.count > 1 else None, first,
        float(np.interp(first, t, z)) if first else None, float(z[-1]),
        from_then_on(t, z - z[-1] <= _LEFT * (z[0] - z[-1])),
        from_then_on(columns["time_s"], np.nan_to_num(pressure) < _DRAINED * weight),
        float(-np.polyfit(t[last], z[last], 1)[0]), carrying.of_profile(columns)[2], float(reynolds), float(t[-1]))
