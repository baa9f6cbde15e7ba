# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the runs of validation/bench and reads what they took."""

import hashlib
import json
import os
import re
import shutil
import subprocess
import time

from cases.lib.case import casefile
from cases.lib.run import launch, runkey, runs
from validation.lib.checks import coupled
from validation.lib.checks.verdicts import Broken

PLACE = os.path.join(coupled.TOP, "results", "bench")
_LIMIT = 24 * 3600.0


def name_of(case, changes):
    return case + "-" + hashlib.sha256(repr(sorted(changes.items())).encode()).hexdigest()[:10]


def made(case, changes, where="runs", dry=False, edit=None, tag=""):
    """A run of cases/run without pictures; its folder, named by the tag as well.
    edit(text) changes its in.liggghts. Broken when it fails."""
    if edit and not dry:
        return _edited(case, changes, where, edit, tag)
    folder = os.path.join(PLACE, where, name_of(case, changes) + tag.replace(" ", "-") + ("-inputs" if dry else ""))
    words = [os.path.join(coupled.TOP, "cases", "run"), "--no-setup", case, "--out", folder, "--overwrite",
             "--no-pictures",
             "--set", "frames=2"]
    for key, value in changes.items():
        words += ["--set", f"{key}={value if isinstance(value, str) else casefile.text(value)}"]
    outcome = coupled.execute(words + (["--dry-run"] if dry else []), _LIMIT)
    if outcome.status != 0:
        lines = [x for x in outcome.output.splitlines() if x.strip()]
        raise Broken(lines[-1] if lines else f"exit code {outcome.status}")
    return folder


def _edited(case, changes, where, edit, tag):
    folder = made(case, changes, where, dry=True, tag=tag)
    path = os.path.join(folder, "in.liggghts")
    with open(path, encoding="utf-8") as f:
        before = f.read()
    text = edit(before)
    if text == before:
        raise Broken(f"{case}: nothing in in.liggghts to change for '{tag}'")
    with open(path, "w", encoding="utf-8") as f:
        f.write(text)
    outcome = coupled.execute(["sh", os.path.join(folder, "run.sh")], _LIMIT)
    if outcome.status != 0:
        said = [x.strip() for x in outcome.output.splitlines()
                if "ERROR" in x or x.startswith(("liggghts-clay:", "clayFoam:"))]
        raise Broken(said[0] if said else f"exit code {outcome.status}")
    return folder


def wall(folder):
    """Seconds from the first exchange to the end, without starting up."""
    with open(os.path.join(folder, "DEM", "dem.json"), encoding="utf-8") as f:
        return json.load(f)["wall_s"]


def curve(folder):
    return runs.curve(folder)


def kept_curve(case, changes, tell):
    """The curve of a run that is made once, whatever the programs: the values
    and the input files decide. For references."""
    probe = casefile.Case(case)
    key = hashlib.sha256(json.dumps([case, changes, runkey.inputs(probe)["files"], probe.values],
                                    sort_keys=True).encode()).hexdigest()[:16]
    path = os.path.join(PLACE, "references", f"{case}-{key}.csv")
    if not os.path.isfile(path):
        tell(f"{case}: the reference, {runs.words(changes)} ...")
        began = time.monotonic()
        folder = made(case, changes, "reference")
        os.makedirs(os.path.dirname(path), exist_ok=True)
        shutil.copy(os.path.join(folder, "settling.csv"), path + ".part")
        os.replace(path + ".part", path)
        tell(f"{case}: the reference took {time.monotonic() - began:.0f} s")
    with open(path, encoding="utf-8") as f:
        head = f.readline().strip().split(",")
        rows = [[float(x) for x in line.split(",")] for line in f if line.strip()]
    import numpy as np
    return {k: np.array([r[i] for r in rows]) for i, k in enumerate(head)}


_THERMO = re.compile(r"^\s*(\d+)\s+\d+\s+([\d.eE+-]+)\s*$")


def alone(folder, change=None, program="liggghts-clay"):
    """The DEM half of a prepared run folder without a fluid: seconds by step,
    [(step, seconds)], from its thermo output. change(text) edits in.liggghts."""
    place = folder + "-alone"
    shutil.rmtree(place, ignore_errors=True)
    shutil.copytree(folder, place, ignore=shutil.ignore_patterns("CFD"))
    os.makedirs(os.path.join(place, "DEM"), exist_ok=True)
    path = os.path.join(place, "in.liggghts")
    if change:
        with open(path, encoding="utf-8") as f:
            text = change(f.read())
        with open(path, "w", encoding="utf-8") as f:
            f.write(text)
    run = launch.Run(place, 1, 0)
    log = os.path.join(place, "DEM", "log")
    done = subprocess.run(["mpirun", "--bind-to", "none", "-np", "1", program, "-in", "in.liggghts", "-log", log,
                           "-screen", "none", "-var", "fluid", "alone"], cwd=place, env=run.environment(),
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False)
    with open(log, encoding="utf-8", errors="replace") as f:
        lines = f.readlines()
    if done.returncode:
        said = [x.strip() for x in lines if x.startswith("ERROR")]
        raise Broken(f"the DEM half alone: {said[0] if said else done.stdout.strip()[-200:]}")
    found = [(int(m.group(1)), float(m.group(2))) for m in map(_THERMO.match, lines) if m]
    return found


def yardstick():
    """Seconds that a fixed piece of work in LIGGGHTS's own styles takes now."""
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "yardstick.liggghts")
    run = launch.Run(PLACE, 1, 0)
    began = time.monotonic()
    done = subprocess.run(["mpirun", "--bind-to", "none", "-np", "1", "liggghts-clay", "-in", script, "-log", "none"],
                          cwd=PLACE, env=run.environment(), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode:
        raise Broken(f"the yardstick: {done.stdout.strip()[-200:]}")
    return time.monotonic() - began
