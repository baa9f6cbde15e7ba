# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of numbers, as laboratories and programs write them."""

import csv
import re

from cases.lib.case.errors import CaseError

_LIKE_NUMBER = re.compile(r"[+-]?\.?\d")


def rows(path, said=None):
    """(names or None, [(line, cells)]) of a CSV; # starts a comment. The first
    other line names the columns if no cell of it begins like a number. `said`
    is what messages call the file."""
    said = said or path
    try:
        with open(path, encoding="utf-8-sig", newline="") as f:
            table = csv.reader(line.partition("#")[0] for line in f)
            found = [(table.line_num, [c.strip() for c in row]) for row in table if any(c.strip() for c in row)]
    except (UnicodeDecodeError, csv.Error):
        raise CaseError(f"{said}: is not a CSV") from None
    if not found:
        raise CaseError(f"{said}: holds no rows")
    if any(_LIKE_NUMBER.match(c) for c in found[0][1]):
        return None, found
    return found[0][1], found[1:]
