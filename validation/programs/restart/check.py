# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A run that stopped and went on ends as one that did not."""

import json
import os
import re

from cases.lib.run import saved_pairs as pairs
from validation.lib.checks import coupled, restarts

TITLE = "a run goes on from its saved state as if it had not stopped"
FEATURES = ("spheres", "charged clumps")


def _watch(checks):
    """A run that the watch ends keeps the last good state, and names it."""
    outcome, folder = coupled.case("restart-scene", "restart/watch", "--no-pictures", "--set", "stiffness=0.05",
                                   "--set", "speed=0.5", "--set", "checkpoint_steps=20", limit=300)
    checks.equal("watch: exit code", outcome.status, 1)
    saved = sorted(os.listdir(os.path.join(folder, pairs.FOLDER)))
    step = re.search(r"at step (\d+) .*; last check passed", outcome.output)
    good = step and saved and int(saved[-1]) < int(step.group(1))
    checks.true("watch: the state it ends the run at is not saved", good, f"{saved}, {outcome.output[-200:]}")
    checks.equal("watch: two are kept", len(saved), 2)
    checks.true("watch: its last words name the last one",
                f"the last saved state is that of step {int(saved[-1])}" in outcome.output, outcome.output[-300:])


def _no_room(checks):
    """States that cannot be written are warned of, and the run goes on."""
    _, folder = coupled.case("restart-scene", "restart/no-room", "--dry-run", "--end", "0.004", limit=300)
    with open(os.path.join(folder, pairs.FOLDER), "w", encoding="utf-8"):
        pass
    outcome = coupled.execute(["sh", os.path.join(folder, "run.sh")], 300)
    checks.equal("a folder that cannot be made: exit code", outcome.status, 0)
    with open(os.path.join(folder, "DEM", "dem.json"), encoding="utf-8") as f:
        said = json.load(f)["warnings"]
    checks.true("a folder that cannot be made: is warned of",
                any("no state was saved: cannot make folder" in x for x in said), said)


def run(checks):
    _watch(checks)
    _no_room(checks)
    for feature in FEATURES:
        found = restarts.compare(feature, f"restart/{feature.replace(' ', '-')}")
        for key in ("place", "velocity", "fluid"):
            checks.at_most(f"{feature}: {key}", float(found[key]), 1e-12)
        if feature not in restarts.BODIES:
            checks.true(f"{feature}: to the last bit", found["same"], found["same"])
        checks.true(f"{feature}: says where it took up", "goes on from" in found["said"], "")
        one, two = (coupled.settling(found[part]) for part in ("whole", "parts"))
        checks.equal(f"{feature}: rows of the curve", len(two["time_s"]), len(one["time_s"]))
        checks.true(f"{feature}: the curve is the same", one == two, "")
        frames = [sorted(os.listdir(os.path.join(found[part], "CFD"))) for part in ("whole", "parts")]
        checks.equal(f"{feature}: output times", [x for x in frames[1] if x[:1].isdigit()],
                     [x for x in frames[0] if x[:1].isdigit()])
