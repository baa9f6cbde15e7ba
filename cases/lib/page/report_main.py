# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/report: pictures, time series, summary and page of a run, finished or not."""

import argparse
import os

from cases.lib.case import files, program
from cases.lib.case.errors import CaseError
from cases.lib.case.places import called


def parser():
    p = argparse.ArgumentParser(
        prog=called("report"), allow_abbrev=False,
        description="Makes the pictures, the files for ParaView, the summary and report.html, a page that needs no "
                    "other file, of a run, also of one that was stopped or was run by hand. Exit code 0: they are "
                    "made.")
    p.add_argument("folder", metavar="DIR", help="the run's folder")
    p.add_argument("--no-pictures", action="store_true", help="draw nothing, and make no page")
    return p


def main():
    args = parser().parse_args()
    folder = os.path.abspath(args.folder)
    from cases.lib.run import folders, launch, report, state
    case, (dem, cfd) = folders.case_of(folder)
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
        derived = case.derive(dem, cfd)
        report.finish(case, run, derived, pictures=not args.no_pictures, lacking=lacking)
        if not args.no_pictures:
            from cases.lib.page import page
            shown = page.write(folder, case, derived, folders.summary(folder))
            print(f"the page of the run: {os.path.relpath(shown)}")
    return 0


if __name__ == "__main__":
    program.run(main, called("report"))
