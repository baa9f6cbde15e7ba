# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""validation/bench: run time against the error of the settling curve, and the targets."""

import argparse
import csv
import json
import os
import statistics
import time

from cases.lib.case import casefile
from cases.lib.case.errors import CaseError
from cases.lib.case.program import run as run_program
from cases.lib.run import runkey
from validation.lib.bench import bench_curve, bench_plan, bench_run
from validation.lib.checks.verdicts import Broken

COLUMNS = ("case", "setting", "value", "wall_s", "wall_ratio", "error", "seed_spread", "on_front", "error_mean_height",
           "note")


def parser():
    p = argparse.ArgumentParser(
        prog="validation/bench", allow_abbrev=False,
        description="Measures run time against error: each setting by itself, beside runs of what is shipped.",
        epilog="validation/bench targets measures the table of targets, validation/bench skips the table of what is "
               "skipped. A later run says what has changed since the "
               "last one that was kept.")
    p.add_argument("what", nargs="?", choices=["settings", "targets", "skips"], default="settings",
                   help="settings, targets, or what is skipped")
    p.add_argument("--case", action="append", choices=list(bench_plan.CASES), help="only this case")
    p.add_argument("--setting", action="append", metavar="KEY", help="only this setting")
    p.add_argument("--repeats", type=int, metavar="N", help="timed runs of each point (3, --quick 1)")
    p.add_argument("--seeds", type=int, metavar="N", help="packings for the spread, 2 at least (4, --quick 2)")
    p.add_argument("--window", type=float, metavar="T", help="simulated time in s (0.5, --quick 0.03)")
    p.add_argument("--quick", action="store_true", help="few points of short runs: to see that it works")
    p.add_argument("--full", action="store_true",
                   help="targets: simulate all of the full-size column's 64 s in place of the first")
    p.add_argument("--json", metavar="FILE", help="write the rows as a list of objects, too")
    return p


def say(line):
    print(line, flush=True)


def fitted(window, values, changes):
    """The window [s], stretched to whole coupling intervals of the run."""
    v = {**values, **changes}
    interval = v["dem_step"] * int(v["coupling_steps"])
    return float(f"{max(1, round(window / interval)) * interval:.10g}")


class Sweep:
    """The points of one case."""

    def __init__(self, case, args):
        self.case, self.args = case, args
        self.values = casefile.Case(case).values
        self.window = args.window or bench_plan.WINDOW["quick" if args.quick else "full"]
        self.repeats = args.repeats or (1 if args.quick else 3)
        self.seeds = args.seeds or (2 if args.quick else 4)

    def _run(self, changes):
        accurate = casefile.Case(self.case)
        from cases.lib.case import settings
        settings.apply(accurate, {k: v for k, v in changes.items()})
        end = fitted(self.window, accurate.values, {})
        return bench_run.made(self.case, {**changes, "end": end, "curve_rows": 200})

    def go(self):
        """All rows of the case."""
        say(f"{self.case}: {self.window:g} s simulated, {self.repeats} repeats, {self.seeds} seeds")
        points = [p for p in bench_plan.settings(self.values, self.args.quick)
                  if not self.args.setting or p[0] in self.args.setting]
        changes = bench_plan.reference(self.values)
        changes["end"] = fitted(self.window, self.values, changes)
        reference = bench_run.kept_curve(self.case, {**changes, "curve_rows": 200}, say)

        curves = [bench_run.curve(self._run({"seed": s})) for s in range(1, self.seeds + 1)]
        spread = bench_curve.spread(curves)
        say(f"{self.case}: spread of the seeds {100 * spread:.2g} %")
        walls, base, found, notes = [[] for _ in points], [], {}, {}
        began, made, total = time.monotonic(), 0, self.repeats * len(points)
        for _ in range(self.repeats):
            folder = self._run({})
            line = [bench_run.wall(folder)]
            for k, (setting, value, changes) in enumerate(points):
                try:
                    mine = self._run(changes)
                    found[k] = bench_run.curve(mine)
                    took = bench_run.wall(mine)
                except Broken as e:
                    notes[k], took = str(e), None
                folder = self._run({})
                line.append(bench_run.wall(folder))
                if took is not None:
                    ratio = bench_curve.ratios([took], line[-2:])[0]
                    walls[k].append((took, ratio))
                made += 1
                left = (time.monotonic() - began) / made * (total - made)
                say(f"{self.case} {made} of {total}, ETA {int(left) // 60}:{int(left) % 60:02d}: {setting} {value}"
                    + (f": {ratio:.3g} times the baseline's wall time" if took is not None else f": {notes[k]}"))
            base += line
        rows = [self._row("baseline", "as shipped", bench_run.curve(folder), reference, spread,
                          [(w, 1.0) for w in base])]
        for k, (setting, value, _) in enumerate(points):
            rows.append(self._row(setting, value, found.get(k), reference, spread, walls[k], notes.get(k, "")))
        good = [r for r in rows if r["wall_ratio"] is not None]
        for row, on in zip(good, bench_curve.front([(r["wall_ratio"], r["error"]) for r in good])):
            row["on_front"] = on
        return rows

    def _row(self, setting, value, curve, reference, spread, walls, note=""):
        row = dict.fromkeys(COLUMNS)
        row.update(case=self.case, setting=setting, value=value, seed_spread=spread, on_front=False, note=note)
        if curve is not None and walls:
            row.update(wall_s=statistics.median(w for w, _ in walls), wall_ratio=statistics.median(r for _, r in walls),
                       error=bench_curve.difference(curve, reference),
                       error_mean_height=bench_curve.difference(curve, reference, "mean_height_m"))
        return row


def table(rows):
    lines = [f"{'case':<13}{'setting':<16}{'value':<14}{'wall s':>9}{'ratio':>8}{'error %':>9}{'spread %':>9}  front"]
    for r in rows:
        value = r["value"] if isinstance(r["value"], str) else f"{r['value']:.4g}"
        if r["wall_s"] is None:
            lines.append(f"{r['case']:<13}{r['setting']:<16}{value:<14}{r['note'][:70]}")
            continue
        lines.append(f"{r['case']:<13}{r['setting']:<16}{value:<14}{r['wall_s']:>9.3g}{r['wall_ratio']:>8.3f}"
                     f"{100 * r['error']:>9.3g}{100 * r['seed_spread']:>9.3g}  "
                     f"{'yes' if r['on_front'] else ''}".rstrip())
    return "\n".join(lines)


def history(kind, quick, rows, yardstick):
    """Says what has changed since the last rows of this kind, and keeps these."""
    path = os.path.join(bench_run.PLACE, "history.jsonl")
    last = None
    try:
        with open(path, encoding="utf-8") as f:
            for line in f:
                entry = json.loads(line)
                if entry["kind"] == kind and entry["quick"] == quick:
                    last = entry
    except (OSError, ValueError):
        pass
    programs = runkey.programs()
    with open(path, "a", encoding="utf-8") as f:
        f.write(json.dumps({"kind": kind, "quick": quick, "time": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime()),
                            "programs": programs, "yardstick_s": yardstick, "rows": rows}) + "\n")
    return compared(rows, yardstick, last, programs) if last else "nothing was kept before: no comparison"


def compared(rows, yardstick, last, programs=None):
    """Lines on what a change has paid: wall times in yardsticks, a fixed run of
    LIGGGHTS's own styles made beside, so that another load of the machine cancels."""
    same = programs == last.get("programs")
    lines = [f"since {last['time']} ({'the same programs' if same else 'programs have changed'}; "
             f"wall times in runs of the yardstick, {yardstick:.3g} s):"]
    old = {(r.get("case"), r.get("setting"), str(r.get("value"))): r for r in last["rows"]}
    for r in rows:
        o = old.get((r.get("case"), r.get("setting"), str(r.get("value"))))
        if not o or not o.get("wall_s") or not r.get("wall_s"):
            continue
        now, was = r["wall_s"] / yardstick, o["wall_s"] / last["yardstick_s"]
        lines.append(f"  {r['case']} {r['setting']} {r['value']}: {now:.3g}, was {was:.3g} "
                     f"({100 * (now / was - 1):+.0f} %); error {100 * r['error']:.3g} %, was {100 * o['error']:.3g} %")
    return "\n".join(lines)


def write(name, rows, columns, target):
    os.makedirs(bench_run.PLACE, exist_ok=True)
    with open(os.path.join(bench_run.PLACE, name + ".csv"), "w", encoding="utf-8", newline="") as f:
        out = csv.DictWriter(f, columns, lineterminator="\n")
        out.writeheader()
        out.writerows(rows)
    for path in [os.path.join(bench_run.PLACE, name + ".json")] + ([target] if target else []):
        with open(path, "w", encoding="utf-8") as f:
            json.dump(rows, f, indent=1)
            f.write("\n")


def check(args):
    for option, value, least in (("--repeats", args.repeats, 1), ("--seeds", args.seeds, 2)):
        if value is not None and value < least:
            raise CaseError(f"{option} {value}: must be at least {least}")
    if args.window is not None and not args.window > 0:
        raise CaseError(f"--window {args.window}: must be above 0")
    for key in args.setting or ():
        known = {p[0] for c in bench_plan.CASES for p in bench_plan.settings(casefile.Case(c).values)}
        if key not in known:
            raise CaseError(casefile.nearest(key, sorted(known), "setting"))


def main():
    args = parser().parse_args()
    check(args)
    os.makedirs(bench_run.PLACE, exist_ok=True)
    if args.what == "targets":
        from validation.lib.bench import bench_targets
        rows = bench_targets.measure(args.quick, args.full, say)
        write("targets", rows, bench_targets.COLUMNS, args.json)
        say(bench_targets.table(rows))
        say(f"results in {bench_run.PLACE}")
        return 0 if all(r["passed"] for r in rows) else 1
    if args.what == "skips":
        from validation.lib.bench import bench_picture
        from validation.lib.bench import bench_skips
        rows = bench_skips.measure(args.quick, args.repeats, say)
        write("skips", rows, bench_skips.COLUMNS, args.json)
        bench_picture.draw_skips(os.path.join(bench_run.PLACE, "skips.png"), rows)
        say(bench_skips.table(rows))
        say(f"results in {bench_run.PLACE}")
        return 0
    rows = []
    yardstick = bench_run.yardstick()
    for case in args.case or bench_plan.CASES:
        try:
            rows += Sweep(case, args).go()
        except Broken as e:
            raise CaseError(f"{case}: {e}") from None
    yardstick = 0.5 * (yardstick + bench_run.yardstick())
    write("bench", rows, COLUMNS, args.json)
    from validation.lib.bench import bench_picture
    bench_picture.draw(os.path.join(bench_run.PLACE, "bench.png"), rows)
    say(table(rows))
    say(history("settings", args.quick, rows, yardstick))
    say(f"results in {bench_run.PLACE}")
    return 0


if __name__ == "__main__":
    run_program(main, "validation/bench")
