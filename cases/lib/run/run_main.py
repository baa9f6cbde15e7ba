# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/run: runs a coupled case from its one small folder."""

import argparse
import signal
import sys

from cases.lib.case import casefile, settings
from cases.lib.case.errors import CaseError
from cases.lib.case.program import guarded


def parser():
    p = argparse.ArgumentParser(
        prog="cases/run", description="Runs a coupled case; its results go to results/NAME.",
        epilog="cases/run NAME --keys lists a case's keys.", allow_abbrev=False)
    p.add_argument("name", nargs="?", metavar="NAME", help="the case")
    p.add_argument("--list", action="store_true", help="list the cases and stop")
    p.add_argument("--keys", action="store_true", help="list the case's keys and stop")
    p.add_argument("--dem", type=int, default=1, metavar="N", help="ranks of the DEM half (1)")
    p.add_argument("--cfd", type=int, default=1, metavar="M", help="ranks of the CFD half (1)")
    p.add_argument("--end", metavar="T", help="simulated time in s, short for --set end=T")
    p.add_argument("--out", metavar="DIR", help="the run folder (results/NAME)")
    p.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="change a value")
    p.add_argument("--dry-run", action="store_true",
                   help="make the run folder and print the commands that run the case")
    p.add_argument("--alone", action="store_true",
                   help="afterwards run the same DEM case without the fluid, to compare the times")
    p.add_argument("--no-pictures", action="store_true", help="draw nothing after the run")
    return p


def main():
    args = parser().parse_args()
    # the programs it starts end with it
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    if args.list:
        for name in casefile.names():
            print(f"{name:<16}{casefile.Case(name).title}")
        return 0
    if not args.name:
        raise CaseError("which case? cases/run --list names them")
    case = casefile.Case(args.name)
    changes = args.set + ([f"end={args.end}"] if args.end is not None else [])
    settings.apply(case, settings.read(changes), print)
    if args.keys:
        print(case.table())
        return 0
    for option, ranks in (("--dem", args.dem), ("--cfd", args.cfd)):
        if ranks < 1:
            raise CaseError(f"{option} {ranks}: must be at least 1")

    from cases.lib.run import launch, prepare  # which need more than Python's own modules
    derived = case.derive(args.dem, args.cfd)
    folder = prepare.run_folder(case, args.out, derived)
    run = launch.Run(folder, args.dem, args.cfd)
    run.write_script()
    if args.dry_run:
        print(run.script(), end="")
        return 0
    status = run.go()
    if status:
        return status
    from cases.lib.run import report
    return report.finish(case, run, derived, alone=args.alone, pictures=not args.no_pictures)


if __name__ == "__main__":
    sys.exit(guarded(main, "cases/run"))
