# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The reference tables of validation/data."""

from cases.lib.theory import tables


def table(name):
    """Columns of validation/data/NAME.csv by name: arrays, of numbers or of words."""
    return tables.read(name + ".csv")
