# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The manual's tutorials to the letter: their files, their commands in order, what they say will come."""

import os
import tempfile

from cases.lib.case.casefile import TOP
from validation.lib.checks import coupled, tutorials

TITLE = "the tutorials of the manual, run to the letter"
LONG = True
PARTS = ("getting-started", "fluidised-bed", "stl-vessel", "by-hand", "from-cfdem")
_LIMIT = 1800


def _tutorial(checks, name, place):
    """One page in a folder of its own."""
    with open(os.path.join(TOP, "manual", name + ".md"), encoding="utf-8") as f:
        steps = tutorials.steps(f.read())
    programs = os.path.join(place, "bin")
    os.makedirs(programs)
    clay = os.path.join(programs, "clay")
    with open(clay, "w", encoding="utf-8") as f:
        f.write(f'#!/bin/sh\nexec {TOP}/cases/clay --no-setup "$@"\n')
    os.chmod(clay, 0o755)
    env = {**os.environ, "PATH": f"{programs}:{TOP}/build/bin:{os.environ['PATH']}", "OMPI_ALLOW_RUN_AS_ROOT": "1",
           "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1"}
    at, said = place, ""
    for number, (kind, path, content) in enumerate(steps, 1):
        if kind == "file":
            os.makedirs(os.path.dirname(os.path.join(place, path)), exist_ok=True)
            with open(os.path.join(place, path), "w", encoding="utf-8") as f:
                f.write(content)
        elif kind == "expected":
            lost = [line for line in content.splitlines() if line.strip() not in said]
            checks.equal(f"{name}, block {number}: lines that were expected and did not come", lost, [])
        else:
            # the folder that its `cd` leads to holds for the blocks behind it
            outcome = coupled.execute(["bash", "-ec", content + 'echo "$PWD" > ' + place + "/at"], _LIMIT, at, env)
            said = outcome.output
            if not checks.true(f"{name}, block {number}: {content.splitlines()[0]}", outcome.status == 0,
                               "" if outcome.status == 0 else " ".join(said.split())[-200:]):
                return
            with open(os.path.join(place, "at"), encoding="utf-8") as f:
                at = f.read().strip()


def run(checks):
    for name in checks.parts or PARTS:
        with tempfile.TemporaryDirectory() as place:
            _tutorial(checks, name, os.path.realpath(place))
