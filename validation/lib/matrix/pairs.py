# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Rows that bring every pair of values of any two axes together.

The rows are made one after another, each with as many pairs that are still
missing as a greedy search finds; nothing is drawn at random, so that the same
axes give the same rows. What cannot stand together is left out of every row.
"""

import itertools
import zlib


def allowed_pairs(axes, allowed):
    """The pairs ((axis, value), (axis, value)) that some whole row can hold."""
    found = []
    for one, two in itertools.combinations(axes, 2):
        for a, b in itertools.product(axes[one], axes[two]):
            if completed({one: a, two: b}, axes, allowed) is not None:
                found.append(((one, a), (two, b)))
    return found


def completed(part, axes, allowed, wanted=None, turn=0):
    """A whole row with these values, or None; of the values that are left the
    search tries those first that bring the most pairs of wanted, of those that
    bring as many another one first in each turn."""
    wanted = wanted or {}
    if not allowed(part):
        return None
    missing = [axis for axis in axes if axis not in part]
    if not missing:
        return dict(part)
    # the axis on which most depends comes first
    axis = max(missing, key=lambda x: (len(axes[x]), -missing.index(x)))

    def gain(value):
        partners = wanted.get((axis, value), {})
        return sum(v in partners.get(k, ()) for k, v in part.items()), sum(map(len, partners.values()))
    first = zlib.crc32(f"{axis} {turn}".encode()) % len(axes[axis])
    for value in sorted(axes[axis][first:] + axes[axis][:first], key=gain, reverse=True):
        row = completed({**part, axis: value}, axes, allowed, wanted, turn)
        if row is not None:
            return row
    return None


def pairs_of(row):
    """The pairs a row holds, as allowed_pairs() writes them; the row's order is that of the axes."""
    return list(itertools.combinations(row.items(), 2))


def all_pairs(axes, allowed, first=()):
    """Rows of {axis: value}; those of first come first, as they stand.

    axes: {axis: its values}; allowed(part): whether values of some axes can
    stand together, of a part of a row as well as of a whole one."""
    left = dict.fromkeys(allowed_pairs(axes, allowed))
    rows = []

    def take(row):
        row = {axis: row[axis] for axis in axes}
        rows.append(row)
        for pair in pairs_of(row):
            left.pop(pair, None)

    for row in first:
        take(row)
    while left:
        wanted = {}
        for (one, a), (two, b) in left:
            wanted.setdefault((one, a), {}).setdefault(two, set()).add(b)
            wanted.setdefault((two, b), {}).setdefault(one, set()).add(a)
        (one, a), (two, b) = max(left, key=lambda pair: sum(
            len(v) for end in pair for v in wanted[end].values()))
        take(completed({one: a, two: b}, axes, allowed, wanted, len(rows)))
    return rows
