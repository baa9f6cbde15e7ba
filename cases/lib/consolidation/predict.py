# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What Gibson's theory makes of a run: its settlement, from the end of its first stage and from its start."""

import json
import os
from dataclasses import dataclass

import numpy as np

from cases.lib.calibration import stagefit
from cases.lib.case.errors import CaseError
from cases.lib.case.places import called
from cases.lib.consolidation import lawfit
from cases.lib.output import profile
from cases.lib.run import runs
from cases.lib.theory import carrying, gibson

LEAST = 2.0      # sphere diameters of fall after the first stage, below which there is nothing to fit
_NEEDED = ("sphere_radius", "density", "fluid_density", "gravity", "viscosity", "fill_height", "solid_fraction")
_CELLS = 60


@dataclass(frozen=True)
class Run:
    """A run that has ended: folder, title, settings, curve and profile by columns, the end of its first stage and
    the begin of consolidation [s]."""

    folder: str
    title: str
    settings: dict
    curve: dict
    columns: dict
    stage: float
    begin: float

    @property
    def diameter(self):
        """Of the spheres [m]."""
        return 2 * self.settings["sphere_radius"]

    @property
    def weight(self):
        """Buoyant weight of a volume of solids [N/m3]."""
        s = self.settings
        return (s["density"] - s["fluid_density"]) * s["gravity"]

    @property
    def fall(self):
        """The interface's whole fall [m]."""
        return float(self.curve["interface_m"][0] - self.curve["interface_m"][-1])

    @property
    def fallen(self):
        """The interface's fall [m] after the first stage."""
        t, z = self.curve["time_s"], self.curve["interface_m"]
        return float(np.interp(self.stage, t, z) - z[-1])


@dataclass(frozen=True)
class Curve:
    """A computed settlement: times [s], beyond the run's end, interface and mean height [m]; the interface when all
    excess pressure is gone; when 90 % of the fall to it from the end of the first stage is done, or None."""

    times: np.ndarray
    interface: np.ndarray
    mean: np.ndarray
    final: float
    time_90: float


def read(folder):
    """The Run of a folder; CaseError where it has no profile or did not compress."""
    try:
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as f:
            summary = json.load(f)
        settings, title = summary["settings"], str(summary.get("title", summary["case"]))
    except (OSError, ValueError, KeyError, TypeError):
        raise CaseError(f"{folder}: holds no summary.json of a run; {called('report')} makes it") from None
    if summary.get("complete") is False:
        raise CaseError(f"{folder}: is not complete: {summary.get('reason', 'it was stopped')}")
    lacking = [k for k in _NEEDED if not isinstance(settings.get(k), (int, float))]
    if lacking:
        raise CaseError(f"{folder}: is no column: its settings lack {lacking[0]}")
    try:
        columns = profile.read(folder)
    except OSError:
        raise CaseError(f"{folder}: holds no profile.csv; make the run with this version") from None
    curve = runs.curve(folder)
    stages = stagefit.of(curve["time_s"], curve["interface_m"], samples=0)
    if stages.count < 2:
        raise CaseError(f"{folder}: its curve has one stage, no consolidation is told from settling; run longer")
    _, _, begin, _ = carrying.of_profile(columns)
    if begin is None:
        raise CaseError(f"{folder}: contacts and charges carry less than half of the weight at the bottom to the end; "
                        "run longer")
    run = Run(folder, title, settings, curve, columns, float(stages.breaks[0]), float(begin))
    if run.fallen < LEAST * run.diameter:
        raise CaseError(f"{folder}: after its first stage, {run.stage:.4g} s, the interface falls by "
                        f"{1e3 * run.fallen:.3g} mm, {run.fallen / run.diameter:.2g} sphere diameters; {LEAST:g} are "
                        "needed to fit a compressibility: take more viscosity (regime=stokes) or height, or run longer")
    return run


def _curve(run, laws, walls, z, start, times):
    weight = run.weight * (1 - walls)
    try:
        found = gibson.solve(laws, z, start, times, weight)
    except ValueError as e:
        raise CaseError(f"{run.folder}: {e}") from None
    rest = gibson.Consolidation(np.zeros(1), z, gibson.at_rest(laws, z, weight)[None, :])
    radius = run.settings["sphere_radius"]
    interface, final = found.interface(radius=radius), float(rest.interface(radius=radius)[0])
    after = times >= run.stage
    return Curve(times, interface, found.mean_height(), final, gibson.time_of(times[after], interface[after], final))


def _times(begin, end, stage):
    """From begin to a run's end, and on to twenty times as long after its first stage."""
    return np.concatenate([np.linspace(begin, end, 300), end + (end - stage) * np.geomspace(0.01, 20, 200)])


def from_stage(run, laws, walls):
    """From the run's own void ratios at the end of its first stage on."""
    at = float(run.columns["time_s"][np.argmin(np.abs(run.columns["time_s"] - run.stage))])
    z, start = lawfit.state(run.columns, run.diameter, at, _CELLS)
    return _curve(run, laws, walls, z, start, _times(at, run.curve["time_s"][-1], run.stage))


def from_start(run, laws, walls):
    """From the even suspension; of the run its height and solids alone are known."""
    phi = run.settings["solid_fraction"]
    z = np.linspace(0, phi * run.settings["fill_height"], _CELLS + 1)
    return _curve(run, laws, walls, z, np.full(_CELLS, (1 - phi) / phi),
                  _times(0.0, run.curve["time_s"][-1], run.stage))


def errors(run, curve):
    """How far a computed interface is from the run's after its first stage [m]: root mean square, and at the end."""
    t, z = run.curve["time_s"], run.curve["interface_m"]
    after = t >= max(run.stage, curve.times[0])
    off = np.interp(t[after], curve.times, curve.interface) - z[after]
    return float(np.sqrt(np.mean(off**2))), float(off[-1])


def simulated_90(run):
    """When 90 % of the run's own fall after its first stage is done [s]."""
    t, z = run.curve["time_s"], run.curve["interface_m"]
    after = t >= run.stage
    return gibson.time_of(t[after], z[after], float(np.min(z[after])))


def falling(run):
    """Part of its fall after the first stage that a run does in its last tenth of time."""
    t, z = run.curve["time_s"], run.curve["interface_m"]
    return float((np.interp(t[-1] - 0.1 * (t[-1] - run.stage), t, z) - z[-1]) / run.fallen)
