# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The unit tests and a short coupled run under AddressSanitizer and UBSan."""

import os
import re

from cases.lib.run import launch
from validation.lib.checks import coupled, ctest_report
from validation.lib.checks.coupled import TOP
from validation.lib.checks.verdicts import Broken
from validation.lib.matrix import axes, scene

TITLE = "the unit tests and a coupled run under AddressSanitizer and UBSan"
LONG = True
BUILD = os.path.join(TOP, "build", "sanitize")
FOLDER = os.path.join(coupled.RUNS, "sanitizers")
# leaks: LIGGGHTS, OpenFOAM and MPI free little of what they hold to the end; two definitions: clayFoam and
# libclayCoupling both hold the wire
OPTIONS = {"ASAN_OPTIONS": "detect_leaks=0:detect_odr_violation=0",
           "UBSAN_OPTIONS": "print_stacktrace=1"}
# valgrind and a sanitizer do not go together; the clones' instructions are counted without either
_LEFT_OUT = r"valgrind|instructions"
_REPORT = re.compile(r"runtime error: .*|ERROR: AddressSanitizer.*|AddressSanitizer:DEADLYSIGNAL")
# two ranks of each half, with all forces, clumps and spheres, films, charges and random forces
ROW = {"cfd": 2, "dem": 2, "cut": "filling", "demCut": "low", "sides": "cyclic", "mesh": "skew", "force": "all",
       "bodies": "both", "films": "yes", "charges": "yes", "thermal": "yes", "smoothingModel": "diffusion",
       "selfDisturbance": "latticeMemory", "outer": 3, "lag": 3}


def reports(text):
    """What the sanitizers complain of, each place once."""
    return sorted(set(match.group(0).strip() for match in _REPORT.finditer(text)))


def _silent(checks, what, output, log):
    found = reports(output)
    checks.true(f"{what}: no report of a sanitizer", not found, f"{len(found)}: {'; '.join(found[:3])}; log in {log}")


def _keep(name, text):
    os.makedirs(FOLDER, exist_ok=True)
    path = os.path.join(FOLDER, name)
    with open(path, "w", encoding="utf-8") as f:
        f.write(text)
    return os.path.relpath(path, TOP)


def _built(words, limit):
    outcome = coupled.execute(words, limit)
    if outcome.status != 0:
        raise Broken(f"{' '.join(words)} ended with {outcome.status}; log in {_keep('build.log', outcome.output)}")


def run(checks):
    _built(["cmake", "--preset", "sanitize"], 600)
    _built(["cmake", "--build", BUILD, f"-j{launch.cores()}"], 7200)
    environment = {**os.environ, **OPTIONS}

    outcome = coupled.execute(["ctest", "--test-dir", BUILD, "--verbose", "--timeout", "900", "-E", _LEFT_OUT], 7200,
                              env=environment)
    log = _keep("unit-tests.log", outcome.output)
    ended = ctest_report.Ended(lambda name, reason: checks.true(name, not reason, reason))
    for line in outcome.output.splitlines():
        ended.take(line)
    ended.close()
    checks.at_least("unit tests that ran", float(len(ended.names)), 100.0)
    _silent(checks, "the unit tests", outcome.output, log)

    row = {**{axis: values[0] for axis, values in axes.AXES.items()}, **ROW}
    folder = os.path.join(FOLDER, "coupled")
    scene.write(folder, row)
    halves = launch.Run(folder, row["dem"], row["cfd"])
    path = os.path.join(BUILD, "bin") + os.pathsep + halves.environment()["PATH"]
    outcome = coupled.execute(halves.command(), 900, cwd=folder, env={**halves.environment(), **OPTIONS, "PATH": path})
    log = _keep("coupled.log", outcome.output)
    checks.equal("the coupled run: exit code", outcome.status, 0)
    checks.true("the coupled run: it is the sanitizers' build",
                os.path.join(BUILD, "bin", "clayFoam") in outcome.output)
    _silent(checks, "the coupled run", outcome.output, log)
    checks.note(f"logs: results/validation/sanitizers/unit-tests.log and coupled.log; a row of the matrix: "
                f"{' '.join(f'{k}={v}' for k, v in ROW.items())}")
