# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""validation/run: runs the checks of validation/ROOM/NAME/check.py."""

import argparse
import os
import sys
import time

from cases.lib.case import program
from cases.lib.case.errors import nearest
from validation.lib.checks import results_page, rooms, verdicts
from validation.lib.checks.coupled import RUNS


class _Unreadable(Exception):
    """A check whose file cannot be read as one."""


def headline(name):
    """(title, whether it is long) of a check, and what is wrong with its file or None."""
    try:
        return *rooms.headline(name), None
    except (OSError, SyntaxError, KeyError) as e:
        return "cannot be loaded", False, _Unreadable(f"check.py of {name}: {type(e).__name__}: {e}")


def main():
    p = argparse.ArgumentParser(prog="validation/run", allow_abbrev=False,
                                description="Checks the project: unit tests, then coupled runs.")
    p.add_argument("names", nargs="*", metavar="NAME", help="only these checks")
    p.add_argument("--list", action="store_true", help="list the checks and stop")
    p.add_argument("--all", action="store_true", help="the long checks, too")
    p.add_argument("--part", action="append", default=[], metavar="PART",
                   help="of a check that has parts (faults), only this one; its README names them, and tells of shares")
    p.add_argument("--record", action="store_true",
                   help="write each case's table into its README.md, and the page validation/RESULTS.md")
    p.add_argument("--json", metavar="FILE", help="write the results as JSON, too")
    args = p.parse_args()

    known = rooms.holding("check.py")
    for name in args.names:
        if name not in known:
            print(f"validation/run: {nearest(name, known, 'check')}", file=sys.stderr)
            return 2
    heads = {name: headline(name) for name in args.names or known}
    if args.list:
        rows = sorted((os.path.basename(os.path.dirname(known[name])), name, *head) for name, head in heads.items())
        for room, name, title, long, _ in rows:
            print(f"{room:<13}{name:<22}{'(long) ' if long else ''}{title}")
        return 0

    os.makedirs(RUNS, exist_ok=True)
    rows, results = [], []
    # the unit tests first: when they fail, so will the rest
    for name in sorted(heads, key=lambda n: ("unit" not in n, n)):
        title, long, wrong = heads[name]
        if long and not (args.all or args.names):
            continue
        print(f"-- {name}: {title}", flush=True)
        checks = verdicts.Checks(name, lambda row: print(verdicts.line(row), flush=True), args.part, args.all)
        began = time.monotonic()
        try:
            if wrong:
                raise wrong
            module = rooms.load(name)
            for part in args.part:
                if part.partition(":")[0] not in getattr(module, "PARTS", ()):
                    raise ValueError(f"--part {part}: {nearest(part, getattr(module, 'PARTS', ('none',)), 'part')}")
            module.run(checks)
        except (Exception, SystemExit) as e:  # whatever it is, the other checks go on
            checks.true("came to its end", False, " ".join(f"{type(e).__name__}: {e}".split()))
        seconds = time.monotonic() - began
        print(f"   {seconds:.1f} s", flush=True)
        rows += checks.rows
        results.append(results_page.Result(title, checks, seconds))

    verdicts.write_csv(os.path.join(RUNS, "validation.csv"), rows)
    if args.json:
        verdicts.write_json(args.json, rows)
    told = results_page.write(RUNS, results, keep=bool(args.names))
    if args.record:
        results_page.record(RUNS, list(heads), rooms.HERE, rooms.holding("README.md"))
    print(f"page of results: {os.path.relpath(told)}")
    failed = verdicts.failed(rows)
    if failed:
        print("failed:")
        for row in failed:
            print(verdicts.line(row))
    print(verdicts.count(rows))
    return 1 if failed or not rows else 0


if __name__ == "__main__":
    program.run(main, "validation/run")
