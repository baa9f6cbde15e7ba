# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Every pair of models, settings and ranks gives what one rank of each half gives."""

from validation.lib.matrix import axes, matrix_main, matrix_run, pairs

TITLE = "every pair of settings on several ranks against one"


def run(checks):
    rows = matrix_run.rows()
    every = pairs.allowed_pairs(axes.AXES, axes.allowed)
    held = {p for row in rows.values() if axes.refusal(row) is None for p in pairs.pairs_of(row)}
    checks.equal("pairs of values in some row", sum(p in held for p in every), len(every))
    lacking = matrix_run.without_a_row(matrix_run.known())
    checks.true("what the CFD half registers is in the matrix", not lacking, "; ".join(lacking))
    passed = 0
    for name, row, (good, text) in matrix_run.Matrix(rows, 2).run():
        how = f"{text}; {matrix_main.differing(row)}; alone: validation/matrix {name}"
        checks.true(name, good, text if good else how)
        passed += good
    checks.equal("rows passed", passed, len(rows))
    checks.note("; ".join(matrix_main.counts(rows)) + ". Rows that hold each value, by ranks, DEM + CFD:")
    checks.note("\n".join(matrix_main.table(rows)))
