# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""validation/matrix: rows of the matrix of parallel runs, by name or all."""

import argparse
import collections
import difflib
import sys
import time

from validation.lib.matrix import axes, matrix_run, pairs


def differing(row):
    """A row in words: what is not the first value of its axis, and the ranks."""
    return " ".join(f"{axis}={value}".replace(" ", "_") for axis, value in row.items()
                    if value != axes.AXES[axis][0] or axis in ("cfd", "dem"))


def _ranks(row):
    """Ranks of the two halves, DEM + CFD."""
    return f"{row['dem']}+{row['cfd']}"


def table(rows):
    """A table, as Markdown, of how many rows hold each value of each axis, in all and on which ranks;
    rows that must be refused are left out."""
    running = [row for row in rows.values() if axes.refusal(row) is None]
    ranks = sorted(set(map(_ranks, running)))
    lines = ["| setting | value | rows | " + " | ".join(ranks) + " |", "|" + "---|"*(3 + len(ranks))]
    for axis, values in axes.AXES.items():
        for value in values:
            held = collections.Counter(_ranks(row) for row in running if row[axis] == value)
            lines.append(f"| {axis} | {value} | {sum(held.values())} | "
                         + " | ".join(str(held[r]) for r in ranks) + " |")
    return lines


def counts(rows):
    """Lines that say how much the rows cover."""
    every = pairs.allowed_pairs(axes.AXES, axes.allowed)
    held = {p for row in rows.values() if axes.refusal(row) is None for p in pairs.pairs_of(row)}
    covered = sum(p in held for p in every)
    ranks = collections.Counter(map(_ranks, rows.values()))
    return [f"{len(rows)} rows, {len(axes.AXES)} axes, {covered} of {len(every)} pairs of values",
            "rows by ranks, DEM + CFD: " + ", ".join(f"{k}: {v}" for k, v in sorted(ranks.items()))]


def main():
    p = argparse.ArgumentParser(
        prog="validation/matrix", allow_abbrev=False,
        description="Short coupled runs on several ranks of each half against one rank of each.")
    p.add_argument("names", nargs="*", metavar="ROW", help="only these rows")
    p.add_argument("--list", action="store_true", help="list the rows and stop")
    p.add_argument("--counts", action="store_true", help="say how many rows hold each value, on which ranks, and stop")
    p.add_argument("--jobs", type=int, default=2, metavar="N", help="runs at a time (2)")
    args = p.parse_args()

    rows = matrix_run.rows()
    for name in args.names:
        if name not in rows:
            close = difflib.get_close_matches(name, rows, 1, 0.4)
            hint = f"; did you mean '{close[0]}'?" if close else ""
            print(f"validation/matrix: unknown row '{name}'{hint}", file=sys.stderr)
            return 2
    chosen = {name: rows[name] for name in args.names} or rows
    if args.list:
        for name, row in chosen.items():
            print(name, differing(row))
        print("\n".join(counts(chosen)))
        return 0
    if args.counts:
        print("\n".join(table(chosen) + counts(chosen)))
        return 0
    began = time.monotonic()
    passed = 0
    for name, row, (good, text) in matrix_run.Matrix(chosen, args.jobs).run():
        print(f"{'pass' if good else 'FAIL'} {name} {text}" + ("" if good else f"\n     {differing(row)}"), flush=True)
        passed += good
    print("\n".join(counts(chosen)))
    print(f"{passed} passed, {len(chosen) - passed} failed, {time.monotonic() - began:.0f} s")
    return 0 if passed == len(chosen) else 1


if __name__ == "__main__":
    sys.exit(main())
