# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Two saved states compared: a particle's row by what each fix keeps of it."""

import struct

import numpy as np
import pytest

from cases.lib.run.saved_pairs import Pair
from validation.lib.checks import saved_states
from validation.lib.checks.verdicts import Broken

CORE = 18  # numbers that LIGGGHTS keeps itself


def row(*fixes, tag=5, x=0.25):
    """A particle's row: its length, what LIGGGHTS keeps, a block of each fix with its length ahead."""
    body = [x, 0.5, 0.75, struct.unpack("<d", struct.pack("<ii", tag, 0))[0]] + [0.125] * (CORE - 5)
    for values in fixes:
        body += [len(values) + 1, *values]
    return np.array([len(body) + 1, *body])


def test_blocks_in_any_order():
    one, other = row((1.5, 2.5), (0.5,), (9.5,) * 3), row((9.5,) * 3, (1.5, 2.5), (0.5,))
    assert one.tobytes() != other.tobytes()
    found = saved_states._blocks(one)
    assert found == saved_states._blocks(other)
    assert found[0] == one[:CORE].tobytes() and len(found) == 4
    assert sorted(map(len, found[1:])) == [16, 24, 32]


@pytest.mark.parametrize("other", [row((1.5, 2.5), (0.25,)), row((1.5, 2.5)), row((1.5, 0.5), (2.5,)),
                                   row((1.5, 2.5), (0.5,), x=0.375), row((1.5, 2.5), (0.5,), (0.5,))])
def test_blocks_that_differ(other):
    assert saved_states._blocks(row((1.5, 2.5), (0.5,))) != saved_states._blocks(other)


def test_a_row_without_blocks_is_compared_as_it_is():
    plain = row()
    assert saved_states._blocks(plain) == [plain.tobytes()]


def state(folder, rows, fields=(b"1",)):
    """A pair of one rank each, of these rows."""
    (folder / "dem").mkdir(parents=True)
    (folder / "cfd").mkdir()
    (folder / "dem" / "about").write_text("step 20\nranks 1\n")
    chunk = np.concatenate(rows).tobytes()
    (folder / "dem" / "state").write_bytes(b"head" * 5 + struct.pack("<i", len(chunk) // 8) + chunk)
    speeds = np.array([[0.5, 0.0, 0.25], [1.0, 0.0, 0.0]])
    head = b"internalField nonuniform List<vector> 2("
    (folder / "cfd" / "U").write_bytes(head + speeds.tobytes() + b");" + fields[0])
    return Pair(str(folder), 7, 20, 0.1, (str(folder / "cfd"),))


def test_differences(tmp_path):
    rows = [row((1.5, 2.5), (0.5,), tag=1), row((1.5, 2.5), (0.5,), tag=2)]
    one = state(tmp_path / "one", rows)
    same = state(tmp_path / "same", [rows[1], row((0.5,), (1.5, 2.5), tag=1)])
    assert sorted(saved_states.particles(one)) == [1, 2]
    assert saved_states.differences(one, same) == {"place": 0, "velocity": 0, "fluid": 0, "same": True}
    moved = state(tmp_path / "moved", [rows[0], row((1.5, 2.5), (0.5,), tag=2, x=0.375)])
    found = saved_states.differences(one, moved)
    assert found["place"] == 1 and not found["same"]  # by the radius, 0.125
    assert not saved_states.differences(one, state(tmp_path / "fluid", rows, (b"2",)))["same"]
    with pytest.raises(Broken, match="2 particles in .*one, 1 or others"):
        saved_states.differences(one, state(tmp_path / "fewer", rows[:1]))
