# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The unit tests of the Python parts, a row each as soon as it has ended."""

import json
import os
import subprocess
import sys

from validation.lib.checks import coupled
from validation.lib.checks.coupled import RUNS, TOP
from validation.lib.checks.verdicts import Broken

TITLE = "the unit tests of the Python parts (pytest)"
LIMIT = 300.0  # [s] for a test; of several minutes on a loaded machine none took more than one
_SILENCE = 60.0  # [s] more, after which a test that cannot be ended ends all


def run(checks):
    ours, theirs = os.pipe()
    words = [sys.executable, "-E", "-s", "-B", TOP, "pytest", "-q", "-p", "validation.lib.checks.pytest_rows",
             "--rows-to", str(theirs), "--limit", str(LIMIT)]
    log = os.path.join(RUNS, "pytest.log")
    with open(log, "w", encoding="utf-8") as f:
        process = subprocess.Popen(words, cwd=TOP, stdin=subprocess.DEVNULL, stdout=f, stderr=subprocess.STDOUT,
                                   start_new_session=True, pass_fds=(theirs,))
    os.close(theirs)
    listed, ended, going = None, set(), None
    for line in map(json.loads, coupled.lines(process, ours, LIMIT + _SILENCE)):
        listed, going = line.get("listed", listed), line.get("began", going)
        if "ended" in line:
            ended.add(line["ended"])
            checks.true(line["ended"], not line["reason"], line["reason"])
            going = None
    os.close(ours)
    process.wait()
    if listed is None:
        with open(log, encoding="utf-8", errors="replace") as f:
            raise Broken(f"pytest listed no tests: {f.read().strip().splitlines()[-1:]}")
    missing = [t for t in listed if t not in ended]
    checks.true("every test that pytest lists has run", not missing,
                f"{len(missing)} have not" + (f", the last to begin was {going}" if going else "") if missing else "")
    idle = sorted(_files() - {t.partition("::")[0] for t in listed})
    checks.true("a test is listed of every file of tests", not idle, f"none of {', '.join(idle)}" if idle else "")


def _files():
    """The files of tests there are, wherever they stand."""
    return {os.path.relpath(os.path.join(folder, f), TOP) for top in ("cases", "validation")
            for folder, _, files in os.walk(os.path.join(TOP, top)) for f in files
            if f.startswith("test_") and f.endswith(".py")}
