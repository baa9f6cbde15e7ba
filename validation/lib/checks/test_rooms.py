# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Checks and scenes found by their last name; validation/run over made-up rooms."""

import runpy
import sys
import types

import pytest

from cases.lib.case import casefile
from cases.lib.case.casefile import Case
from validation.lib.checks import coupled, results_page, rooms, validation_main

GOOD = "TITLE = 'a good one'\ndef run(checks):\n    checks.equal('two', 1 + 1, 2)\n"
RAISES = "TITLE = 'one that raises'\ndef run(checks):\n    checks.equal('one', 1, 1)\n    raise OSError('no disk')\n"
LONG = "TITLE = 'a long one'\nLONG = True\ndef run(checks):\n    checks.equal('three', 3, 3)\n"


@pytest.fixture
def house(tmp_path, monkeypatch):
    """Writes checks into rooms of a validation folder, {room/name: text}."""
    def build(**texts):
        for name, text in texts.items():
            folder = tmp_path / "validation" / name.replace("__", "/")
            folder.mkdir(parents=True)
            (folder / "check.py").write_text(text)
    monkeypatch.setattr(rooms, "HERE", str(tmp_path / "validation"))
    monkeypatch.setattr(rooms, "load", lambda name: types.SimpleNamespace(
        **runpy.run_path(rooms.holding("check.py")[name] + "/check.py")))
    monkeypatch.setattr(validation_main, "RUNS", str(tmp_path / "results"))
    return build


def validation(monkeypatch, capsys, *words):
    monkeypatch.setattr(sys, "argv", ["run", *words])
    status = validation_main.main()
    said = capsys.readouterr()
    return status, said.out, said.err


def test_folders_of_all_rooms(house, tmp_path):
    house(dem__bounce=GOOD, theory__kynch=GOOD)
    (tmp_path / "validation" / "README.md").write_text("no room")
    assert rooms.holding("check.py") == {n: str(tmp_path / "validation" / r / n)
                                         for r, n in (("dem", "bounce"), ("theory", "kynch"))}
    house(cost__kynch=GOOD)
    with pytest.raises(ValueError, match="cost/kynch and .*theory/kynch: two folders of one name"):
        rooms.holding("check.py")


def test_scenes_are_cases_by_their_last_name():
    case = Case("lattice-scene")
    assert case.folders[-1] == rooms.holding("case.json")["lattice-scene"]
    assert "lattice-scene" not in casefile.names()  # cases/run --list shows those of cases/
    with pytest.raises(KeyError):
        rooms.holding("in.liggghts")["no such scene"]


def test_a_check_that_fails_does_not_stop_the_others(house, monkeypatch, capsys):
    house(dem__bad=RAISES, dem__worse="TITLE = (", theory__good=GOOD, theory__long=LONG, dem__nameless="X = 1\n")
    status, said, _ = validation(monkeypatch, capsys)
    assert status == 1
    assert "OSError: no disk" in said
    assert "check.py of worse: SyntaxError" in said
    assert "check.py of nameless: KeyError: 'TITLE'" in said
    assert "-- good: a good one" in said
    assert "a long one" not in said
    assert said.endswith("2 passed, 3 failed\n")


def test_names_and_long_ones(house, monkeypatch, capsys):
    house(theory__good=GOOD, theory__long=LONG)
    assert validation(monkeypatch, capsys, "good")[:2][0] == 0
    assert "2 passed, 0 failed" in validation(monkeypatch, capsys, "--all")[1]
    assert "1 passed, 0 failed" in validation(monkeypatch, capsys, "long")[1]
    assert validation(monkeypatch, capsys, "goood") == (
        2, "", "validation/run: unknown check 'goood'; did you mean 'good'?\n")
    assert validation(monkeypatch, capsys, "--list")[1].splitlines() == [
        "theory       good                  a good one", "theory       long                  (long) a long one"]


def test_results_go_into_the_readme_of_the_room(house, monkeypatch, capsys, tmp_path):
    house(theory__good=GOOD)
    readme = tmp_path / "validation" / "theory" / "good" / "README.md"
    readme.write_text(f"# Good\n{results_page._BEGIN}\n{results_page._END}\n")
    assert validation(monkeypatch, capsys, "--record")[0] == 0
    assert "| two | 2 | 2 |  | equal | pass |" in readme.read_text()
    assert "## good" in (tmp_path / "validation" / "RESULTS.md").read_text()


def test_a_command_that_takes_too_long_is_ended():
    outcome = coupled.execute(["sh", "-c", "echo begun; sleep 60"], 0.5)
    assert (outcome.status, outcome.output) == (None, "begun\n")
    assert outcome.seconds < 30
