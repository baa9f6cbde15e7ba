# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Every case there is, from its packing through its first moments."""

import os

from validation.lib.checks import coupled

TITLE = "every case for 0.02 s"


def run(checks):
    listed = coupled.execute([os.path.join(coupled.TOP, "cases", "run"), "--no-setup", "--list"], 60)
    names = [line.split()[0] for line in listed.output.splitlines() if line.strip()]
    checks.at_least("number of cases", float(len(names)), 8.0)
    for name in names:
        outcome, folder = coupled.case(name, "all-cases/" + name, "--end", "0.02", "--no-pictures",
                                       "--set", "frames=1", limit=300)
        if not checks.equal(f"{name}: exit code", outcome.status, 0):
            checks.true(f"{name}: what it said", False, outcome.output.strip()[-200:])
            continue
        s = coupled.summary(folder)
        checks.equal(f"{name}: particles lost", s["particles_lost"], 0)
        wanted = s["settings"].get("spheres") or 14 * s["settings"].get("clumps", 0)
        if wanted:
            checks.equal(f"{name}: particles", s["particles"], wanted)
        checks.close(f"{name}: simulated_s", s["simulated_s"], 0.02, 1e-9)
        checks.at_most(f"{name}: max_momentum_residual", s["max_momentum_residual"], 1e-10)
        checks.at_most(f"{name}: max_void_fraction_volume_error", s["max_void_fraction_volume_error"], 1e-12)
        if "tube_height" not in s["settings"]:
            continue
        height = coupled.settling(folder)["mean_height_m"]
        checks.true(f"{name}: the solids sink", height[-1] < height[0], height[-1], height[0])
