# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What follows a run: its summary, its exit code, and the report of one that was stopped."""

import json
import os
import sys

import numpy as np
import pytest

from cases.lib.case.casefile import Case
from cases.lib.case.errors import CaseError
from cases.lib.output import pictures, spheres
from cases.lib.page import report_main
from cases.lib.run import folders, launch, report, state

DEM = {"program": "LIGGGHTS", "particles": 2, "particles_lost": 0, "clumps": 0, "simulated_s": 0.5, "dem_s": 1.0,
       "exchange_s": 0.1, "waiting_s": 0.1, "output_s": 0.1, "dem_steps": 25000, "exchanges": 500,
       "max_overlap_over_d": 0.01}
CFD = {"program": "clayFoam", "openfoam": "v1912", "cfd_s": 1.0, "mapping_s": 0.1, "exchange_s": 0.1, "waiting_s": 0.1,
       "cfd_steps": 500, "max_momentum_residual": 1e-15, "max_void_fraction_volume_error": 1e-15, "reynolds_max": 1.0,
       "courant_max": 0.1}
DUMP = "ITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS id mol type x y z vx vy vz radius \n1 1 1 0 0 0.1 0 0 0 0.001 \n"


class Made:
    """The folder of a run of half a second that was made up."""

    def __init__(self, top):
        self.folder, self.case = str(top / "run"), Case("clump-half")
        self.case.set("end", "0.5")
        os.makedirs(self.folder)
        folders.write_mark(self.folder, self.case, (1, 1))
        self.put("settling.csv", "time_s,interface_m,bed_m,mean_height_m\n0,0.15,0.01,0.07\n0.1,0.14,0.01,0.06\n0.2,")
        self.put("DEM/spheres.000000000.dump", DUMP)
        self.put("DEM/spheres.000005000.dump", DUMP[:-20])

    def put(self, name, content):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as f:
            f.write(content if isinstance(content, str) else json.dumps(content))

    def finish(self, **more):
        run = launch.Run(self.folder, 1, 1)
        run.wall = 2.0
        return report.finish(self.case, run, self.case.derive(1, 1), pictures=False, **more)

    def report(self, monkeypatch, *words):
        monkeypatch.setattr(sys, "argv", ["report", self.folder, *words])
        return report_main.main()


@pytest.fixture
def made(tmp_path):
    return Made(tmp_path)


def whole(made):
    made.put("DEM/dem.json", DEM)
    made.put("CFD/cfd.json", CFD)
    os.remove(os.path.join(made.folder, "DEM", "spheres.000005000.dump"))


def test_overlaps_of_the_size_of_the_debye_length(made, capsys):
    whole(made)
    made.case.set("salinity", "1e-5")  # a fifth of 0.096 mm is 0.0096 of 2 mm
    assert made.finish() == 0
    assert "warning: spheres overlap by 0.02 mm, more than a fifth" in capsys.readouterr().out
    assert len(folders.summary(made.folder)["warnings"]) == 1


def test_a_complete_run(made, capsys):
    whole(made)
    assert made.finish() == 0
    s = folders.summary(made.folder)
    assert (s["complete"], s["simulated_s"], s["end"]) == (True, 0.5, 0.5)
    assert "reason" not in s
    assert "particles     2, lost 0" in capsys.readouterr().out


def test_particles_that_were_lost(made, capsys):
    whole(made)
    made.put("DEM/dem.json", {**DEM, "particles_lost": 1})
    assert made.finish() == 3
    assert state.complete(made.folder)
    assert "1 particles were lost" in capsys.readouterr().err


def test_complete_but_for_its_report(made, capsys, monkeypatch):
    whole(made)
    made.put("DEM/spheres.000005000.dump", DUMP[:-20])
    assert made.finish() == 4
    assert state.complete(made.folder)
    assert "the run is complete, its report is not: " in capsys.readouterr().err


def test_a_stopped_run(made, capsys, monkeypatch):
    state.write(made.folder, "clump-half", 0.5, "ended by SIGTERM", 3.0)
    monkeypatch.setattr(pictures, "columns", lambda *_, **more: more["torn"] or pytest.fail("not torn"))
    assert made.report(monkeypatch) == 0
    s = folders.summary(made.folder)
    assert (s["complete"], s["simulated_s"], s["end"], s["reason"]) == (False, 0.1, 0.5, "ended by SIGTERM")
    assert s["wall_s"] == 3.0
    assert s["settings"]["charge"] == made.case.values["charge"]
    assert "not complete, 0.1 s of 0.5 s: ended by SIGTERM" in capsys.readouterr().out
    assert os.path.getsize(os.path.join(made.folder, "settling.png")) > 5000
    assert sorted(n for n in os.listdir(os.path.join(made.folder, "DEM")) if n.endswith(".vtu")) == [
        "spheres.000000000.vtu"]  # the other dump is torn


def test_a_run_by_hand_is_complete_when_both_halves_are(made, monkeypatch):
    whole(made)
    assert made.report(monkeypatch, "--no-pictures") == 0
    assert state.complete(made.folder)


def test_a_half_that_failed_at_the_very_end(made, monkeypatch):
    whole(made)
    state.write(made.folder, "clump-half", 0.5, "a half failed")
    made.report(monkeypatch, "--no-pictures")
    assert folders.summary(made.folder)["reason"] == "a half failed"


def test_refusals(made, monkeypatch, tmp_path):
    _, lock = made.folder, folders.files.Lock(os.path.join(made.folder, folders.LOCK))
    with lock, pytest.raises(CaseError, match="the run is under way"):
        made.report(monkeypatch)
    made.put("case.json", {"clayFoam run": 1, "case": "clump-half", "values": {}, "ranks": [1, 1]})
    with pytest.raises(CaseError, match="by another version"):
        made.report(monkeypatch)
    os.remove(os.path.join(made.folder, "case.json"))
    with pytest.raises(CaseError, match="is no run's folder; it lacks case.json"):
        made.report(monkeypatch)


@pytest.mark.parametrize("text", ["", DUMP[:30], DUMP[:-1].rstrip(), DUMP + "1 2", DUMP.replace("0.1", "x"),
                                  DUMP.replace("\n1\n", "\n2\n", 1)])
def test_a_torn_dump(tmp_path, text):
    path = tmp_path / "a.dump"
    path.write_text(DUMP)
    assert np.array_equal(spheres.read(str(path))["z"], [0.1])
    path.write_text(text)
    with pytest.raises(CaseError, match="is not a whole dump"):
        spheres.read(str(path))
