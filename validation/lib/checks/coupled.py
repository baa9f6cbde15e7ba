# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Runs coupled cases for the checks, within a time limit."""

import json
import os
import select
import shutil
import signal
import subprocess
import time

from cases.lib.case import stops
from cases.lib.case.casefile import TOP
from validation.lib.checks import rooms
from validation.lib.checks.verdicts import Broken

RUNS = os.path.join(TOP, "results", "validation")


class Outcome:
    """How a command ended: exit code (None: had to be stopped), output, seconds."""

    def __init__(self, status, output, seconds):
        self.status, self.output, self.seconds = status, output, seconds


def execute(words, limit, cwd=TOP, env=None):
    """Runs a command; ends it, and all it started, after limit seconds."""
    began = time.monotonic()
    process = subprocess.Popen(words, cwd=cwd, env=env, stdin=subprocess.DEVNULL, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               errors="replace", start_new_session=True, preexec_fn=stops.die_with_parent())
    try:
        output, _ = process.communicate(timeout=limit)
        status = process.returncode
    except subprocess.TimeoutExpired:
        output, status = stop(process), None
    except BaseException:  # this program is asked to end
        stop(process)
        raise
    return Outcome(status, output, time.monotonic() - began)


def stop(process):
    """Ends a process that leads a session, and all it started; what it has said."""
    os.killpg(process.pid, signal.SIGTERM)
    try:
        return process.communicate(timeout=10)[0]
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        return process.communicate()[0]


def lines(process, pipe, silence):
    """What a process that leads a session writes into a pipe, line by line as it
    comes; ends the process when it writes nothing for `silence` seconds."""
    rest = b""
    while True:
        if not select.select([pipe], [], [], silence)[0]:
            stop(process)
            break
        said = os.read(pipe, 65536)
        if not said:
            break
        *whole, rest = (rest + said).split(b"\n")
        yield from whole
    if rest:
        yield rest


def case(name, where, *options, limit=600):
    """cases/run of a case into results/validation/where; returns (outcome, folder)."""
    folder = os.path.join(RUNS, where)
    shutil.rmtree(folder, ignore_errors=True)  # whatever another version has left there
    words = [os.path.join(TOP, "cases", "run"), "--no-setup", name, "--out", folder, *options]
    return execute(words, limit), folder


def finished(name, where, *options, limit=600):
    """As case(), but the run must end well; returns its folder."""
    outcome, folder = case(name, where, *options, limit=limit)
    if outcome.status != 0:
        lines = [x for x in outcome.output.splitlines() if x.strip()]
        raise Broken(f"the run in {where} ended with {outcome.status}: {lines[-1] if lines else ''}")
    return folder


def dem(case, where, limit=300, **variables):
    """liggghts-clay alone on validation/ROOM/CASE/in.liggghts in results/validation/where,
    made anew with copies of that folder's inputs; returns the folder. The run
    must end well."""
    source, folder = rooms.holding("in.liggghts")[case], os.path.join(RUNS, where)
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(source, folder, ignore=shutil.ignore_patterns("check.py", "README*", "case.json"))
    os.makedirs(os.path.join(folder, "DEM"), exist_ok=True)
    words = [os.path.join(TOP, "build", "bin", "liggghts-clay"), "-in", "in.liggghts", "-log", "DEM/log"]
    for key, value in variables.items():
        words += ["-var", key, *map(str, value if isinstance(value, (list, tuple)) else [value])]
    outcome = execute(words, limit, cwd=folder)
    if outcome.status != 0:
        lines = [x for x in outcome.output.splitlines() if x.strip()]
        raise Broken(f"the run in {where} ended with {outcome.status}: {lines[-1] if lines else ''}")
    return folder


def columns(path):
    """The columns of a csv by name, as lists of numbers."""
    with open(path, encoding="utf-8") as f:
        rows = [x.strip().split(",") for x in f if x.strip() and not x.startswith("#")]
    return {key: [float(r[i]) for r in rows[1:]] for i, key in enumerate(rows[0])}


def summary(folder):
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as f:
        return json.load(f)


def cfd(folder):
    """What the CFD half has measured."""
    with open(os.path.join(folder, "CFD", "cfd.json"), encoding="utf-8") as f:
        return json.load(f)


def settling(folder):
    """The columns of settling.csv, as lists of numbers by name."""
    return columns(os.path.join(folder, "settling.csv"))
