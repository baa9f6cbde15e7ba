# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The unit tests and a short coupled run under AddressSanitizer and UBSan."""

import json
import os
import re
import tempfile

from cases.lib.run import launch
from validation.lib.checks import coupled, ctest_report
from validation.lib.checks.coupled import TOP
from validation.lib.checks.verdicts import Broken
from validation.lib.matrix import axes, scene

TITLE = "the unit tests and a coupled run under AddressSanitizer and UBSan"
LONG = True
BUILD = os.path.join(TOP, "build", "sanitize")
FOLDER = os.path.join(coupled.RUNS, "sanitizers")
# what others leave is suppressed by name in leaks.supp; whole stacks, as names are of callers
OPTIONS = {"ASAN_OPTIONS": "detect_leaks=1:fast_unwind_on_malloc=0",
           "LSAN_OPTIONS": f"suppressions={os.path.join(os.path.dirname(os.path.abspath(__file__)), 'leaks.supp')}"
                           ":print_suppressions=0",
           "UBSAN_OPTIONS": "print_stacktrace=1"}
# OpenFOAM's lists delete their links by their base (LList.H, removeHead): for its half and its half's tests alone
OPENFOAM = {"ASAN_OPTIONS": OPTIONS["ASAN_OPTIONS"] + ":new_delete_type_mismatch=0"}
# runs that are broken off hold what they hold; looking for leaks, 4 s a process, is left out there, and where
# millions of short lists are made
NO_LEAKS = {**OPTIONS, "ASAN_OPTIONS": "detect_leaks=0"}
_OWN_TESTS = r"^(exchange|dem)\."
_BROKEN_OFF = r"^exchange\.(Refused|Ends|decode|wrappers)|^dem\.(refused|shutdown)"
# valgrind and a sanitizer do not go together; the others run a half dozens of times, each run like the coupled one
_LEFT_OUT = r"valgrind|damage_runs|^(features|input|ranks|refusals)$"
_REPORT = re.compile(r"runtime error: .*|ERROR: (?:Address|Leak)Sanitizer.*|AddressSanitizer:DEADLYSIGNAL")
_SUMMARY = re.compile(r"\d+% tests passed.*|Total Test time.*|SUMMARY: .*|.*half done.*|clayFoam: end at .*")
# two ranks of each half, with all forces, clumps and spheres, films, charges and random forces
ROW = {"cfd": 2, "dem": 2, "cut": "filling", "demCut": "low", "sides": "cyclic", "mesh": "skew", "force": "all",
       "bodies": "both", "films": "yes", "charges": "yes", "thermal": "yes", "smoothingModel": "diffusion",
       "selfDisturbance": "latticeMemory", "outer": 3, "lag": 3}


# what, a program, words of the report
FAULTS = (
    ("a read behind an array", "int main(int n, char **) { int *a = new int[n]; return a[n + 1]; }",
     "heap-buffer-overflow"),
    ("an int that is too large", "int main(int n, char **) { volatile int all = n + 2147483646; return all > 0; }",
     "signed integer overflow"),
    ("memory that is never freed", "int *volatile a; int main(int n, char **) { for (int i = 0; i < 9; ++i) "
     "a = new int[n]; return 0; }", "detected memory leaks"),
)


def reports(text):
    """What the sanitizers complain of, each place once."""
    return sorted(set(match.group(0).strip() for match in _REPORT.finditer(text)))


def _silent(checks, what, output, log):
    found = reports(output)
    checks.true(f"{what}: no report of a sanitizer", not found, f"{len(found)}: {'; '.join(found[:3])}; log in {log}")
    for line in sorted(set(_SUMMARY.findall(output))):
        checks.note(f"{what}: {' '.join(line.split())}")


def _faults_are_found(checks):
    """Programs with a fault each, compiled and run as the build's: a gate that cannot fail says nothing."""
    with open(os.path.join(TOP, "CMakePresets.json"), encoding="utf-8") as f:
        presets = {p["name"]: p for p in json.load(f)["configurePresets"]}
    flags = presets["sanitize"]["cacheVariables"]["CMAKE_CXX_FLAGS_SANITIZE"].split()
    with tempfile.TemporaryDirectory() as folder:
        for what, text, said in FAULTS:
            source, program = os.path.join(folder, "fault.cpp"), os.path.join(folder, "fault")
            with open(source, "w", encoding="utf-8") as f:
                f.write(text)
            _built(["c++", *flags, source, "-o", program], 60)
            found = reports(coupled.execute([program, "1"], 60, env={**os.environ, **OPTIONS}).output)
            checks.true(f"{what} that is put there is found", any(said in x for x in found), "; ".join(found[:2]))


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


def command(halves):
    """The line that runs both halves, the CFD half with what OpenFOAM needs."""
    words = halves.command()
    at = words.index("clayFoam")
    return [*words[:at], "env", *(f"{k}={v}" for k, v in OPENFOAM.items()), *words[at:]]


def run(checks):
    _faults_are_found(checks)
    _built(["cmake", "--preset", "sanitize"], 600)
    _built(["cmake", "--build", BUILD, f"-j{launch.cores()}"], 7200)

    said, ended = "", ctest_report.Ended(lambda name, reason: checks.true(name, not reason, reason))
    for which, options in ((["-R", _OWN_TESTS, "-E", f"{_BROKEN_OFF}|{_LEFT_OUT}"], OPTIONS),
                           (["-R", _BROKEN_OFF], NO_LEAKS),
                           (["-E", f"{_OWN_TESTS}|{_LEFT_OUT}"], {**OPTIONS, **OPENFOAM})):
        outcome = coupled.execute(["ctest", "--test-dir", BUILD, "--output-on-failure", "--timeout", "900", *which,
                                   f"-j{launch.cores() + 1}"], 7200, env={**os.environ, **options})
        for line in outcome.output.splitlines():
            ended.take(line)
        ended.close()
        with open(os.path.join(BUILD, "Testing", "Temporary", "LastTest.log"), encoding="utf-8", errors="replace") as f:
            said += outcome.output + f.read()  # what those have said that have passed, too
    log = _keep("unit-tests.log", said)
    checks.at_least("unit tests that ran", float(len(ended.names)), 100.0)
    _silent(checks, "the unit tests", said, log)

    row = {**{axis: values[0] for axis, values in axes.AXES.items()}, **ROW}
    folder = os.path.join(FOLDER, "coupled")
    scene.write(folder, row)
    halves = launch.Run(folder, row["dem"], row["cfd"])
    path = os.path.join(BUILD, "bin") + os.pathsep + halves.environment()["PATH"]
    outcome = coupled.execute(command(halves), 900, cwd=folder, env={**halves.environment(), **OPTIONS, "PATH": path})
    log = _keep("coupled.log", outcome.output)
    checks.equal("the coupled run: exit code", outcome.status, 0)
    checks.true("the coupled run: it is the sanitizers' build",
                os.path.join(BUILD, "bin", "clayFoam") in outcome.output)
    _silent(checks, "the coupled run", outcome.output, log)
    checks.note(f"logs: results/validation/sanitizers/unit-tests.log and coupled.log; a row of the matrix: "
                f"{' '.join(f'{k}={v}' for k, v in ROW.items())}")
