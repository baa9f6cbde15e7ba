# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/run's lists."""

from cases.lib.case import casefile
from cases.lib.run import run_main


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
