# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""validation/run: runs the checks of validation/ROOM/NAME/check.py."""

import argparse
import difflib
import os
import sys
import time

from validation.lib.checks import results_page, rooms, verdicts
from validation.lib.checks.coupled import RUNS


class _Unreadable:
    """Stands in for a check that cannot be loaded: running it says why."""

    def __init__(self, error):
        self.error = error
        self.TITLE = "cannot be loaded"

    def run(self, _):
        raise self.error


def main():
    p = argparse.ArgumentParser(prog="validation/run", allow_abbrev=False,
                                description="Checks the project: unit tests, then coupled runs.")
    p.add_argument("names", nargs="*", metavar="NAME", help="only these checks")
    p.add_argument("--list", action="store_true", help="list the checks and stop")
    p.add_argument("--all", action="store_true", help="the long checks, too")
    p.add_argument("--record", action="store_true",
                   help="write each case's table into its README.md, and the page validation/RESULTS.md")
    p.add_argument("--json", metavar="FILE", help="write the results as JSON, too")
    args = p.parse_args()

    known = list(rooms.holding("check.py"))
    modules = {}
    for name in args.names or known:
        if name not in known:
            close = difflib.get_close_matches(name, known, 1, 0.4)
            hint = f"did you mean '{close[0]}'?" if close else "known are " + ", ".join(known)
            print(f"validation/run: unknown check '{name}'; {hint}", file=sys.stderr)
            return 2
        try:
            modules[name] = rooms.load(name)
        except (Exception, SystemExit) as e:  # a broken check fails; the others go on
            modules[name] = _Unreadable(e)
    if args.list:
        for name, module in modules.items():
            print(f"{name:<22}{'(long) ' if getattr(module, 'LONG', False) else ''}{module.TITLE}")
        return 0

    os.makedirs(RUNS, exist_ok=True)
    rows, results = [], []
    # the unit tests first: when they fail, so will the rest
    for name in sorted(modules, key=lambda n: ("unit" not in n, n)):
        module = modules[name]
        if getattr(module, "LONG", False) and not (args.all or args.names):
            continue
        print(f"-- {name}: {module.TITLE}", flush=True)
        checks = verdicts.Checks(name, lambda row: print(verdicts.line(row), flush=True))
        began = time.monotonic()
        try:
            module.run(checks)
        except (Exception, SystemExit) as e:  # whatever it is, the other checks go on
            checks.true("came to its end", False, " ".join(f"{type(e).__name__}: {e}".split()))
        seconds = time.monotonic() - began
        print(f"   {seconds:.1f} s", flush=True)
        rows += checks.rows
        results.append(results_page.Result(module.TITLE, checks, seconds))

    verdicts.write_csv(os.path.join(RUNS, "validation.csv"), rows)
    if args.json:
        verdicts.write_json(args.json, rows)
    told = results_page.write(RUNS, results, keep=bool(args.names))
    if args.record:
        results_page.record(RUNS, list(modules), rooms.HERE, rooms.holding("README.md"))
    print(f"page of results: {os.path.relpath(told)}")
    failed = [r for r in rows if r["verdict"] != "pass"]
    if failed:
        print("failed:")
        for row in failed:
            print(verdicts.line(row))
    print(f"{len(rows) - len(failed)} passed, {len(failed)} failed")
    return 1 if failed or not rows else 0


if __name__ == "__main__":
    sys.exit(main())
