# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/run's lists, and how it says that a run which was ended would go on."""

from cases.lib.case import casefile
from cases.lib.run import folders, run_main, state
from cases.lib.run.test_saved_pairs import pair


def test_a_broken_case_hides_no_other(tmp_path, monkeypatch):
    monkeypatch.setattr(casefile, "PLACES", (*casefile.PLACES, str(tmp_path)))
    whole = list(run_main.listed())
    assert any(x.startswith("clump-half ") for x in whole)
    monkeypatch.setattr(casefile, "PLACES", (str(tmp_path), *casefile.PLACES[1:]))
    (tmp_path / "bad").mkdir()
    (tmp_path / "bad" / "case.json").write_text("{")
    lines = list(run_main.listed())
    assert len(lines) == 1
    assert lines[0].startswith("bad             cannot be read: ")


def test_where_a_run_would_go_on(tmp_path):
    case = casefile.Case("clump-half")
    case.values.update(end=3.0)
    folder = str(tmp_path)
    folders.write_mark(folder, case, (1, 1))
    state.write(folder, case.name, 3.0, "the fluid is NaN")
    derived = {"steps": 3000}
    assert run_main._further(folder, case, derived) == ""
    pair(tmp_path, 1000)
    (pair(tmp_path, 2000) / "cfd" / "U").unlink()
    said = run_main._further(folder, case, derived)
    assert said == f"; it would go on from the state of 1 s by cases/run clump-half --out {folder} --continue"
    (tmp_path / "checkpoints" / "000001000" / "dem" / "sums").unlink()
    assert "holds no complete saved state" in run_main._further(folder, case, derived)
