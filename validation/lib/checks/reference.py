# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The reference tables of validation/data."""

import os
import sys

from coupled import TOP

sys.path.insert(0, os.path.join(TOP, "validation"))

from theory import tables  # noqa: E402


def table(name):
    """Columns of validation/data/NAME.csv by name: arrays, of numbers or of words."""
    return tables.read(name + ".csv")
