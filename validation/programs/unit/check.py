# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Every test that ctest knows, a row each as soon as it has ended."""

import json
import os
import subprocess

from cases.lib.run import launch
from validation.lib.checks import coupled, ctest_report
from validation.lib.checks.coupled import TOP
from validation.lib.checks.verdicts import Broken

TITLE = "the unit tests in C++ (ctest)"
LIMIT = 300  # [s] for a test that has no limit of its own; the longest of these is 600 s
_WAITING = 1  # more tests at once than cores: many wait, for mpirun or for a time-out
_SILENCE = 900.0  # [s] without a word, after which ctest itself is ended
_BUILD = os.path.join(TOP, "build")
_HALVES = ("exchange", "liggghts-fix", "foam-coupling")


def _listed():
    said = coupled.execute(["ctest", "--test-dir", _BUILD, "--show-only=json-v1"], 60).output
    try:
        return ctest_report.Listed(said[said.index("{"):])
    except ValueError:
        raise Broken(f"ctest lists no tests: {said.strip().splitlines()[-1:]}") from None


def _test_files():
    """The project's C++ files that have tests, as paths."""
    found = set()
    for half in _HALVES:
        for folder, _, files in os.walk(os.path.join(TOP, half)):
            for path in (os.path.join(folder, f) for f in files if f.endswith((".cpp", ".C"))):
                with open(path, encoding="utf-8") as f:
                    if ctest_report.holds_tests(f.read()):
                        found.add(path)
    return found


def _none(checks, question, found):
    checks.true(question, not found, f"{len(found)}: {', '.join(found[:8])}" if found else "")


def run(checks):
    listed = _listed()
    ended = ctest_report.Ended(lambda name, reason: checks.true(name, not reason, reason))
    ctest = subprocess.Popen(["ctest", "--test-dir", _BUILD, "--output-on-failure", "--timeout", str(LIMIT),
                              f"-j{launch.cores() + _WAITING}"], cwd=TOP,
                             stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             start_new_session=True)
    for line in coupled.lines(ctest, ctest.stdout.fileno(), _SILENCE):
        ended.take(line.decode(errors="replace"))
    ended.close()
    ctest.wait()
    _none(checks, "tests that ctest lists and has not run",
          [n + (" (begun)" if n in ended.running else "") for n in listed.names if n not in ended.names])
    _none(checks, "tests that are disabled", listed.disabled)
    files = _test_files()
    with open(os.path.join(_BUILD, "compile_commands.json"), encoding="utf-8") as f:
        compiled = ctest_report.compiled(json.load(f))
    _none(checks, "files of tests that are not built",
          sorted(os.path.relpath(x, TOP) for x in files - {path for path, _ in compiled}))
    _none(checks, "programs of tests that no test runs", listed.idle_programs(files, compiled))
    with open(os.path.join(_BUILD, "Testing", "Temporary", "LastTest.log"), encoding="utf-8", errors="replace") as f:
        _none(checks, "tests that their programs leave out", ctest_report.left_out(f.read()))
