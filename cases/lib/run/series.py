# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Time series of a run that was made in parts, put together again."""

import glob
import os

from cases.lib.case import files


def rows_until(lines, time, between):
    """The lines of a table whose first number is at most that time, whole ones only; what is no row stays."""
    kept = []
    for line in lines:
        try:
            row = float(line.split(between)[0])
        except ValueError:
            kept.append(line)
            continue
        if line.endswith("\n") and row <= time:
            kept.append(line)
    return kept


def cut_curve(path, time):
    """Takes away the rows of settling.csv after that time [s], and what is torn."""
    with open(path, encoding="utf-8", errors="replace") as f:
        lines = f.readlines()
    with files.writing(path) as f:
        f.writelines(lines[:1] + rows_until(lines[1:], time, ","))


def join_functions(cfd, time=float("inf")):
    """Puts the files of function objects together: OpenFOAM gives those of a run that goes on another name, X_0.dat
    beside X.dat. Rows after that time [s] are taken away."""
    for path in glob.glob(os.path.join(glob.escape(cfd), "postProcessing", "*", "*", "*.dat")):
        stem, start = path[:-4], os.path.basename(os.path.dirname(path))
        more = f"{stem}_{start}.dat"
        if stem.endswith("_" + start):
            continue
        with open(path, encoding="utf-8") as f:
            lines = f.readlines()
        if os.path.isfile(more):
            with open(more, encoding="utf-8") as f:
                lines += [x for x in f if not x.startswith("#")]
        with files.writing(path) as f:
            f.writelines(rows_until(lines, time, None))
        if os.path.isfile(more):
            os.remove(more)
