# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The number of ranks of either half must not show in the result."""

import numpy as np

from validation.lib.checks import coupled
from validation.lib.checks.verdicts import Broken

TITLE = "1 + 1 ranks against 1 + 2, 2 + 1 and 2 + 2"


def run(checks):
    options = ("--end", "0.02", "--no-pictures")
    one = coupled.settling(coupled.finished("clump-half", "parallel/1+1", *options, limit=200))
    height = one["interface_m"][0]
    for dem, cfd in ((1, 2), (2, 1), (2, 2)):
        name = f"{dem}+{cfd}"
        try:
            folder = coupled.finished("clump-half", "parallel/" + name, *options, "--dem", str(dem), "--cfd", str(cfd),
                                      limit=400)
        except Broken as e:
            checks.true(f"{name}: ends well", False, str(e))
            continue
        many = coupled.settling(folder)
        for key in ("interface_m", "mean_height_m"):
            worst = float(np.max([abs(a - b) for a, b in zip(one[key], many[key])])) / height
            checks.at_most(f"{name}: {key[:-2]}, difference over height", worst, 1e-6)
        checks.equal(f"{name}: rows of settling.csv", len(many["time_s"]), len(one["time_s"]))
        s = coupled.summary(folder)
        checks.at_most(f"{name}: max_momentum_residual", s["max_momentum_residual"], 1e-10)
        checks.at_most(f"{name}: volume error", s["max_void_fraction_volume_error"], 1e-12)
        checks.equal(f"{name}: particles_lost", s["particles_lost"], 0)

    # one clump at the border of two ranks: only one of them has ghosts
    outcome, folder = coupled.case("clump-half", "parallel/one-clump", "--set", "clumps=1", "--dem", "2",
                                   *options, limit=200)
    if checks.equal("one clump on 2+1: exit code", outcome.status, 0):
        checks.equal("one clump on 2+1: particles", coupled.summary(folder)["particles"], 14)
