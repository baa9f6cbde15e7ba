# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/sweep: runs a case over a grid of values, each point once."""

import argparse
import csv
import itertools
import json
import math
import os
import sys

from cases.lib.calibration import stagefit
from cases.lib.case import heading, program, settings
from cases.lib.case.casefile import Case, text
from cases.lib.case.errors import CaseError
from cases.lib.case.places import called
from cases.lib.case.program import run as run_program
from cases.lib.run import launch, runs

_MOST_RUNS = 10000


def parser():
    p = argparse.ArgumentParser(
        prog=called("sweep"), allow_abbrev=False,
        description="Runs a case over a grid of values; a run that was made before is not made again.",
        epilog=f"{called('run')} NAME --keys lists a case's keys.")
    p.add_argument("name", metavar="CASE", help="the case")
    p.add_argument("--set", action="append", default=[], metavar="KEY=A,B,C", required=True,
                   help="the values a key takes, each with each of the other keys'; one value: for all runs")
    p.add_argument("--seeds", type=int, metavar="N", help="repeat every point with the packings 1 to N")
    p.add_argument("--end", metavar="T", help="simulated time in s, short for --set end=T")
    p.add_argument("--jobs", type=int, metavar="N", help="runs at once (half the cores), at most the cores")
    p.add_argument("--store", metavar="DIR", help="where the runs are kept (results/runs)")
    p.add_argument("--out", metavar="DIR", help="where table and picture go (results/sweeps/CASE-KEYS)")
    p.add_argument("--dry-run", action="store_true", help="list the runs, and which are there already")
    return p


def grid(words):
    """The lists of values by key, from KEY=A,B,C; a key given again starts anew."""
    found = {}
    for s in words:
        key, values = settings.split(s, form="KEY=A,B,C")
        values = [v.strip() for v in values.split(",")]
        if not all(values):
            raise CaseError(f"--set {s}: must have the form KEY=A,B,C")
        if len(set(values)) < len(values):
            raise CaseError(f"--set {s}: a value is there twice")
        found[key] = values
    return found


def points(name, words, seeds=None):
    """The grid's points as lists of changes, the keys that vary, in order, and
    what follows."""
    values = grid(words)
    for key, several in values.items():
        for v in several:
            Case(name).set(key, v)
    if seeds is not None:
        if "seed" in values:
            raise CaseError("--seeds: the key seed is set, too; take one of them")
        if seeds < 1:
            raise CaseError(f"--seeds {seeds}: must be at least 1")
        values["seed"] = [str(s) for s in range(1, seeds + 1)]
    varied = [k for k, v in values.items() if len(v) > 1 and k != "seed"]
    count = math.prod(len(v) for v in values.values())
    if count > _MOST_RUNS:
        raise CaseError(f"--set: {count} runs; must be at most {_MOST_RUNS}")
    case, made, extra = Case(name), [], {}
    for combination in itertools.product(*values.values()):
        one = dict(zip(values, combination))
        more = settings.follow(case, one)
        made.append({**more, **one})
        extra.update(more)
    return made, varied or [k for k, v in values.items() if len(v) > 1][:1], extra


def stages(folder):
    """The stages of a run's upper interface, in plain numbers."""
    rows = runs.curve(folder)
    s = stagefit.of(rows["time_s"], rows["interface_m"])
    return {"count": s.count, "start_s": s.start, "slopes_m_per_s": s.slopes.tolist(),
            "slopes_ci": s.slopes_ci.tolist(), "breaks_s": s.breaks.tolist(), "breaks_ci": s.breaks_ci.tolist(),
            "near_linear": [bool(x) for x in s.near_linear]}


def point(changes, result):
    """A point's row: its parameters, and what came out."""
    row = {"parameters": changes, "folder": result.folder, "error": result.error,
           "wall_s": round(result.wall_s, 3), "interface_end_m": None, "stages": None}
    if not result.error:
        row["interface_end_m"] = float(runs.curve(result.folder)["interface_m"][-1])
        row["stages"] = stages(result.folder)
    return row


def table(rows, shown):
    """The points, one a line."""
    head = [*shown, "stages", "slope 1", "slope 2", "slope 3", "break 1", "break 2", "end", "wall"]
    units = [""] * len(shown) + ["", "mm/s", "mm/s", "mm/s", "s", "s", "mm", "s"]
    lines = [head, units]
    for row in rows:
        line = [str(row["parameters"].get(k, "")) for k in shown]
        s = row["stages"]
        if s is None:
            lines.append(line + ["failed"] + [""] * 7)
            continue
        slopes = [f"{1e3 * x:.3g}" for x in s["slopes_m_per_s"]]
        breaks = [f"{x:.3g}" for x in s["breaks_s"]]
        lines.append(line + [str(s["count"])] + slopes + ["-"] * (3 - len(slopes)) + breaks
                     + ["-"] * (2 - len(breaks)) + [f"{1e3 * row['interface_end_m']:.1f}", f"{row['wall_s']:.0f}"])
    wide = [max(len(line[i]) for line in lines) for i in range(len(head))]
    return "\n".join("  ".join(x.rjust(w) for x, w in zip(line, wide)).rstrip() for line in lines)


def write_csv(path, rows, keys):
    """The points as a table for other programs; SI units, slopes as dz/dt."""
    names = [f"slope_{k}_m_per_s{x}" for k in (1, 2, 3) for x in ("", "_low", "_high")]
    names += [f"break_{k}_s{x}" for k in (1, 2) for x in ("", "_low", "_high")]
    with open(path, "w", encoding="utf-8", newline="") as f:
        out = csv.writer(f, lineterminator="\n")
        out.writerow([*keys, "stages", *names, "interface_end_m", "wall_s", "folder", "error"])
        for row in rows:
            s, cells = row["stages"], []
            for count, a, b in ((3, "slopes_m_per_s", "slopes_ci"), (2, "breaks_s", "breaks_ci")):
                for k in range(count):
                    there = s is not None and k < len(s[a])
                    cells += [text(x) for x in (s[a][k], *s[b][k])] if there else [""] * 3
            end = row["interface_end_m"]
            out.writerow([*(row["parameters"].get(k, "") for k in keys), "" if s is None else s["count"],
                          *cells, "" if end is None else text(end), row["wall_s"], row["folder"], row["error"]])


def main():
    args = parser().parse_args()
    words = args.set + ([f"end={args.end}"] if args.end is not None else [])
    if args.jobs is not None and not 1 <= args.jobs <= launch.cores():
        raise CaseError(f"--jobs {args.jobs}: must be from 1 to {launch.cores()}, the number of cores")
    made, varied, extra = points(args.name, words, args.seeds)
    if extra:
        print(settings.said(extra))
    store = runs.Store(args.store)
    if args.dry_run:
        for changes in made:
            print(f"{'there ' if store.finished(args.name, changes) else 'to run'}  {runs.words(changes)}")
        return 0
    out = settings.folder(args.out, "sweeps", "-".join([Case(args.name).name, *varied]))
    results = store.run_many([(args.name, c) for c in made], args.jobs)
    rows = [point(c, r) for c, r in zip(made, results)]

    shown = varied + (["seed"] if any("seed" in c for c in made) and "seed" not in varied else [])
    keys = list(made[0])
    write_csv(os.path.join(out, "sweep.csv"), rows, keys)
    case = Case(args.name)
    settings.apply(case, {k: v for k, v in made[0].items() if all(m[k] == v for m in made)})
    title = heading.of_several(case, varied)
    with open(os.path.join(out, "sweep.json"), "w", encoding="utf-8") as f:
        json.dump({"case": args.name, "title": title, "varied": varied, "points": rows}, f, indent=2)
        f.write("\n")
    program.result(os.path.join(out, "sweep.json"))
    print(table(rows, shown))
    good = [r for r in rows if not r["error"]]
    if good and varied:
        from cases.lib.sweep import sweep_picture
        unit = {k: p.get("unit", "") for k, p in case.parameters.items()}
        sweep_picture.draw(os.path.join(out, "sweep.png"), good, varied, unit, title)
    print(f"results in {out}")
    for row in rows:
        if row["error"]:
            print(f"{called('sweep')}: {row['error']}", file=sys.stderr)
    return 0 if len(good) == len(rows) else 1


if __name__ == "__main__":
    run_program(main, called("sweep"))
