# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The generator of rows, and the tables it works on."""

import itertools

import numpy as np
import pytest

from validation.lib.matrix import answers, axes, matrix_main, matrix_run, pairs, scene

SMALL = {"a": (1, 2, 3), "b": ("x", "y"), "c": (True, False), "d": (0, 1)}


def apart_from(row):
    """a = 1 never with b = x; c never with d."""
    return not (row.get("a") == 1 and row.get("b") == "x") and not (row.get("c") is True and row.get("d") == 1)


def missing(rows, table, allowed):
    """Pairs that may stand in a row and stand in none, found without the generator."""
    some = [dict(zip(table, values)) for values in itertools.product(*table.values())]
    some = [row for row in some if allowed(row)]
    possible = {p for row in some for p in itertools.combinations(row.items(), 2)}
    return possible - {p for row in rows for p in itertools.combinations(row.items(), 2)}


@pytest.mark.parametrize("allowed", [lambda row: True, apart_from])
def test_every_pair_is_in_a_row_and_no_row_is_excluded(allowed):
    rows = pairs.all_pairs(SMALL, allowed)
    assert not missing(rows, SMALL, allowed)
    assert all(list(row) == list(SMALL) and allowed(row) for row in rows)
    assert len(rows) < 12  # of 24


def test_a_pair_that_needs_a_third_value_is_seen():
    """a = 1 and b = 1 stand together only where c is 2, whichever is tried first."""
    table = {"a": (0, 1), "b": (0, 1), "c": (0, 1, 2)}

    def allowed(row):
        return not (row.get("a") == 1 and row.get("b") == 1 and row.get("c") in (0, 1))
    rows = pairs.all_pairs(table, allowed)
    assert not missing(rows, table, allowed)
    assert {"a": 1, "b": 1, "c": 2} in rows
    for turn in range(9):
        assert pairs.completed({"a": 1, "b": 1}, table, allowed, turn=turn) == {"a": 1, "b": 1, "c": 2}


def test_the_same_rows_each_time():
    assert pairs.all_pairs(SMALL, apart_from) == pairs.all_pairs(SMALL, apart_from)


@pytest.fixture(scope="module")
def rows():
    return matrix_run.rows()


def test_the_matrix_has_every_pair(rows):
    every = pairs.allowed_pairs(axes.AXES, axes.allowed)
    running = [row for row in rows.values() if axes.refusal(row) is None]
    assert set(every) <= {p for row in running for p in pairs.pairs_of(row)}
    # each value of each axis is in some row: nothing is excluded as a whole
    for axis, values in axes.AXES.items():
        assert {row[axis] for row in running} == set(values)


def test_the_table_counts_each_value_on_each_ranks(rows):
    """Each row has one value of an axis: an axis' numbers add up to all rows that run, those of a line to its sum."""
    running = [row for row in rows.values() if axes.refusal(row) is None]
    heads, _, *lines = [[x.strip() for x in line.strip("|").split("|")] for line in matrix_main.table(rows)]
    assert [tuple(x[:2]) for x in lines] == [(k, str(v)) for k, values in axes.AXES.items() for v in values]
    for axis in axes.AXES:
        assert sum(int(x[2]) for x in lines if x[0] == axis) == len(running) < len(rows)
    for line in lines:
        assert int(line[2]) == sum(map(int, line[3:])) > 0
    at = heads.index("2+4")
    one = next(x for x in lines if x[:2] == ["mesh", "skew"])
    assert int(one[at]) == sum(r["mesh"] == "skew" and r["dem"] == 2 and r["cfd"] == 4 for r in running) > 0
    assert [x[at] for x in lines if x[0] == "cfd" and x[1] != "4"] == ["0", "0"]


def test_no_row_is_its_own_reference(rows):
    assert all(row["cfd"]*row["dem"] > 1 for row in rows.values())
    assert axes.refused_rows() and all(axes.refusal(row) for row in axes.refused_rows())


def test_a_reference_is_the_row_on_one_rank_of_each(rows):
    for row in rows.values():
        one = axes.reference_of(row)
        assert one["cfd"] == one["dem"] == 1
        assert {k for k in row if row[k] != one[k]} <= {"cfd", "dem", "cut", "demCut", "sides"}
        assert (one["sides"] == "wall") == (row["sides"] == "wall")


def test_a_model_without_a_row_is_told():
    names = {entry: [v for v in axes.AXES[axis] if axis != "force" or v not in axes.NOT_A_FORCE]
             for axis, entry in axes.MODELS.items()}
    assert not matrix_run.without_a_row(names)
    names["forceModels"] = names["forceModels"] + ["basset"]
    names["dragModel"] = [n for n in names["dragModel"] if n != "Stokes"]
    told = matrix_run.without_a_row(names)
    assert len(told) == 2
    assert "dragModel Stokes" in told[0] and "forceModels basset has no row" in told[1]


@pytest.mark.parametrize("cut, start, end", [("spread", {0, 1}, {0, 1}), ("empty", {0}, {0}),
                                             ("emptying", {0, 1}, {0}), ("filling", {1}, {0, 1})])
def test_the_cuts_do_what_they_are_called(cut, start, end):
    """Ranks that hold centres at the start and 1.2 mm lower; a run looks where its own spheres are."""
    row = {**{k: v[0] for k, v in axes.AXES.items()}, "cut": cut, "cfd": 2}
    ranks = scene.rank_of_cell(row)
    # the rank of its own is the lower one for filling alone
    if cut == "filling":
        ranks = [1 - r for r in ranks]

    def held(fall):
        found = set()
        for _, (x, y, z), _ in scene.grains(row):
            i, j, k = (int(v/scene.SIDE) for v in (x, y, z - fall))
            found.add(ranks[i + 4*j + 16*k])
        return found
    assert held(0.0) == start and held(1.2e-3) == end


@pytest.mark.parametrize("bodies", axes.AXES["bodies"])
def test_no_two_grains_touch(bodies):
    row = {**{k: v[0] for k, v in axes.AXES.items()}, "bodies": bodies}
    reach = {"grain": 0.4e-3, "rod": 0.51e-3, "knot": 0.6e-3}
    for (a, x, _), (b, y, _) in itertools.combinations(scene.grains(row), 2):
        assert np.linalg.norm(np.subtract(x, y)) > reach[a] + reach[b]


def test_differences_are_of_the_largest_value_and_go_round_the_period():
    one = {"position": np.array([[7.999e-3, 0, 0.02]]), "U": np.array([[1.0, 0, 0], [0, 2.0, 0]])}
    other = {"position": np.array([[-1e-6, 0, 0.02]]), "U": np.array([[1.0, 0, 0], [0, 2.0 + 4e-9, 0]])}
    far = answers.apart(one, other)
    assert far["U"] == pytest.approx(2e-9, rel=1e-6)
    assert far["position"] < 1e-13
    other["U"][0, 0] = np.nan
    assert answers.apart(one, other)["U"] == float("inf")
    assert answers.apart({"p": np.zeros((2, 1))}, {"p": np.full((2, 1), 1e-30)})["p"] == float("inf")
