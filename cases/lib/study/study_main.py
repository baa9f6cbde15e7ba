# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/study: what sets the second and third stage of a settling curve, a table."""

import argparse
import dataclasses
import datetime
import os
import re
import sys

import numpy as np

from cases.lib.case import files, program, settings
from cases.lib.case.casefile import CASES
from cases.lib.case.errors import CaseError, nearest
from cases.lib.case.places import called
from cases.lib.case.program import run as run_program
from cases.lib.run import launch, runs
from cases.lib.study import measure, rows

PAGE = os.path.join(CASES, "STUDY.md")
_TABLE = re.compile(r"(<!-- study -->\n).*?(<!-- end of study -->)", re.S)


def parser():
    p = argparse.ArgumentParser(
        prog=called("study"), allow_abbrev=False,
        description="Runs small columns of charged clumps, one thing changed at a time; what their stages are.",
        epilog="A run that was made before is not made again.")
    p.add_argument("rows", nargs="*", metavar="ROW", help="rows of the table (all)")
    p.add_argument("--list", action="store_true", help="list the rows and stop")
    p.add_argument("--seeds", type=int, default=3, metavar="N", help="packings 1 to N of each (3)")
    p.add_argument("--jobs", type=int, metavar="N", help="runs at once (half the cores), at most the cores")
    p.add_argument("--store", metavar="DIR", help="where the runs are kept (results/runs)")
    p.add_argument("--out", metavar="DIR", help="where study.json goes (results/study)")
    p.add_argument("--dry-run", action="store_true", help="list the runs, and which are there already")
    p.add_argument("--finished", action="store_true", help="the table of the runs that are there, none is made")
    p.add_argument("--record", action="store_true", help="put the table into cases/STUDY.md")
    return p


def spread(values, unit=1.0, digits=3):
    """Mean and, of several, half the range; a bar where a value is not there."""
    there = [unit * v for v in values if v is not None]
    if not there:
        return "-"
    half = 0.5 * (max(there) - min(there))
    said = f"{np.mean(there):.{digits}g}" + (f" ± {half:.2g}" if len(there) > 1 else "")
    return said + (f" ({len(there)} of {len(values)})" if len(there) < len(values) else "")


def line(name, found):
    """A row of the table, of all its runs."""
    def all_of(key):
        return [getattr(m, key) for m in found]

    ratios = [m.ratio for m in found]
    return [f"`{name}`", rows.ROWS[name][0], str(len(found)), "/".join(str(m.stages) for m in found),
            spread(all_of("slope_1"), 1e3), spread(all_of("first")), spread(all_of("height_1"), 1e3),
            spread(all_of("slope_2"), 1e3, 2), spread(all_of("height"), 1e3), spread(all_of("half")),
            spread(all_of("drained")), spread(all_of("done")), spread(all_of("falling"), 1e3, 2),
            spread([None if r is None else measure.PAPER_DAYS[0] * r for r in ratios], 1.0, 2)]


HEAD = ["row", "", "runs", "stages", "slope 1 [mm/s]", "first stage ends [s]", "at [mm]", "slope 2 [mm/s]",
        "interface at the end [mm]", "stresses carry over half from [s]", "drained from [s]", "99 % of the fall at [s]",
        "still falling [mm/s]", "the same in days, were the first stage 10 d"]


def table(found):
    """The table as Markdown."""
    lines = ["| " + " | ".join(HEAD) + " |", "|" + "---|" * len(HEAD)]
    lines += ["| " + " | ".join(line(name, of)) + " |" for name, of in found.items() if of]
    return "\n".join(lines)


def record(text, failed):
    """Puts the table into the page."""
    with open(PAGE, encoding="utf-8") as f:
        page = f.read()
    left = [n for n in rows.ROWS if f"| `{n}` |" not in text]
    said = f"{datetime.date.today().isoformat()}."
    if left:
        said += " Not run: " + ", ".join(f"`{n}` ({rows.ROWS[n][0]})" for n in left) + "."
    if failed:
        said += " Failed: " + "; ".join(failed) + "."
    with files.writing(PAGE) as f:
        f.write(_TABLE.sub(lambda m: f"{m[1]}{said}\n\n{text}\n{m[2]}", page))


def main():
    args = parser().parse_args()
    if args.list:
        print("\n".join(f"{name:<14}{what}" for name, (what, _) in rows.ROWS.items()))
        return 0
    for name in args.rows:
        if name not in rows.ROWS:
            raise CaseError(nearest(name, list(rows.ROWS), "row"))
    if args.seeds < 1:
        raise CaseError(f"--seeds {args.seeds}: must be at least 1")
    if args.jobs is not None and not 1 <= args.jobs <= launch.cores():
        raise CaseError(f"--jobs {args.jobs}: must be from 1 to {launch.cores()}, the number of cores")
    wanted = [(name, seed) for name in args.rows or rows.ROWS for seed in range(1, args.seeds + 1)]
    store = runs.Store(args.store)
    if args.dry_run:
        for name, seed in wanted:
            there = store.finished(rows.CASE, rows.changes(name, seed))
            print(f"{'there ' if there else 'to run'}  {name} {runs.words(rows.changes(name, seed))}")
        return 0
    out = settings.folder(args.out, "study")
    if args.finished:
        there = {w: store.finished(rows.CASE, rows.changes(*w)) for w in wanted}
        wanted = [w for w in wanted if there[w]]
        results = [runs.Result(there[w]) for w in wanted]
    else:
        results = store.run_many([(rows.CASE, rows.changes(*w)) for w in wanted], args.jobs)
    if not wanted:
        raise CaseError("--finished: none of the runs is there; without it they are made")
    found, failed = {name: [] for name, _ in wanted}, []
    for (name, seed), result in zip(wanted, results):
        if result.error:
            failed.append(f"{name}, packing {seed}: {result.error}")
        else:
            found[name].append(measure.of(result.folder))
    text = table(found)
    print(text)
    path = os.path.join(out, "study.json")
    program.result(path)
    files.write_json(path, {"case": rows.CASE, "rows": {
        name: {"is": rows.ROWS[name][0], "changes": {**rows.BASE, **rows.ROWS[name][1]},
               "runs": [dataclasses.asdict(m) for m in of]} for name, of in found.items()}})
    print(f"study.json in {out}")
    if args.record:
        record(text, failed)
    for words in failed:
        print(f"{called('study')}: {words}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    run_program(main, called("study"))
