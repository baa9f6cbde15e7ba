# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A run that is ended from outside and goes on by cases/run --continue, against one that nothing was done to."""

import csv
import os
import random
import signal

from cases.lib.run import saved_pairs as pairs
from validation.lib.faults.kills import wanted_code
from validation.lib.faults.victim import Run

# spheres: two runs that differ by rounding stay together longer than clumps do
CASE = "sphere-half"
# a saved state every 0.02 s: nobody tells the run of the kill that it would be well to save one
WORDS = ("--end", "0.5", "--set", "seed=977", "--set", "spheres=40", "--set", "checkpoint_steps=1000")
STEPS = 25000
INTERVAL = 1e-3  # [s] of the coupling
TRIALS = (("DEM half", "KILL"), ("CFD half", "KILL"), ("mpirun", "KILL"), ("cases/run", "KILL"), ("DEM half", "SEGV"),
          ("CFD half", "SEGV"), ("mpirun", "SEGV"), ("cases/run", "SEGV"), ("CFD half", "TERM"), ("CFD half", "INT"),
          ("CFD half", "USR1"), ("CFD half", "HUP"), ("DEM half", "TERM"), ("DEM half", "INT"), ("DEM half", "USR1"),
          ("cases/run", "TERM"), ("cases/run", "INT"), ("cases/run", "USR1"), ("mpirun", "USR1"))
# to these both halves save their states at the next exchange, or at the one after
SAVES = {("CFD half", "TERM"), ("CFD half", "INT"), ("CFD half", "USR1"), ("CFD half", "HUP"), ("DEM half", "TERM"),
         ("DEM half", "INT"), ("DEM half", "USR1"), ("cases/run", "TERM"), ("cases/run", "INT"), ("cases/run", "USR1"),
         ("mpirun", "USR1")}
# and here the halves, left alone, are told to end
BESIDE = SAVES | {("cases/run", "KILL"), ("cases/run", "SEGV")}


def plan(tries, seed=1):
    """What is to be tried, as kills.plan() has it."""
    found = []
    for target, name in TRIALS:
        for number in range(tries):
            rng = random.Random(f"on {seed} {target} {name} {number}")
            found.append({"target": target, "signal": name, "number": number, "moment": rng.uniform(0, 1),
                          "ranks": rng.choice([(1, 1), (1, 1), (2, 1)])})
    return found


def curve(folder):
    """The rows of settling.csv as numbers, without the days."""
    with open(os.path.join(folder, "settling.csv"), encoding="utf-8", newline="") as f:
        return [[float(r[k]) for k in r if k != "time_days"] for r in csv.DictReader(x for x in f if x[0] != "#")]


def apart(one, other):
    """The largest difference of two curves, by the largest value of the column; infinite where rows differ."""
    if len(one) != len(other) or not one:
        return float("inf")
    size = [max(max(abs(x) for x in column), 1e-300) for column in zip(*one)]
    return max(abs(a - b) / s for r, t in zip(one, other) for a, b, s in zip(r, t, size))


def ranks(trial):
    dem, cfd = trial["ranks"]
    return ("--dem", str(dem), "--cfd", str(cfd))


def whole(folder, trial):
    """The curve of a run on these ranks that nothing is done to; None and what it said when it did not end well."""
    with Run(CASE, folder, "--overwrite", *WORDS, *ranks(trial)) as run:
        code, _ = run.end()
        return (curve(folder), "") if code == 0 else (None, run.said().strip()[-200:])


def saved(folder):
    """The step of the last saved state in a run's folder, 0 without one."""
    top = os.path.join(folder, pairs.FOLDER)
    return max((int(d) for d in os.listdir(top) if d.isdigit()), default=0) if os.path.isdir(top) else 0


def attempt(trial, folder, wanted, most):
    """Ends one amid its march and goes on; what was wrong, "" for nothing. most: how far from the wanted curve."""
    number = getattr(signal, "SIG" + trial["signal"])
    with Run(CASE, folder, "--overwrite", *WORDS, *ranks(trial)) as run:
        # by what it has saved, since wall time is short and not the same twice; marches(): not the folder of a run
        # that was here before
        if not run.until(lambda: run.marches() and saved(folder) > 0.7 * trial["moment"] * STEPS):
            return f"did not come to the saved state it waits for: {run.said().strip()[-200:]}"
        if not run.send(trial["target"], number):
            return f"nobody to send it to: {run.said().strip()[-200:]}"
        code, _ = run.end()
        left = run.left()
        if code != wanted_code(trial["target"], trial["signal"]) or left:
            return f"exit code {code}, left: {left}: {run.said().strip()[-200:]}"
        if run.state().get("complete") and code > 0:
            return "was complete before the signal came"
        said = run.said()
    # the halves of a cases/run that was killed may have come to their end
    last = pairs.latest(folder, lambda _: None, before=STEPS)
    if (trial["target"], trial["signal"]) in SAVES and not last.time >= run.state().get("simulated_s", 0) - INTERVAL:
        return f"{last.folder} is the last state, the run said: {said.strip()[-200:]}"
    if "--continue" not in said and code > 0:
        return f"it was not said that it can go on: {said.strip()[-200:]}"
    with Run(CASE, folder, "--continue") as run:
        code, _ = run.end()
        said = run.said()
        if code != 0:
            return f"--continue: exit code {code}: {said.strip()[-200:]}"
        if f"goes on from {last.time:.6g} s" not in said or not run.state().get("complete"):
            return f"--continue says: {said.strip()[:200]}"
    far = apart(wanted, curve(folder))
    return "" if far <= most else f"the curve is {far:.2g} from that of a run that was not ended"
