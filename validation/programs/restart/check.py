# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A run that stopped and went on ends as one that did not."""

import os

from validation.lib.checks import coupled, restarts

TITLE = "a run goes on from its saved state as if it had not stopped"
FEATURES = ("spheres", "charged clumps")


def run(checks):
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
