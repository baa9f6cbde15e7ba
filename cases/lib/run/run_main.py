# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/run: runs a coupled case from its one small folder."""

import argparse
import os
import sys

from cases.lib.case import casefile, program, settings, stops
from cases.lib.case.errors import CaseError
from cases.lib.case.places import called


def parser():
    p = argparse.ArgumentParser(
        prog=called("run"), allow_abbrev=False, description="Runs a coupled case; its results go to results/NAME.",
        epilog=f"{called('run')} NAME --keys lists a case's keys. Exit codes: 0 a complete run, 1 it failed, "
               "2 bad input, 3 particles were lost, 4 complete but for its report, 128 + N ended by signal N.")
    p.add_argument("name", nargs="?", metavar="NAME", help="the case, or the path of a case's folder")
    p.add_argument("--list", action="store_true", help="list the cases and stop")
    p.add_argument("--keys", action="store_true", help="list the case's keys and stop")
    # cmake/start.sh takes it
    p.add_argument("--yes", action="store_true", help="install missing packages with sudo without asking")
    p.add_argument("--dem", type=int, metavar="N", help="ranks of the DEM half (1, or as before)")
    p.add_argument("--cfd", type=int, metavar="M", help="ranks of the CFD half (1, or as before)")
    p.add_argument("--end", metavar="T", help="simulated time in s, short for --set end=T")
    p.add_argument("--out", metavar="DIR", help="the run folder (results/NAME)")
    p.add_argument("--overwrite", action="store_true", help="delete what an older run left in that folder")
    p.add_argument("--oversize", action="store_true",
                   help="run it even if it needs more memory or cores than this machine has")
    p.add_argument("--continue", action="store_true", dest="go_on",
                   help="go on with the run in that folder, from its last saved state, to its end or to --end")
    p.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="change a value")
    p.add_argument("--dry-run", action="store_true",
                   help="make the run folder and print the commands that run the case")
    p.add_argument("--alone", action="store_true",
                   help="afterwards run the same DEM case without the fluid, to compare the times")
    p.add_argument("--no-pictures", action="store_true", help="draw nothing after the run")
    return p


def listed():
    """The cases there are, a line each; of those that cannot be read, why."""
    for name in casefile.names():
        try:
            yield f"{name:<16}{casefile.Case(name).title}"
        except CaseError as e:
            yield f"{name:<16}cannot be read: {e}"


def main():
    args = parser().parse_args()
    if args.list:
        for line in listed():
            print(line)
        program.result(casefile.names())
        return 0
    if not args.name:
        raise CaseError(f"which case? {called('run')} --list names them")
    case = casefile.Case(args.name)
    changes = args.set + ([f"end={args.end}"] if args.end is not None else [])
    settings.apply(case, settings.read(changes), print)
    if args.keys:
        print(case.table())
        program.result({key: {**entry, "value": case.values[key]} for key, entry in case.parameters.items()})
        return 0
    for option, ranks in (("--dem", args.dem), ("--cfd", args.cfd)):
        if ranks is not None and ranks < 1:
            raise CaseError(f"{option} {ranks}: must be at least 1")
    if args.go_on:
        return go_on(args)
    derived = case.derive(args.dem or 1, args.cfd or 1)

    from cases.lib.run import folders, launch, plan, prepare  # which need more than Python's own modules
    foreseen = plan.foresee({**case.values, **derived})
    if not args.oversize:
        # a folder may be made ready for another machine
        plan.check(foreseen, derived, 10**9 if args.dry_run else launch.cores(), plan.machine_memory())
    from cases.lib.theory import attraction, screening, similarity
    values = {**case.values, **derived}
    print("\n".join(filter(None, (foreseen.line(), screening.line(values), attraction.line(values)))), flush=True)
    if case.values.get("regime") == "stokes":
        print(similarity.table(similarity.groups({**case.values, **derived})), flush=True)
    folder, lock = folders.claim(case, args.out, args.overwrite, args.dry_run)
    with lock:
        prepare.fill(folder, case, derived)
        for warning in screening.of_scripts({**case.values, **derived}, prepare.scripts(folder)):
            print(f"{called('run')}: {warning}", flush=True)
        run = launch.Run(folder, derived["dem_ranks"], derived["cfd_ranks"])
        run.write_script()
        if args.dry_run:
            print(run.script(), end="")
            return 0
        return go(case, run, derived, lock, args)


def go_on(args):
    """Goes on with a run from its last saved state; gives the exit code."""
    if args.set or args.overwrite or args.dry_run:
        raise CaseError("--continue goes on with the run as it is: only --end, --dem, --cfd go with it")
    from cases.lib.run import folders, going_on, launch
    folder, lock = folders.claim_again(casefile.Case(args.name), args.out)
    with lock:
        case, ranks = folders.case_of(folder)
        if args.end is not None:
            settings.apply(case, settings.read([f"end={args.end}"]), print)
        derived = case.derive(args.dem or ranks[0], args.cfd or ranks[1])
        pair = going_on.set_up(folder, case, derived)
        run = launch.Run(folder, derived["dem_ranks"], derived["cfd_ranks"])
        run.restart = os.path.relpath(pair.dem, folder)
        run.write_script()
        print(f"{called('run')}: goes on from {pair.time:.6g} s of {case.values['end']:.6g} s, "
              f"the state in {os.path.relpath(pair.folder, folder)}", flush=True)
        return go(case, run, derived, lock, args)


def _further(folder, case, derived):
    """From where and how a run that was ended would go on, empty where it cannot."""
    from cases.lib.run import folders, going_on
    more = folders.offer(folder, case)
    if not more:
        return ""
    try:
        last = going_on.chosen(folder, derived["steps"], case.values["end"], lambda _: None)
    except CaseError as e:
        return f"; {e}"
    return f"; it would go on from the state of {last.time:.6g} s by {more}"


def go(case, run, derived, lock, args):
    """Runs a prepared case, says how it ended, and reports it; gives the exit code."""
    from cases.lib.run import state
    end = case.values["end"]
    program.result(os.path.join(run.folder, "summary.json"))
    state.write(run.folder, case.name, end, state.UNDER_WAY)
    try:
        outcome = run.go(lock)
    except BaseException as e:
        with stops.passed_over():
            state.write(run.folder, case.name, end, str(e) or type(e).__name__)
        raise
    code, reason = outcome.code, outcome.reason
    if not code:
        reason = state.lacking(run.folder, case.values)
        code = 1 if reason else 0
    if code:
        with stops.passed_over():
            s = state.write(run.folder, case.name, end, reason, run.wall)
            further = _further(run.folder, case, derived)
            print(f"{called('run')}: stopped after {run.wall:.1f} s at {s['simulated_s']:.4g} s of {end:.4g} s; "
                  f"logs in {run.folder}/DEM/log and CFD/log; "
                  f"{called('report')} draws what there is{further}\n{reason}",
                  file=sys.stderr)
        return code
    from cases.lib.run import report
    return report.finish(case, run, derived, alone=args.alone, pictures=not args.no_pictures)


if __name__ == "__main__":
    program.run(main, called("run"))
