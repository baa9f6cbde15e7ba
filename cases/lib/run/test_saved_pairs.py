# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of saved states: the last whole one is taken, what is damaged is named."""

import json
import os
import zlib

import pytest

from cases.lib.case.errors import CaseError
from cases.lib.run import going_on, saved_pairs as pairs, series


def part(folder, number, step, **files):
    """One half's part of a pair, with its sums."""
    lines = [f"pair {number} step {step}"]
    for name, content in sorted(files.items()):
        path = folder / name.replace("__", "/")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content)
        lines.append(f"{zlib.crc32(content.encode()):08x} {len(content)} {name.replace('__', '/')}")
    (folder / "sums").write_text("\n".join(lines) + "\n")


def pair(top, step, number=77, ranks=1, cfd=None):
    folder = top / pairs.FOLDER / f"{step:09d}"
    part(folder / "dem", number, step, state="spheres", about="ranks 1\n")
    for rank in range(ranks):
        at = folder / "cfd" / f"processor{rank}" if ranks > 1 else folder / "cfd"
        part(at, cfd or number, step, U="fluid",
             uniform__couplingPair=f"pair {cfd or number};\nranks           {ranks};\ntime            {step * 1e-3};\n")
    return folder


def test_the_last_whole_one_is_taken(tmp_path):
    pair(tmp_path, 900)
    pair(tmp_path, 1000, ranks=2)
    (pair(tmp_path, 2000) / "dem" / "state").write_text("spherex")
    said = []
    found = pairs.latest(str(tmp_path), said.append)
    assert (found.step, found.time, found.number, len(found.cfd)) == (1000, 1.0, 77, 2)
    assert len(said) == 1 and "000002000/dem/state is not what was written" in said[0]


def test_a_run_that_was_ended_after_it_had_saved_its_end_goes_on_from_the_one_before(tmp_path):
    for step in (1000, 2000):
        pair(tmp_path, step)
    summary = tmp_path / "summary.json"
    for complete, steps, wanted in ((False, 2000, 1000), (False, 3000, 2000), (True, 3000, 2000)):
        summary.write_text(json.dumps({"complete": complete}))
        said = []
        assert going_on.chosen(str(tmp_path), steps, steps * 1e-3, said.append).step == wanted
        assert len(said) == (wanted == 1000) and all("after it had saved its end" in s for s in said)
    # there is nothing left of a complete one, and nobody asked to go back
    for complete, steps in ((True, 2000), (False, 1500)):
        summary.write_text(json.dumps({"complete": complete}))
        with pytest.raises(CaseError, match="is that of 2 s, the run's end .* there is nothing to go on with"):
            going_on.chosen(str(tmp_path), steps, steps * 1e-3, print)


@pytest.mark.parametrize("harm, words", [
    (lambda p: (p / "dem" / "state").unlink(), "dem/state is missing"),
    (lambda p: (p / "cfd" / "U").write_text("flui"), "cfd/U is not what was written"),
    (lambda p: (p / "cfd" / "sums").unlink(), "cfd/sums is missing"),
    (lambda p: (p / "dem" / "sums").write_text(""), "dem/sums is torn"),
    (lambda p: (p / "dem" / "sums").write_text("pair 77 step 100\n12 7"), "dem/sums is torn"),
    (lambda p: os.rename(p / "cfd", p / "fluid"), "cfd/sums is missing"),
])
def test_what_is_damaged_is_named(tmp_path, harm, words):
    folder = pair(tmp_path, 100)
    pairs.read(str(folder))
    harm(folder)
    with pytest.raises(CaseError, match=words):
        pairs.read(str(folder))


def test_parts_of_two_pairs_are_no_pair(tmp_path):
    with pytest.raises(CaseError, match="cfd is of pair 78, the DEM half's part of pair 77"):
        pairs.read(str(pair(tmp_path, 100, cfd=78)))


def test_a_rank_s_part_that_is_missing_is_found(tmp_path):
    folder = pair(tmp_path, 100, ranks=3)
    os.rename(folder / "cfd" / "processor2", folder / "else")
    with pytest.raises(CaseError, match="the parts of 2 ranks of 3"):
        pairs.read(str(folder))


def test_a_run_without_one_is_named(tmp_path):
    with pytest.raises(CaseError, match="holds no complete saved state"):
        pairs.latest(str(tmp_path))


def test_the_fluid_s_part_goes_to_its_time_folder(tmp_path):
    pairs.put(pairs.read(str(pair(tmp_path, 100, ranks=2))), str(tmp_path / "CFD"), "0.1")
    assert (tmp_path / "CFD" / "processor1" / "0.1" / "U").read_text() == "fluid"
    assert not (tmp_path / "CFD" / "processor1" / "0.1" / "sums").exists()


def test_what_came_after_it_is_cut_away(tmp_path):
    found = pairs.read(str(pair(tmp_path, 100)))
    (tmp_path / "DEM").mkdir()
    for step in (50, 100, 150):
        (tmp_path / "DEM" / f"spheres.{step:09d}.dump").write_text("")
    for time in ("0", "0.05", "0.1", "0.15"):
        (tmp_path / "CFD" / time).mkdir(parents=True)
    (tmp_path / "DEM" / "log").write_text("first")
    (tmp_path / "settling.csv").write_text("time_s,interface_m\n0,1\n0.05,2\n0.1,3\n0.15,4\n0.2,")
    functions = tmp_path / "CFD" / "postProcessing" / "inlet" / "0"
    functions.mkdir(parents=True)
    (functions / "p.dat").write_text("# Time p\n0.05 1\n0.1 2\n0.15 3\n0.2")
    (tmp_path / "checkpoints" / "000000150.part" / "dem").mkdir(parents=True)
    going_on.cut(str(tmp_path), found, 1e-3)
    assert os.listdir(tmp_path / "checkpoints") == ["000000100"]
    assert (tmp_path / "settling.csv").read_text() == "time_s,interface_m\n0,1\n0.05,2\n"
    assert sorted(p.name for p in (tmp_path / "CFD").iterdir()) == ["0", "0.05", "0.1", "postProcessing"]
    assert (functions / "p.dat").read_text() == "# Time p\n0.05 1\n0.1 2\n"
    (functions / "p_0.dat").write_text("# Time p\n0.15 4\n")
    series.join_functions(str(tmp_path / "CFD"))
    assert (functions / "p.dat").read_text() == "# Time p\n0.05 1\n0.1 2\n0.15 4\n"
    assert not (functions / "p_0.dat").exists()
    assert len(list((tmp_path / "DEM").glob("spheres.*.dump"))) == 2
    assert (tmp_path / "DEM" / "log.1").read_text() == "first"
