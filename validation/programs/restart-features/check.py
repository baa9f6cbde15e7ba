# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Saved states by feature, and on other numbers of ranks."""

from validation.lib.checks import restarts
from validation.lib.checks.verdicts import Broken

TITLE = "saved states by feature, and on other numbers of ranks"
LONG = True
# what two layouts of a run without a saved state differ by, and more
LAYOUTS = 1e-6


def run(checks):
    for feature in restarts.FEATURES:
        try:
            found = restarts.compare(feature, f"restart-features/{feature.replace(' ', '-')}")
        except Broken as e:
            checks.true(f"{feature}: runs", False, str(e))
            continue
        for key in ("place", "velocity", "fluid"):
            checks.at_most(f"{feature}: {key}", float(found[key]), 1e-12)
        if feature not in restarts.BODIES:
            checks.true(f"{feature}: to the last bit", found["same"], found["same"])
    for dem, cfd in (("2", "2"), ("1", "2"), ("2", "1")):
        words = ("--dem", dem, "--cfd", cfd)
        found = restarts.compare("spheres", f"restart-features/ranks-{dem}-{cfd}", other_ranks=words)
        for key in ("place", "velocity"):
            checks.at_most(f"spheres, from 1 + 1 to {dem} + {cfd} ranks: {key}", float(found[key]), LAYOUTS)
    found = restarts.compare("spheres", "restart-features/ranks-2", ranks=("--dem", "2", "--cfd", "2"))
    for key in ("place", "velocity"):
        checks.at_most(f"spheres, 2 + 2 ranks: {key}", float(found[key]), 1e-12)
