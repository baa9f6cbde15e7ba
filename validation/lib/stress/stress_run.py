# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Makes one run of the stability map and says how it ended."""

import atexit
import os
import re
import shutil
import signal
import subprocess
import threading

from cases.lib.case import casefile, openfoam
from cases.lib.case.errors import CaseError
from cases.lib.run import folders, launch, openmpi, prepare
from validation.lib.stress import stress_bounds, stress_design

LIMIT = 120.0  # [s] after which a run counts as hung
CASE = "stress-scene"
_making = threading.Lock()
_going = set()
_NO_NUMBER = re.compile(r"(?<![a-z])-?nan(?![a-z])|is no number|no numbers", re.I)


def make(point, folder, **values):
    """Fills the run folder, with the case's values that are given in place of the design's; gives
    the scene and the launcher."""
    scene = stress_design.scene(point)
    scene["values"].update(values)
    case = casefile.Case(CASE)
    for key, value in scene["values"].items():
        case.set(key, value if isinstance(value, str) else casefile.text(value))
    # the prepared folder's places: one process, one at a time
    with _making:
        _, lock = folders.claim(case, folder, overwrite=True)
        with lock:
            prepare.fill(folder, case, case.derive(1, 1))
    names = ("ill", "kao") if point["shape"] == "clumps" else ("pos", "neg")
    turn = " 1 0 0 0" if point["shape"] == "clumps" else ""
    with open(os.path.join(folder, "packing.places"), "w", encoding="utf-8") as f:
        f.writelines(f"{names[kind]} {x:.15g} {y:.15g} {z:.15g}{turn}\n" for kind, (x, y, z) in scene["places"])
    with open(os.path.join(folder, "packing.liggghts"), "w", encoding="utf-8") as f:
        f.write(f"fix put all insert/placed file packing.places templates {' '.join(names)} verbose no\n")
    run = launch.Run(folder, 1, 1)
    run.write_script()
    return scene, run


@atexit.register
def end_all():
    """Ends the runs that are going, when the driver is stopped."""
    for process in list(_going):
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGTERM)


def execute(run, limit=LIMIT):
    """Exit code (None: hung) and the line that says why."""
    words = run.command()
    words.insert(1, "--tag-output")
    with open(os.path.join(run.folder, "log"), "w", encoding="utf-8") as log:
        process = subprocess.Popen(words, cwd=run.folder, stdin=subprocess.DEVNULL, stdout=log,
                                   stderr=subprocess.STDOUT, start_new_session=True,
                                   env={**run.environment(), **openmpi.YIELD})
    _going.add(process)
    try:
        status = process.wait(limit)
    except subprocess.TimeoutExpired:
        status = None
    finally:
        _going.discard(process)
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGTERM)
            try:
                process.wait(5)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
    with open(os.path.join(run.folder, "log"), encoding="utf-8", errors="replace") as log:
        return status, reason(log)


def reason(lines):
    """Of what both halves said, the line that tells why they ended."""
    said, after, others = "", "", []
    for line in lines:
        tag = openmpi.TAG.match(line)
        if not tag:
            others.append(line.strip())
            continue
        content = tag.group(3).strip()
        if launch._ERROR.match(content) or tag.group(2) == "err" and launch._LAST_WORD.match(content):
            if launch.AFTERMATH.search(content):
                after = after or content
            else:
                said = said or content
    return said or after or openmpi.noticed(others)


def judge(point, status, why, scene, folder):
    """The outcome's row: outcome, reason, and measures when there are any."""
    if status is None:
        return {"outcome": "failed", "reason": f"hung: no end within {LIMIT:.0f} s"}
    if status:
        if not why or openmpi.NOTICED.match(why) or _NO_NUMBER.search(why):
            return {"outcome": "failed", "reason": why or f"exit code {status} without a word"}
        return {"outcome": "refused", "reason": why}
    measures = stress_bounds.measure(folder, openfoam)
    left = stress_bounds.exceeded(measures, scene)
    row = {"outcome": "failed" if left else "bounded", "reason": "; ".join(left)}
    return {**row, **measures}


def one(point, folder, keep=False):
    """Makes a run; its row of the map."""
    row = dict(point)
    try:
        scene, run = make(point, folder)
    except CaseError as e:
        return {**row, "outcome": "refused", "reason": str(e)}
    row.update(particles=scene["values"]["particles"], solids_reached=scene["solids"],
               interval_reached=scene["interval_ratio"], dem_step=scene["values"]["dem_step"],
               coupling_steps=scene["values"]["coupling_steps"], exchanges=scene["exchanges"])
    status, why = execute(run)
    try:
        row.update(judge(point, status, why, scene, folder))
    except (OSError, ValueError, KeyError, IndexError, CaseError) as e:
        row.update(outcome="failed", reason=f"its output cannot be read: {type(e).__name__}: {e}")
    if not keep and row["outcome"] == "bounded":
        shutil.rmtree(folder, ignore_errors=True)
    return row
