# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Broken inputs: each must end both halves soon, with a line that names it."""

import json
import os
import re
from concurrent import futures

from cases.lib.case import openfoam
from cases.lib.run import launch
from validation.lib.checks import coupled
from validation.lib.checks.verdicts import Broken

TITLE = "broken inputs end both halves with one line that says why"
SECONDS = 20
_TELLS = re.compile(r"(ERROR|clayFoam: (?!t = |warning|couplingProperties: defaults)|liggghts-clay: )")


def _break(folder, item):
    """Does to a prepared run folder what the item says."""
    for name, (old, new) in item.get("replace", {}).items():
        path = os.path.join(folder, name)
        with open(path, encoding="utf-8") as f:
            text = f.read()
        if old not in text:
            raise Broken(f"{item['input']}: '{old}' does not stand in {name}")
        with open(path, "w", encoding="utf-8") as f:
            f.write(text.replace(old, new))
    for name, text in item.get("append", {}).items():
        with open(os.path.join(folder, name), "a", encoding="utf-8") as f:
            f.write(text + "\n")
    for name, text in item.get("create", {}).items():
        with open(os.path.join(folder, name), "w", encoding="utf-8") as f:
            f.write(text)
    if "remove" in item:
        os.remove(os.path.join(folder, item["remove"]))
    for program, options in item.get("command", {}).items():
        openfoam.run(program, os.path.join(folder, "CFD"), *options)


def _script(folder, item):
    """The folder's run.sh, of one half only if the item says so."""
    with open(os.path.join(folder, "run.sh"), encoding="utf-8") as f:
        script = f.read()
    if "alone" in item:
        head, dem, cfd = re.match(r"(.*mpirun[^\n]*?)(-np \d+ liggghts-clay.*) : (-np.*)$",
                                  script, re.S).groups()
        script = head + (dem if item["alone"] == "dem" else cfd)
    return script


def _reasons(output):
    """Lines of the output that tell of an error, each once."""
    found = []
    for line in output.splitlines():
        line = line.strip()
        if _TELLS.match(line) and line not in found:
            found.append(line)
    return found


def _same(reason):
    """A reason without the name of the half that says it and its place in the source."""
    reason = re.sub(r"^(ERROR:?|clayFoam:|liggghts-clay:) *(refused: *)?", "", reason)
    return re.sub(r" *\([^()]*\.(cpp|h):\d+\)$", "", reason)


def _tried(number, item):
    """Outcomes of preparing a run and of running it, broken as the item says; None where there was none."""
    options = [o for s in item.get("set", []) for o in ("--set", s)]
    prepared, folder = coupled.case("clump-half", f"bad-input/{number:02d}", "--dry-run", "--end", "0.02", *options,
                                    limit=60)
    if prepared.status != 0:
        return prepared, None
    _break(folder, item)
    outcome = coupled.execute(["sh", "-c", _script(folder, item)], 60)
    with open(os.path.join(folder, "output"), "w", encoding="utf-8") as f:
        f.write(outcome.output)
    return prepared, outcome


def run(checks):
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "inputs.json"),
              encoding="utf-8") as f:
        items = json.load(f)
    # two at once: much of each is a wait for mpirun's start or for one rank
    with futures.ThreadPoolExecutor(min(2, launch.cores())) as pool:
        for item, (prepared, outcome) in zip(items, pool.map(_tried, range(len(items)), items)):
            _judge(checks, item["input"], item["says"], prepared, outcome)


def _judge(checks, what, says, prepared, outcome):
    if outcome is None:
        checks.true(f"{what}: prepared", False, prepared.output.strip()[-200:])
        return
    reasons = _reasons(outcome.output)
    # as cases/run does: a half that tells of the other's end comes second
    first = [r for r in reasons if not launch.AFTERMATH.search(r)]
    said = (first or reasons or [""])[0]
    missing = [w for w in says if w.lower() not in said.lower()]
    checks.true(f"{what}: ends, exit code not 0", outcome.status not in (0, None), outcome.status)
    checks.at_most(f"{what}: seconds", outcome.seconds, SECONDS)
    different = sorted({_same(r) for r in first})
    checks.true(f"{what}: one line, one reason", reasons and len(different) <= 1, " | ".join(different))
    checks.true(f"{what}: the line names it", not missing,
                said if missing else "", "lacks: " + ", ".join(missing) if missing else "")
