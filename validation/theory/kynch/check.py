# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The column of equal spheres against Kynch's theory, with the flux of the
drag law that runs: nothing is fitted. Five packings at the paper's solid
fraction, and one packing of a dense column, where Richardson and Zaki's flux
is far from the drag law's."""

import json
import os

from validation.lib.checks import coupled
from validation.lib.checks.verdicts import Broken

TITLE = "cases/kynch: the sphere column against Kynch's theory, five seeds"
LONG = True


def compare(where, *options):
    """cases/kynch into results/validation/kynch/where; its one comparison."""
    folder = os.path.join(coupled.RUNS, "kynch", where)
    outcome = coupled.execute([os.path.join(coupled.TOP, "cases", "kynch"), "--no-setup", "sphere-half",
                               "--out", folder, *options], 3600)
    if outcome.status != 0:
        lines = [x for x in outcome.output.splitlines() if x.strip()]
        raise Broken(f"cases/kynch ended with {outcome.status}: {lines[-1] if lines else ''}")
    for name in ("kynch.png", "flux.png", "kynch.csv"):
        if not os.path.isfile(os.path.join(folder, name)):
            raise Broken(f"cases/kynch wrote no {name}")
    with open(os.path.join(folder, "kynch.json"), encoding="utf-8") as f:
        return json.load(f)["comparisons"][0]


def run(checks):
    found = compare("dilute", "--seeds", "5", "--set", "end=0.8")
    q = found["quantities"]
    checks.equal("seeds", len(found["seeds"]), 5)
    # the goal is 3 %; the other gates bound what was seen, with the seeds' spread
    for key, words, gate in (("interface_speed", "interface speed, mean of the seeds", 0.03),
                             ("top_speed", "speed of the solids' top, which smears out", 0.06),
                             ("bed_speed", "bed front speed", 0.06),
                             ("meeting_time", "time of meeting", 0.04),
                             ("meeting_height", "height of meeting", 0.10)):
        checks.close(words, q[key]["mean"], q[key]["theory"], gate)
        checks.at_most("  its spread from seed to seed, over the theory", q[key]["spread"] / q[key]["theory"], 0.06)
    checks.at_most("rms of the curve, Kynch started from rest, over H", q["rms_over_height_late"]["mean"], 0.025)
    checks.at_most("rms of the mean height, likewise", q["mean_height_rms_late"]["mean"], 0.01)

    checks.picture(os.path.join(coupled.RUNS, "kynch", "dilute", "kynch.png"))
    dense = compare("dense", "--seeds", "1", "--phi0", "0.3", "--set", "end=1.2")
    q = dense["quantities"]
    checks.close("solid fraction 0.3: speed of the solids' top", q["top_speed"]["mean"], q["top_speed"]["theory"], 0.10)
    checks.close("solid fraction 0.3: bed front speed", q["bed_speed"]["mean"], q["bed_speed"]["theory"], 0.20)
    checks.at_most("solid fraction 0.3: rms of the mean height over H", q["mean_height_rms_late"]["mean"], 0.02)
    off = abs(dense["richardson_zaki"]["interface_speed"] / q["top_speed"]["mean"] - 1)
    checks.at_least("  where Richardson-Zaki is off by", off, 0.3)
