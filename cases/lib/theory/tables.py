# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The reference tables in validation/data, one csv each, as columns."""

import csv
import pathlib

import numpy as np

FOLDER = pathlib.Path(__file__).parents[3] / "validation" / "data"


def read(name, folder=FOLDER):
    """{column: array of shape (rows,)} of a csv whose `#` lines are comments
    and whose first other line names the columns. A column of numbers is
    float, any other str. ValueError when a row has another length."""
    with open(pathlib.Path(folder) / name, newline="") as file:
        rows = list(csv.reader(line for line in file
                               if line.strip() and not line.startswith("#")))
    for row in rows[1:]:
        if len(row) != len(rows[0]):
            raise ValueError(f"{name}: {row} should have {len(rows[0])} "
                             "columns")
    columns = {}
    for head, values in zip(rows[0], zip(*rows[1:])):
        try:
            columns[head] = np.array([float(value) for value in values])
        except ValueError:
            columns[head] = np.array(values)
    return columns
