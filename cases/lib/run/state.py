# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The state of a run, said in summary.json: complete or not, how far it came, and why it ended."""

import json
import os

from cases.lib.case import files
from cases.lib.run import folders

UNDER_WAY = "it is under way, or what ran it was killed"


def _read(folder, *names):
    """A half's measures, {} without."""
    try:
        with open(os.path.join(folder, *names), encoding="utf-8") as f:
            found = json.load(f)
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


def halves(folder):
    """What both halves measured, {} of one that did not come to its end."""
    return _read(folder, "DEM", "dem.json"), _read(folder, "CFD", "cfd.json")


def reached(folder):
    """The simulated time [s] a run came to: by the DEM half's measures, else by the last whole row of its curve."""
    dem = halves(folder)[0]
    if isinstance(dem.get("simulated_s"), (int, float)):
        return float(dem["simulated_s"])
    try:
        with open(os.path.join(folder, "settling.csv"), encoding="utf-8", errors="replace") as f:
            rows = [line for line in f if line.endswith("\n") and not line.startswith("#")]
        return float(rows[-1].split(",")[0]) if len(rows) > 1 else 0.0
    except (OSError, ValueError):
        return 0.0


def lacking(folder, values):
    """Why a run whose programs ended well is not complete, "" if it is."""
    dem, cfd = halves(folder)
    if not dem or not cfd:
        return f"{'DEM/dem.json' if not dem else 'CFD/cfd.json'} is missing: that half did not come to its end"
    time, end = reached(folder), values["end"]
    if abs(time - end) > 0.5 * values["dem_step"] + 1e-9 * end:
        return f"it ended at {time:.6g} s of {end:.6g} s"
    return ""


def write(folder, case_name, end, reason, wall_s=0.0):
    """Notes that a run is not complete, with the reason, and how far it came."""
    s = {"case": case_name, "complete": False, "simulated_s": reached(folder), "end": end, "reason": reason,
         "wall_s": round(wall_s, 3)}
    files.write_json(os.path.join(folder, "summary.json"), s)
    return s


def complete(folder):
    """Whether summary.json says that the run is complete."""
    return folders.summary(folder).get("complete") is True
