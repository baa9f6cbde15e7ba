# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Does calibration find the charge and the time scale of a made-up curve?"""

import json
import os
import re

from validation.lib.checks import coupled
from validation.lib.checks.verdicts import Broken

TITLE = "cases/calibrate recovers charge and time scale of a made-up curve"
LONG = True

CHARGE, SCALE = 2.4e-10, 8.1e5
# large steps and soft contacts: what is asked for is the same in both
SETTINGS = ("--set", "dem_step=2.5e-5", "--set", "stiffness=750", "--set", "coupling_steps=20",
            "--set", "coulomb_steps=8", "--end", "1.5", "--jobs", "1")


def calibrate(*options, limit=3600):
    words = [os.path.join(coupled.TOP, "cases", "calibrate"), "--no-setup", "clump-half", *SETTINGS, *options]
    outcome = coupled.execute(words, limit)
    if outcome.status != 0:
        lines = [x for x in outcome.output.splitlines() if x.strip()]
        raise Broken(f"cases/calibrate ended with {outcome.status}: {lines[-1] if lines else ''}")
    return outcome


def run(checks):
    folder = os.path.join(coupled.RUNS, "calibration")
    os.makedirs(folder, exist_ok=True)
    data = os.path.join(folder, "made-up.csv")
    # a packing that the calibration does not use, and noise
    calibrate("--make-data", data, "--true", f"charge={CHARGE}", f"time_scale={SCALE}", "--seed", "1001")
    words = ("--data", data, "--height0", "0.15", "--charges", "1.5e-10,2.75e-10,3.93e-10", "--out", folder)
    calibrate(*words)
    with open(os.path.join(folder, "calibration.json"), encoding="utf-8") as f:
        found = json.load(f)
    for key, truth, gate in (("charge", CHARGE, 0.25), ("time_scale", SCALE, 0.2)):
        p = found[key]
        if not checks.true(f"{key} is determined", p["determined"], p["says"]):
            continue
        checks.close(f"{key} found", p["value"], truth, gate)
        checks.true(f"true {key} in its interval", p["low"] <= truth <= p["high"],
                    f"{p['low']:.4g} to {p['high']:.4g}", f"{truth:.4g}")
        checks.at_most(f"half of the interval of {key}, over it", 0.5 * (p["high"] - p["low"]) / p["value"], gate)
    # 10 would be the most that are allowed
    checks.at_most("runs it took", float(len(found["runs"])), 9)
    checks.at_most("misfit over what is expected", found["rms_misfit"] / found["rms_expected"], 2.0)
    last = found["end_of_consolidation"]
    checks.true("the end of consolidation, or a bound of it", (last["low"] or 0) > 0,
                f"{last['low']:.4g} days" if last["low"] else "")
    # every run is there now
    again = calibrate(*words, limit=120)
    checks.true("a second calibration makes no run", not re.search(r"run \d+ of", again.output))
