# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Run folders: what is kept, moved aside, refused; the state of a run in them."""

import json
import os

import pytest

from cases.lib.case import places
from cases.lib.case.casefile import Case
from cases.lib.case.errors import CaseError
from cases.lib.run import folders, state


@pytest.fixture
def case():
    return Case("clump-half")


@pytest.fixture
def top(tmp_path, monkeypatch):
    """A project folder of the test's own, for results/NAME."""
    for module in (folders, places):
        monkeypatch.setattr(module, "TOP", str(tmp_path))
    return tmp_path


def take(case, *args, **more):
    """Claims a folder, marks it, lets it go."""
    place, lock = folders.claim(case, *args, tell=lambda _: None, **more)
    folders.write_mark(place, case, (1, 1))
    lock.close()
    return place


def results(place, complete, simulated=0.117):
    """What a run leaves behind."""
    os.makedirs(os.path.join(place, "DEM"), exist_ok=True)
    for name in ("settling.csv", "DEM/log", "a.png"):
        with open(os.path.join(place, name), "w", encoding="utf-8") as f:
            f.write("time_s\n0\n0.117\n")
    with open(os.path.join(place, "summary.json"), "w", encoding="utf-8") as f:
        json.dump({"complete": complete, "simulated_s": simulated, "end": 0.5}, f)


@pytest.mark.parametrize("complete", [True, False])
def test_the_plain_command_again_moves_aside(top, case, complete):
    said = []
    for number in range(3):
        place, lock = folders.claim(case, None, tell=said.append)
        folders.write_mark(place, case, (1, 1))
        lock.close()
        assert sorted(os.listdir(place)) == [".lock", "case.json", "case.txt"]
        with open(os.path.join(place, "which"), "w", encoding="utf-8") as f:
            f.write(str(number))
        results(place, complete)
    assert place == str(top / "results" / "clump-half")
    assert [(top / "results" / f"clump-half.{n}" / "which").read_text() for n in (1, 2)] == ["0", "1"]
    assert (top / "results" / "clump-half.1" / "DEM" / "log").exists()
    what = "a finished run" if complete else "an unfinished run, 0.117 s of 0.5 s"
    assert said == [f"results/clump-half held {what}: it is results/clump-half.{n} now" for n in (1, 2)]


@pytest.mark.parametrize("complete, what", [(True, "a finished run"), (False, "an unfinished run, 0.117 s of 0.5 s")])
def test_a_run_in_out_is_refused(tmp_path, case, complete, what):
    place = take(case, str(tmp_path / "run"))
    results(place, complete)
    with pytest.raises(CaseError, match=f"--out {place}: holds {what}; name another folder, or give --overwrite"):
        folders.claim(case, place)
    assert os.path.exists(os.path.join(place, "DEM", "log"))
    take(case, place, overwrite=True)
    assert sorted(os.listdir(place)) == [".lock", "case.json", "case.txt"]


# a time is a sum of steps
@pytest.mark.parametrize("reached", [0.117, 0.117 - 2e-17, 0.117 + 2e-17, 0.11700000000000017])
def test_one_that_was_ended_at_its_very_end_goes_on(top, case, reached):
    place, lock = folders.claim(case, None, tell=lambda _: None)
    case.values["end"] = 0.117
    folders.write_mark(place, case, (1, 1))
    lock.close()
    os.makedirs(os.path.join(place, "checkpoints", "000000500"))
    results(place, True, reached)
    assert folders.offer(place, case) == "", "there is nothing left of it"
    results(place, False, reached)
    assert folders.offer(place, case) == f"cases/run {case.name} --out {place} --continue"
    results(place, False, reached + case.values["dem_step"])
    assert folders.offer(place, case) == "", "it is beyond that end"


def test_a_shorter_run_is_offered_to_go_on(top, case):
    """Where it has a saved state, and nothing but the end differs."""
    place, lock = folders.claim(case, None, tell=lambda _: None)
    folders.write_mark(place, case, (1, 1))
    lock.close()
    results(place, True)
    longer = Case(case.name)
    longer.values["end"] = 0.75
    assert folders.offer(place, longer) == "", "without a saved state"
    os.makedirs(os.path.join(place, "checkpoints", "000000500.part"))
    assert folders.offer(place, longer) == "", "it was not finished"
    os.makedirs(os.path.join(place, "checkpoints", "000000500"))
    assert folders.offer(place, longer) == f"cases/run {case.name} --out {place} --continue --end 0.75"
    assert folders.offer(place, case) == f"cases/run {case.name} --out {place} --continue", "to its own end"
    with pytest.raises(CaseError, match="or go on with it: cases/run clump-half --out .* --continue --end 0.75$"):
        folders.claim(longer, place)
    for key, value in (("end", 0.1), ("seed", 2)):
        other = Case(case.name)
        other.values[key] = value
        assert folders.offer(place, other) == "", key
    said = []
    folders.claim(longer, None, tell=said.append)[1].close()
    assert said[0].endswith("it would go on by cases/run clump-half --out results/clump-half.1 --continue --end 0.75")


def test_what_was_only_prepared_is_used_again(tmp_path, case):
    place = take(case, str(tmp_path / "run"))
    with open(os.path.join(place, "in.liggghts"), "w", encoding="utf-8") as f:
        f.write("old")
    take(case, place)
    assert "in.liggghts" not in os.listdir(place)


@pytest.mark.parametrize("overwrite", [False, True])
@pytest.mark.parametrize("name", ["case.txt", "case.json", "DEM/log"])
def test_other_things_are_not_touched(tmp_path, case, name, overwrite):
    (tmp_path / "DEM").mkdir()
    (tmp_path / "picture.png").write_text("mine")
    (tmp_path / name).write_text('{"mine": 1, "values": {}}')
    with pytest.raises(CaseError, match="holds other things than a run"):
        folders.claim(case, str(tmp_path), overwrite)
    assert (tmp_path / "picture.png").read_text() == "mine"
    assert (tmp_path / name).read_text() == '{"mine": 1, "values": {}}'
    assert not (tmp_path / ".lock").exists()


def test_a_link_is_no_mark(tmp_path, case):
    place = take(case, str(tmp_path / "run"))
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "x.png").write_text("mine")
    os.symlink(os.path.join(place, "case.json"), tmp_path / "mine" / "case.json")
    with pytest.raises(CaseError, match="other things"):
        folders.claim(case, str(tmp_path / "mine"))
    assert (tmp_path / "mine" / "x.png").exists()


def test_the_text_beside_the_mark_is_not_written_through_a_link(tmp_path, case):
    place = take(case, str(tmp_path / "run"))
    (tmp_path / "precious").write_text("mine")
    os.remove(os.path.join(place, "case.txt"))
    os.symlink(tmp_path / "precious", os.path.join(place, "case.txt"))
    take(case, place)
    assert (tmp_path / "precious").read_text() == "mine"


@pytest.mark.parametrize("out", [False, True])
def test_a_dry_run_writes_beside(top, case, out):
    words = (str(top / "run"),) if out else (None,)
    place = take(case, *words)
    results(place, True)
    before = sorted(os.listdir(place))
    other = take(case, *words, dry_run=True)
    assert other == place + "-dry-run"
    assert sorted(os.listdir(place)) == before
    assert take(case, *words, dry_run=True) == other
    results(other, False)  # run by hand
    assert take(case, *words, dry_run=True) == other + "-dry-run"
    assert os.path.exists(os.path.join(other, "DEM", "log"))


@pytest.mark.parametrize("out", ["", " "])
def test_an_empty_name(case, out):
    with pytest.raises(CaseError, match="--out .*must name a folder"):
        folders.claim(case, out)


def test_two_runs_in_one_folder(tmp_path, case):
    _, lock = folders.claim(case, str(tmp_path / "run"))
    with lock, pytest.raises(CaseError, match="another run writes there"):
        folders.claim(case, str(tmp_path / "run"))
    folders.claim(case, str(tmp_path / "run"))[1].close()


def test_names_that_fit(tmp_path, case):
    (tmp_path / "file").write_text("")
    for out, says in ((str(tmp_path / "file"), "is a file"), (str(tmp_path / "a b"), "OpenFOAM takes no ' '"),
                      (str(tmp_path / "file" / "x"), "Not a directory")):
        with pytest.raises(CaseError, match=says):
            folders.claim(case, out)


def halves(place, simulated, dem=True, cfd=True):
    for name, there, content in (("DEM/dem.json", dem, {"simulated_s": simulated}), ("CFD/cfd.json", cfd, {"x": 1})):
        os.makedirs(os.path.dirname(os.path.join(place, name)), exist_ok=True)
        if there:
            with open(os.path.join(place, name), "w", encoding="utf-8") as f:
                json.dump(content, f)


VALUES = {"end": 0.5, "dem_step": 2e-5}


def test_complete_is_the_end_reached_and_both_halves_ended(tmp_path):
    place = str(tmp_path)
    assert "DEM/dem.json is missing" in state.lacking(place, VALUES)
    halves(place, 0.5, cfd=False)
    assert "CFD/cfd.json is missing" in state.lacking(place, VALUES)
    halves(place, 0.5)
    assert state.lacking(place, VALUES) == ""
    halves(place, 0.5 + 1e-12)
    assert state.lacking(place, VALUES) == ""
    halves(place, 0.117)
    assert state.lacking(place, VALUES) == "it ended at 0.117 s of 0.5 s"
    halves(place, 0.49998)
    assert state.lacking(place, VALUES)


def test_how_far_it_came(tmp_path):
    assert state.reached(str(tmp_path)) == 0.0
    (tmp_path / "settling.csv").write_text("time_s,interface_m\n0,0.15\n0.1,0.14\n0.12,0.1")  # torn
    assert state.reached(str(tmp_path)) == 0.1
    halves(str(tmp_path), 0.117)
    assert state.reached(str(tmp_path)) == 0.117


def test_the_state_is_written(tmp_path):
    state.write(str(tmp_path), "clump-half", 0.5, "ended by SIGTERM")
    found = folders.summary(str(tmp_path))
    assert found == {"case": "clump-half", "complete": False, "simulated_s": 0.0, "end": 0.5,
                     "reason": "ended by SIGTERM", "wall_s": 0.0}
    assert not state.complete(str(tmp_path))
    for text, complete in (('{"complete": true}', True), ("", False), ("[", False), ('{"complete": 1}', False)):
        (tmp_path / "summary.json").write_text(text)
        assert state.complete(str(tmp_path)) is complete
