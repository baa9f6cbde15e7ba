# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Runs rows of the matrix, each beside the same on one rank of each half."""

import concurrent.futures
import os
import re
import threading

from cases.lib.run import launch, openmpi
from validation.lib.checks import coupled
from validation.lib.checks.verdicts import Broken
from validation.lib.matrix import answers, axes, pairs, scene

FOLDER = os.path.join(coupled.RUNS, "parallel-matrix")
LIMIT = 120         # s for a run; one takes 1 to 3
TOLERANCE = 1e-9
_SAID = re.compile(r"^(clayFoam|liggghts-clay): (refused|stopped|error)|^\s*ERROR|FOAM FATAL|"
                   + openmpi.NOTICED.pattern, re.M)


def rows():
    """The rows by name, pairs first and then those that must be refused."""
    every = pairs.all_pairs(axes.AXES, axes.allowed)
    return {**{f"pairs{n:03d}": row for n, row in enumerate(every, 1)},
            **{f"refused{n:02d}": row for n, row in enumerate(axes.refused_rows(), 1)}}


def said(output):
    """The line in which a run says why it ended."""
    lines = [x.strip() for x in output.splitlines() if _SAID.search(x) and not launch.AFTERMATH.search(x)]
    return lines[0] if lines else " ".join(output.split()[-12:])


def start(folder, row, substitutes=None):
    """Makes and runs a case; how it ended."""
    scene.write(folder, row, substitutes)
    halves = launch.Run(folder, row["dem"], row["cfd"])
    return coupled.execute(halves.command(), LIMIT, cwd=folder, env=halves.environment())


def answer(folder, row):
    """The end of a run that must end well."""
    outcome = start(folder, row)
    if outcome.status is None:
        raise Broken(f"no end within {LIMIT} s: it hangs, or the machine does much else")
    if outcome.status != 0:
        raise Broken(f"ended with {outcome.status}: {said(outcome.output)}")
    found, counts = answers.read(folder, row)
    wanted = {"overlap": 0, "lost": 0, "elsewhere": 0, "exchanges": scene.EXCHANGES}
    wrong = {k: counts[k] for k, v in wanted.items() if counts[k] != v}
    if counts["residual"] > 1e-10:
        wrong["residual"] = counts["residual"]
    if wrong:
        raise Broken("not as the scene is meant: " + ", ".join(f"{k} {v}" for k, v in wrong.items()))
    return found, counts


class Matrix:
    """Rows and their references, two runs at a time."""

    def __init__(self, chosen, workers):
        self.chosen = chosen
        self.workers = workers
        self.references, self.lock = {}, threading.Lock()

    def run(self):
        """Yields (name, row, verdict) as rows end; a verdict is (passed, text)."""
        with concurrent.futures.ThreadPoolExecutor(self.workers) as pool:
            jobs = {pool.submit(self.verdict, name, row): (name, row) for name, row in self.chosen.items()}
            for job in concurrent.futures.as_completed(jobs):
                yield (*jobs[job], job.result())

    def verdict(self, name, row):
        try:
            reason = axes.refusal(row)
            if reason is not None:
                return self.refused(name, row, reason)
            reference, one = self.reference(row)
            found, many = answer(os.path.join(FOLDER, name), row)
            worst = answers.apart(reference, found)
            bad = {k: v for k, v in worst.items() if not v <= TOLERANCE}
            if bad:
                return False, "differs by " + ", ".join(f"{v:.1e} of the largest {k}" for k, v in bad.items())
            different = [k for k in ("particles", "fluid steps") if one[k] != many[k]]
            if different:
                return False, ", ".join(f"{k} {many[k]} in place of {one[k]}" for k in different)
            return True, f"{max(worst.values()):.1e} ({max(worst, key=worst.get)})"
        except Exception as e:  # whatever a row meets, the others go on
            return False, " ".join(f"{e}".split()) if isinstance(e, Broken) else f"{type(e).__name__}: {e}"

    def refused(self, name, row, reason):
        outcome = start(os.path.join(FOLDER, name), row)
        line = said(outcome.output)
        if outcome.status in (None, 0):
            return False, f"must be refused with '{reason}', ended with {outcome.status}"
        return reason in line, f"refused: {line}"

    def reference(self, row):
        """The answer on one rank of each; made once for the rows that differ in ranks only."""
        base = axes.reference_of(row)
        key = tuple(base.items())
        with self.lock:
            mine = key not in self.references
            if mine:
                self.references[key] = (concurrent.futures.Future(), len(self.references) + 1)
            future, number = self.references[key]
        if mine:
            try:
                future.set_result(answer(os.path.join(FOLDER, f"reference{number:03d}"), base))
            except Exception as e:
                future.set_exception(Broken(f"on one rank of each: {e}"))
        found, counts = future.result()
        return found, counts


def known():
    """The names each of the CFD half's choices has, asked of the program itself: {entry: names}."""
    found = {}
    plain = axes.reference_of({axis: values[0] for axis, values in axes.AXES.items()})
    for entry in axes.MODELS.values():
        nonsense = "(nonsense)" if entry == "forceModels" else "nonsense"
        outcome = start(os.path.join(FOLDER, "known"), plain, {entry: nonsense})
        names = re.search(r"nonsense is not known; known are \(([^)]*)\)", outcome.output)
        if not names:
            raise Broken(f"the CFD half does not say which {entry} it knows: {said(outcome.output)}")
        found[entry] = names.group(1).split()
    return found


def without_a_row(names, axes_of=None):
    """Names the CFD half knows and no row has, and values of axes it does not know, as lines."""
    table = axes_of or axes.AXES
    lines = []
    for axis, entry in axes.MODELS.items():
        mine = [v for v in table[axis] if axis != "force" or v not in axes.NOT_A_FORCE]
        lines += [f"{entry} {n} has no row: add it to the axis {axis}" for n in names[entry] if n not in mine]
        lines += [f"{entry} {n}, of the axis {axis}, is not known to the CFD half"
                  for n in mine if n not in names[entry]]
    return lines
