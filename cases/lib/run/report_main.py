# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/report: pictures, time series and summary of a run, finished or not."""

import argparse
import os

from cases.lib.case import casefile, files, program
from cases.lib.case.errors import CaseError
from cases.lib.case.places import called


def parser():
    p = argparse.ArgumentParser(
        prog=called("report"), allow_abbrev=False,
        description="Makes the pictures, the files for ParaView and the summary of a run, also of one that was "
                    "stopped or was run by hand. Exit code 0: they are made.")
    p.add_argument("folder", metavar="DIR", help="the run's folder")
    p.add_argument("--no-pictures", action="store_true", help="draw nothing")
    return p


def case_of(folder):
    """The case a folder was made for, with its values and its ranks."""
    from cases.lib.run import folders
    mark = folders.read_mark(folder)
    if mark is None:
        raise CaseError(f"{folder}: is no run's folder; it lacks {folders.MARK}")
    case = casefile.Case(folders.of(mark))
    lacking = sorted(set(case.values) - set(mark["values"]))
    if lacking:
        raise CaseError(f"{folder}: was made by another version of this project; it says nothing of {lacking[0]}")
    case.values = {key: mark["values"][key] for key in case.values}
    return case, mark["ranks"]


def main():
    args = parser().parse_args()
    folder = os.path.abspath(args.folder)
    case, (dem, cfd) = case_of(folder)
    from cases.lib.run import folders, launch, report, state
    try:
        lock = files.Lock(os.path.join(folder, folders.LOCK))
    except files.Taken:
        raise CaseError(f"{folder}: the run is under way") from None
    program.result(os.path.join(folder, "summary.json"))
    with lock:
        run = launch.Run(folder, dem, cfd)
        before = folders.summary(folder)
        run.wall = before.get("wall_s") or 0.0
        lacking = state.lacking(folder, case.values)
        if lacking and before.get("reason") not in (None, state.UNDER_WAY):
            lacking = before["reason"]
        if not lacking and before.get("complete") is False and before.get("reason") != state.UNDER_WAY:
            lacking = before["reason"]  # a half ended with an error at the very end
        report.finish(case, run, case.derive(dem, cfd), pictures=not args.no_pictures, lacking=lacking)
    return 0


if __name__ == "__main__":
    program.run(main, called("report"))
