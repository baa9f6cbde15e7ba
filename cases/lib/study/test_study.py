# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The study's rows are settings that the case takes; what it reads from a run; its table and page."""

import json
import sys

import numpy as np
import pytest

from cases.lib.case import settings
from cases.lib.case.casefile import Case
from cases.lib.case.errors import CaseError
from cases.lib.output import profile
from cases.lib.run import runs
from cases.lib.study import measure, rows, study_main


@pytest.mark.parametrize("name", rows.ROWS)
def test_rows_are_settings(name):
    case = Case(rows.CASE)
    changes = rows.changes(name, 2)
    settings.apply(case, changes)
    v = {**case.values, **case.derive(1, 1)}
    assert v["seed"] == 2 and v["clumps"] >= 10
    for key, value in rows.ROWS[name][1].items():
        assert case.values[key] == (value if isinstance(case.values[key], str) else float(value))
    # one thing of a row is another than the base's, and the end, which goes with it
    assert len(set(rows.ROWS[name][1]) - {"end"}) == {"stokes": 0, "wide": 2}.get(name, 1)


T, FIRST, DONE, END = np.linspace(0, 10, 1001), 2.0, 6.0, 10.0


def made(folder):
    """A run that falls at 20 mm/s to 2 s, at 2 mm/s to 6 s, and rests; its pore pressure is below 5 % from 4 s on."""
    z = 0.06 - 0.02 * np.minimum(T, FIRST) - 0.002 * np.clip(T - FIRST, 0, DONE - FIRST)
    with open(folder / "settling.csv", "w", encoding="utf-8") as f:
        f.write("time_s,interface_m\n" + "".join(f"{a:.6g},{b:.8g}\n" for a, b in zip(T, z)))
    t, height = np.linspace(0, END, 101), np.array([0.001, 0.003])
    columns = {"time_s": t, "height_m": height}
    weight = np.tile([10.0, 5.0], (len(t), 1))
    part = np.where(t < 4.0 - 1e-9, 0.8 - 0.1 * t, 0.0)[:, None]
    columns.update(weight_Pa=weight, excess_pressure_Pa=part * weight, contact_Pa=(1 - part) * weight,
                   coulomb_Pa=0 * weight)
    profile.write(str(folder), columns)
    (folder / "summary.json").write_text(json.dumps({"reynolds_max": 0.5}))
    return str(folder)


def test_what_it_reads(tmp_path):
    m = measure.of(made(tmp_path))
    assert m.stages >= 2 and m.slope_1 == pytest.approx(0.02, rel=0.02)
    assert m.first == pytest.approx(FIRST, abs=0.1) and m.slope_2 == pytest.approx(0.002, rel=0.3)
    assert m.height_1 == pytest.approx(0.02, rel=0.05) and m.height == pytest.approx(0.012)
    # less than 1 % of the fall of 48 mm is 0.48 mm, 0.24 s at 2 mm/s
    assert m.done == pytest.approx(DONE - 0.24, abs=0.02)
    assert m.drained == pytest.approx(4.0, abs=0.11) and m.half == pytest.approx(3.05, abs=0.11)
    assert m.falling == pytest.approx(0, abs=1e-6) and m.reynolds == 0.5
    assert m.ratio == pytest.approx(m.done / m.first)


def test_from_then_on():
    t = np.array([0.0, 1, 2, 3])
    assert measure.from_then_on(t, np.array([True, False, True, True])) == 2
    assert measure.from_then_on(t, np.array([True] * 4)) == 0
    assert measure.from_then_on(t, np.array([True, True, True, False])) is None


def test_numbers_of_several_runs():
    assert study_main.spread([1.0, 2.0, 3.0]) == "2 ± 1"
    assert study_main.spread([1.0, None, 2.0], 1e3) == "1.5e+03 ± 5e+02 (2 of 3)"
    assert study_main.spread([None]) == "-" and study_main.spread([4.0]) == "4"


@pytest.fixture
def tried(tmp_path, monkeypatch):
    """The program with a store whose runs are made up; the second row's second run fails."""
    folder = tmp_path / "run"
    folder.mkdir()
    made(folder)

    class Store:
        def __init__(self, *_):
            pass

        def run_many(self, wanted, _):
            return [runs.Result(str(folder), "no good" if k == 3 else "") for k, _ in enumerate(wanted)]

        def finished(self, _, changes):
            return str(folder) if changes["seed"] == "2" and "charge" not in changes else None

    monkeypatch.setattr(study_main.runs, "Store", Store)
    page = tmp_path / "STUDY.md"
    page.write_text("before\n<!-- study -->\nold\n<!-- end of study -->\nafter\n")
    monkeypatch.setattr(study_main, "PAGE", str(page))

    def go(*words):
        monkeypatch.setattr(sys, "argv", ["study", *words, "--out", str(tmp_path / "out")])
        return study_main.main()
    return go, page, tmp_path / "out" / "study.json"


def test_the_table_and_the_page(tried, capsys):
    go, page, found = tried
    assert go("stokes", "water", "--seeds", "2", "--record") == 1
    captured = capsys.readouterr()
    assert "study: water, packing 2: no good" in captured.err
    text = page.read_text()
    assert text.startswith("before\n<!-- study -->\n") and text.endswith("<!-- end of study -->\nafter\n")
    assert "old" not in text and "Failed: water, packing 2: no good." in text
    assert "Not run: `resistance` (" in text and "`height` (" in text
    lines = [x for x in text.split("\n") if x.startswith("|")]
    assert len({x.count("|") for x in lines}) == 1 and len(lines) == 4
    assert "| `stokes` | " in lines[2] and " | 2 | " in lines[2] and "| `water` |" in lines[3] and " | 1 | " in lines[3]
    assert len(json.loads(found.read_text())["rows"]["stokes"]["runs"]) == 2


def test_arguments(tried, capsys):
    go, *_ = tried
    for words, says in ((("stoks",), "unknown row 'stoks'; did you mean 'stokes'"),
                        (("--seeds", "0"), "--seeds 0: must"), (("--jobs", "999"), "--jobs 999: must be from 1 to")):
        with pytest.raises(CaseError, match=says):
            go(*words)
    assert go("--list") == 0 and "no charges" in capsys.readouterr().out
    assert go("stokes", "--dry-run") == 0
    said = capsys.readouterr().out
    assert said.count("to run  stokes") == 2 and said.count("there   stokes") == 1
    with pytest.raises(CaseError, match="--finished: none of the runs is there"):
        go("no-charge", "--finished")


def test_of_what_is_there_alone(tried, capsys):
    go, page, found = tried
    assert go("--finished", "--record") == 0
    assert "| `stokes` | Stokes flow, as the others but for what they say | 1 |" in page.read_text()
    assert "`no-charge` (no charges)" in page.read_text().split("Not run: ")[1].split("\n")[0]
    assert {len(r["runs"]) for r in json.loads(found.read_text())["rows"].values()} == {1}
