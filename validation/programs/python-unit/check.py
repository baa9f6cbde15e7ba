# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The unit tests of the Python parts, a row each as soon as it has ended."""

import functools
import json
import os
import subprocess
import sys
import tempfile
import threading
from concurrent import futures

from cases.lib.run import launch
from validation.lib.checks import coupled
from validation.lib.checks.coupled import RUNS, TOP
from validation.lib.checks.verdicts import Broken

TITLE = "the unit tests of the Python parts (pytest)"
LIMIT = 300.0  # [s] for a test; of several minutes on a loaded machine none took more than one
_MOST = 4  # pytests at once; many a test starts two ranks
_SILENCE = 60.0  # [s] more, after which a test that cannot be ended ends all


def _pytest(number, shared, take):
    """One of several that share the tests, to its end; take(line) is given what it tells."""
    ours, theirs = os.pipe()
    # with =: a word that is a folder's name would be taken for one of tests, and move the root
    words = [sys.executable, "-E", "-s", "-B", TOP, "pytest", "-q", "-p", "validation.lib.checks.pytest_rows",
             "--rows-to", str(theirs), "--limit", str(LIMIT), f"--rootdir={TOP}", f"--share={shared}"]
    with open(_log(number), "w", encoding="utf-8") as f:
        process = subprocess.Popen(words, cwd=TOP, stdin=subprocess.DEVNULL, stdout=f, stderr=subprocess.STDOUT,
                                   start_new_session=True, pass_fds=(theirs,))
    os.close(theirs)
    for line in map(json.loads, coupled.lines(process, ours, LIMIT + _SILENCE)):
        take(line)
    os.close(ours)
    process.wait()


def _log(number):
    return os.path.join(RUNS, f"pytest-{number}.log")


def run(checks):
    count = min(launch.cores(), _MOST)
    listed, ended, going, one = None, set(), {}, threading.Lock()

    def take(number, line):
        nonlocal listed
        with one:
            listed = line.get("listed", listed)
            if "began" in line:
                going[number] = line["began"]
            if "ended" in line:
                ended.add(line["ended"])
                going.pop(number, None)
                checks.true(line["ended"], not line["reason"], line["reason"])

    with tempfile.TemporaryDirectory() as shared, futures.ThreadPoolExecutor(count) as pool:
        for done in [pool.submit(_pytest, n, shared, functools.partial(take, n)) for n in range(count)]:
            done.result()
    if listed is None:
        with open(_log(0), encoding="utf-8", errors="replace") as f:
            raise Broken(f"pytest listed no tests: {f.read().strip().splitlines()[-1:]}")
    missing = [t for t in listed if t not in ended]
    begun = f", begun and not ended: {', '.join(going.values())}" if going else ""
    checks.true("every test that pytest lists has run", not missing,
                f"{len(missing)} have not{begun}" if missing else "")
    idle = sorted(_files() - {t.partition("::")[0] for t in listed})
    checks.true("a test is listed of every file of tests", not idle, f"none of {', '.join(idle)}" if idle else "")


def _files():
    """The files of tests there are, wherever they stand."""
    return {os.path.relpath(os.path.join(folder, f), TOP) for top in ("cases", "validation")
            for folder, _, files in os.walk(os.path.join(TOP, top)) for f in files
            if f.startswith("test_") and f.endswith(".py")}
