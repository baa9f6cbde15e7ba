# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""validation/stress: maps where coupled runs stay bounded, and where they are refused."""

import argparse
import csv
import hashlib
import json
import os
import re
import shutil
import sys
import threading
import time
from collections import Counter

from cases.lib.case import settings
from cases.lib.case.errors import CaseError
from cases.lib.case.program import run as run_program
from cases.lib.run import runkey
from validation.lib.checks import coupled
from validation.lib.stress import stress_beds, stress_design, stress_run

OUTCOMES = ("bounded", "refused", "failed")


def parser():
    p = argparse.ArgumentParser(
        prog="validation/stress", allow_abbrev=False,
        description="Maps the stability of coupled runs: each ends bounded, is refused with a reason, or has failed.",
        epilog="A map that was interrupted goes on where it was; programs or scenes that changed begin a new one.")
    p.add_argument("--runs", type=int, metavar="N", help="only N runs, of all parts of the map")
    p.add_argument("--part", choices=("free", "beds"), help="only this part of the map (both)")
    p.add_argument("--json", metavar="FILE", help="write the runs as a list of objects, too")
    p.add_argument("--out", metavar="DIR", help="where runs, table and picture go (results/stress)")
    p.add_argument("--jobs", type=int, default=max(1, len(os.sched_getaffinity(0))), metavar="J",
                   help="runs at once (the cores)")
    p.add_argument("--fresh", action="store_true", help="make every run anew")
    p.add_argument("--record", action="store_true", help="put the counts into validation/STABILITY.md")
    p.add_argument("--only", metavar="ID", action="append", help="make these runs anew and keep their folders")
    return p


def identity(point):
    """A short name of a point."""
    return hashlib.sha256(repr(sorted(point.items())).encode()).hexdigest()[:8]


def version():
    """A hash of what decides the outcomes: programs, scene, sample, bounds."""
    case = stress_run.casefile.Case(stress_run.CASE)
    found = {"programs": runkey.programs(), "inputs": runkey.inputs(case), "values": case.values}
    for module in (stress_design, stress_run, stress_run.stress_bounds, stress_beds, stress_beds.stiff_beds):
        with open(module.__file__, "rb") as f:
            found[module.__name__] = hashlib.sha256(f.read()).hexdigest()
    return hashlib.sha256(json.dumps(found, sort_keys=True).encode()).hexdigest()[:16]


def kept(path, now):
    """The rows that an interrupted map of the same version has left, by name."""
    rows = {}
    try:
        with open(path, encoding="utf-8") as f:
            for line in f:
                try:
                    row = json.loads(line)
                except ValueError:  # cut off in the middle
                    continue
                if row.pop("version", None) == now:
                    rows[row["id"]] = row
    except OSError:
        pass
    return rows


class Map:
    """The runs, several at once, each noted as soon as it has ended."""

    def __init__(self, out, jobs, keep):
        self.out, self.jobs, self.keep = out, jobs, keep
        self.store = os.path.join(out, "runs.jsonl")
        self.version = version()
        self.lock = threading.Lock()
        self.rows = {}

    def go(self, points, fresh, terminal=sys.stdout.isatty()):
        wanted = {identity(p): p for p in points}
        self.rows = {} if fresh else {k: r for k, r in kept(self.store, self.version).items() if k in wanted}
        waiting = [(k, p) for k, p in wanted.items() if k not in self.rows]
        if self.rows:
            print(f"{len(self.rows)} of {len(wanted)} runs are there already", flush=True)
        else:
            open(self.store, "w", encoding="utf-8").close()
        self.began, self.made, self.total = time.monotonic(), 0, len(waiting)
        self.told, self.terminal = self.began, terminal
        threads = [threading.Thread(target=self._work, args=(waiting,), daemon=True) for _ in range(self.jobs)]
        for t in threads:
            t.start()
        for t in threads:
            while t.is_alive():
                t.join(0.2)
        if self.terminal and self.total:
            print()
        return [self.rows[k] for k in wanted]

    def _work(self, waiting):
        while True:
            with self.lock:
                if not waiting:
                    return
                name, point = waiting.pop(0)
            began = time.monotonic()
            try:
                row = made(point, os.path.join(self.out, "runs", name), self.keep)
            except Exception as e:  # a run that breaks the driver has failed; the others go on
                row = {**point, "outcome": "failed", "reason": f"{type(e).__name__}: {e}"}
            row = {"id": name, **row, "wall_s": round(time.monotonic() - began, 3)}
            with self.lock:
                self.rows[name] = row
                self.made += 1
                with open(self.store, "a", encoding="utf-8") as f:
                    f.write(json.dumps({"version": self.version, **row}) + "\n")
                self._tell()

    def _tell(self):
        now = time.monotonic()
        if now - self.told < (0.5 if self.terminal else 15) and self.made < self.total:
            return
        self.told = now
        left = (now - self.began) / self.made * (self.total - self.made)
        count = Counter(r["outcome"] for r in self.rows.values())
        line = (f"run {self.made} of {self.total}, ETA {int(left) // 60}:{int(left) % 60:02d}  "
                + ", ".join(f"{count[o]} {o}" for o in OUTCOMES))
        print(("\r" + line) if self.terminal else line, end="" if self.terminal else "\n", flush=True)


def made(point, folder, keep):
    """Makes a run of either part; its row."""
    if "bed" not in point:
        return stress_run.one(point, folder, keep)
    row = stress_beds.one(point, folder)
    if not keep and row["outcome"] == "bounded":
        shutil.rmtree(folder, ignore_errors=True)
    return row


def chosen(part, count):
    """The points of a part, or of both."""
    free = stress_design.design(count) if part != "beds" else []
    beds = stress_beds.points() if part != "free" else []
    return free + (beds if count is None else beds[:count - len(free)] if free else beds[:count])


def kind(reason):
    """A reason without its numbers, to count it."""
    return re.sub(r"[-+]?\d[\d.]*(e[-+]?\d+)?", "#", reason)[:110]


def write(out, rows, target=None):
    keys = list(dict.fromkeys(k for r in rows for k in r))
    with open(os.path.join(out, "stress.csv"), "w", encoding="utf-8", newline="") as f:
        table = csv.DictWriter(f, keys, lineterminator="\n")
        table.writeheader()
        table.writerows({k: ("; ".join(map(str, v)) if isinstance(v, list) else v) for k, v in r.items()} for r in rows)
    for path in [os.path.join(out, "stress.json")] + ([target] if target else []):
        with open(path, "w", encoding="utf-8") as f:
            json.dump(rows, f, indent=1)
            f.write("\n")


def record(text, path=os.path.join(coupled.TOP, "validation", "STABILITY.md")):
    """Puts the report between the two marks of the page."""
    with open(path, encoding="utf-8") as f:
        page = f.read()
    start, end = "<!-- last map -->\n", "<!-- end of last map -->"
    head, tail = page.index(start) + len(start), page.index(end)
    with open(path, "w", encoding="utf-8") as f:
        f.write(page[:head] + "\n```\n" + text + "\n```\n\n" + page[tail:])


def main():
    args = parser().parse_args()
    if args.runs is not None and args.runs < 1:
        raise CaseError(f"--runs {args.runs}: must be at least 1")
    if args.jobs < 1:
        raise CaseError(f"--jobs {args.jobs}: must be at least 1")
    out = settings.path(args.out, "stress")
    os.makedirs(os.path.join(out, "runs"), exist_ok=True)
    points = chosen(args.part, args.runs)
    if args.only:
        known = {identity(p): p for p in chosen(None, None)}
        unknown = [k for k in args.only if k not in known]
        if unknown:
            raise CaseError(f"--only {unknown[0]}: no such run; the column id of stress.csv names them")
        for name in args.only:
            row = made(known[name], os.path.join(out, "runs", name), True)
            print(json.dumps({"id": name, **row}, indent=1))
        return 0
    if args.fresh:
        shutil.rmtree(os.path.join(out, "runs"), ignore_errors=True)
        os.makedirs(os.path.join(out, "runs"))
    began = time.monotonic()
    rows = Map(out, args.jobs, keep=False).go(points, args.fresh)
    write(out, rows, args.json)
    from validation.lib.stress import stress_picture
    free = [r for r in rows if "bed" not in r]
    if free:
        stress_picture.draw(os.path.join(out, "stress.png"), free)
    said = report(rows)
    print(said)
    if args.record:
        record(said)
    print(f"{time.monotonic() - began:.0f} s; results in {out}")
    return 1 if any(r["outcome"] == "failed" for r in rows) else 0


def report(rows):
    """Counts by outcome, reasons, and the warnings of accuracy."""
    count = Counter(r["outcome"] for r in rows)
    lines = [f"{len(rows)} runs: " + ", ".join(f"{count[o]} {o}" for o in OUTCOMES)]
    for outcome in OUTCOMES[1:]:
        for why, n in Counter(kind(r["reason"]) for r in rows if r["outcome"] == outcome).most_common():
            lines.append(f"  {outcome} {n:>4}  {why}")
    for why, n in Counter(kind(w) for r in rows for w in r.get("warnings", [])).most_common():
        lines.append(f"  warned  {n:>4}  {why}")
    return "\n".join(lines)


if __name__ == "__main__":
    run_program(main, "validation/stress")
