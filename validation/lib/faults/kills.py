# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Signals to the parts of a run at random moments, drawn from a seed."""

import os
import random
import signal
import time

from validation.lib.faults.victim import Run

TARGETS = ("DEM half", "CFD half", "mpirun", "cases/run")
SIGNALS = ("KILL", "TERM", "INT", "SEGV", "HUP", "USR1")
SECONDS = 10  # in which all has ended
# signals to cases/run that it answers by itself
_ANSWERED = {"TERM", "INT", "HUP", "USR1"}


def plan(tries, seed=1, signals=SIGNALS):
    """What is to be tried: (target, signal, number, moment, start-up or march, background job, ranks)."""
    found = []
    for target in TARGETS:
        for name in signals:
            for number in range(tries):
                rng = random.Random(f"{seed} {target} {name} {number}")
                found.append({"target": target, "signal": name, "number": number, "moment": rng.uniform(0, 1.5),
                              "during": rng.choice(["start-up", "march", "march"]),
                              "background": rng.random() < 0.3, "ranks": rng.choice([(1, 1), (1, 1), (2, 1)])})
    return found


def wanted_code(target, name):
    """The exit code that cases/run must have."""
    number = getattr(signal, "SIG" + name)
    if target != "cases/run":
        return 1
    return 128 + number if name in _ANSWERED else -number


def attempt(trial, folder):
    """Does one; a line that says what was wrong, "" when nothing was."""
    number = getattr(signal, "SIG" + trial["signal"])
    dem, cfd = trial["ranks"]
    ignore = (signal.SIGINT,) if trial["background"] else ()
    with Run("clump-half", folder, "--overwrite", "--end", "5", "--dem", str(dem), "--cfd", str(cfd),
             ignore=ignore) as run:
        ready = run.started if trial["during"] == "start-up" else run.marches
        if not run.until(ready):
            return f"did not come to its {trial['during']}: {run.said().strip()[-200:]}"
        time.sleep(trial["moment"])
        run.look()
        if not run.send(trial["target"], number):
            return f"nobody to send it to: {run.said().strip()[-200:]}"
        return judge(run, trial)


def judge(run, trial):
    """What was wrong with the end of a run that a signal was sent to."""
    code, seconds = run.end()
    if code is None:
        return f"goes on after {seconds:.0f} s"
    left = run.left(SECONDS)
    if left:
        return f"left after {SECONDS} s: {' '.join(left)}"
    want = wanted_code(trial["target"], trial["signal"])
    if code != want:
        return f"exit code {code}, not {want}: {run.said().strip()[-200:]}"
    state = run.state()
    if state.get("complete") is not False or not state.get("reason"):
        return f"summary.json says {state}"
    said = run.said()
    if "Traceback" in said:
        return "a traceback: " + said.strip().splitlines()[-1]
    if want > 0 and state["reason"] not in said:
        return f"the reason was not said: {state['reason']}"
    return ""


def stopped(folder, target, seconds, timeout):
    """SIGSTOP for so many seconds with this time-out, then SIGCONT: (exit code, state, what was said)."""
    with Run("clump-half", folder, "--overwrite", "--end", "0.3", env={"CLAYFOAM_TIMEOUT": str(timeout)}) as run:
        if not run.until(run.marches):
            return None, {}, run.said()
        run.look()
        run.send(target, signal.SIGSTOP)
        end = time.monotonic() + seconds
        while run.look() and time.monotonic() < end:
            time.sleep(0.05)
        run.send(target, signal.SIGCONT)
        code, _ = run.end()
        left = run.left()
        return code, run.state(), run.said() + (f" left: {left}" if left else "")


def twice(folder):
    """Two runs into one folder at once: (exit codes, what both said, the state)."""
    words = ("--overwrite", "--end", "0.02")
    with Run("clump-half", folder, *words) as one, Run("clump-half", folder, *words) as other:
        codes = [one.end()[0], other.end()[0]]
        return codes, one.said() + other.said(), one.state()


def remains(folder):
    """Hidden parts of files that were never renamed."""
    return [n for n in os.listdir(folder) if n.startswith(".") and n != ".lock"]
