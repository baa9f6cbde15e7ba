# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Laws that are known, in a profile that Gibson's theory makes of them, are found again; what cannot be fitted is
refused."""

import csv
import json
import os
import sys

import numpy as np
import pytest

from cases.lib.case.errors import CaseError
from cases.lib.consolidation import consolidation_main, lawfit, predict
from cases.lib.output import profile
from cases.lib.theory import gibson

LAWS = gibson.PowerLaws(a=30.0, b=0.5, z=5.0, c=6e-8, d=1.8, viscosity=0.2784)  # gel point e = 13.4
SETTINGS = {"sphere_radius": 1e-3, "density": 2600.0, "fluid_density": 1000.0, "gravity": 9.81, "viscosity": 0.2784,
            "fill_height": 0.15, "tube_height": 0.15, "solid_fraction": 0.0636}
WEIGHT, WALLS = 1600 * 9.81, 0.2
SLICES, END = 50, 40.0


def made(folder, laws=LAWS, settings=None, end=END, noise=0.03, walls=WALLS, seed=1):
    """A run's folder, as the theory has it: walls hold a part of the weight, noise is the logarithm's of all rows."""
    settings = {**SETTINGS, **(settings or {})}
    phi = settings["solid_fraction"]
    z = np.linspace(0, phi * settings["fill_height"], 121)
    times = np.linspace(0, end, 401)
    run = gibson.solve(laws, z, np.full(120, (1 - phi) / phi), times, WEIGHT * (1 - walls))
    rng = np.random.default_rng(seed)
    height = settings["tube_height"] / SLICES
    edges = np.linspace(0, settings["tube_height"], SLICES + 1)
    middles = 0.5 * (edges[1:] + edges[:-1])
    columns = {"time_s": times[::2], "height_m": middles}
    names = ("solid_fraction", "contact_Pa", "coulomb_Pa", "wall_Pa", "weight_Pa", "excess_pressure_Pa",
             "permeability_m2")
    columns.update({n: np.zeros((len(times[::2]), SLICES)) for n in names})
    for k, (e, faces) in enumerate(zip(run.e[::2], run.faces[::2])):
        below = np.interp(edges, faces, z)
        mean = np.diff(below) / height
        columns["solid_fraction"][k] = mean
        weight = WEIGHT * (z[-1] - np.interp(middles, faces, z))
        here = np.interp(middles, 0.5 * (faces[1:] + faces[:-1]), e)
        stress = np.where(middles < faces[-1], laws.stress(here), 0.0)
        columns["weight_Pa"][k], columns["wall_Pa"][k] = weight, walls * weight
        columns["contact_Pa"][k], columns["coulomb_Pa"][k] = 1.2 * stress, -0.2 * stress
        columns["excess_pressure_Pa"][k] = weight * (1 - walls) - stress
        columns["permeability_m2"][k] = np.where(mean > 0.02, laws.permeability(here), np.nan)
    for name in ("contact_Pa", "coulomb_Pa", "permeability_m2"):
        columns[name] = columns[name] * np.exp(noise * rng.standard_normal(columns[name].shape))
    os.makedirs(folder, exist_ok=True)
    profile.write(folder, columns)
    with open(os.path.join(folder, "settling.csv"), "w", encoding="utf-8") as f:
        f.write("time_s,interface_m,bed_m,mean_height_m\n")
        for row in zip(times, run.interface(radius=1e-3), run.mean_height()):
            f.write(f"{row[0]:.6g},{row[1]:.8g},0,{row[2]:.8g}\n")
    with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as f:
        json.dump({"case": "made", "title": "made by theory", "complete": True, "settings": settings}, f)
    return str(folder)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return made(tmp_path_factory.mktemp("made"))


def command(*words):
    """Runs cases/consolidation."""
    old = sys.argv
    sys.argv = ["consolidation", *words]
    try:
        return consolidation_main.main()
    finally:
        sys.argv = old


def test_known_laws_are_found_again(folder):
    """Within 5 % of e at every stress, 10 % of kappa at every e, of those that the points cover; the exponents and the
    walls' part in their intervals or near."""
    run = predict.read(folder)
    fit = lawfit.fit(run.columns, run.settings, run.begin, samples=40)
    stress = np.geomspace(np.min(fit.compression.value), np.max(fit.compression.value), 30)
    assert fit.laws.void_ratio(stress) == pytest.approx(LAWS.void_ratio(stress), rel=0.05)
    e = np.geomspace(*fit.range_of("permeability"), 30)
    assert fit.laws.permeability(e) == pytest.approx(LAWS.permeability(e), rel=0.1)
    assert fit.laws.d == pytest.approx(LAWS.d, abs=0.05) and fit.laws.b == pytest.approx(LAWS.b, abs=0.1)
    assert fit.walls == pytest.approx(WALLS, abs=1e-3)
    for low, high in fit.intervals.values():
        assert low <= high


def test_its_settlement_is_foretold(folder):
    run = predict.read(folder)
    fit = lawfit.fit(run.columns, run.settings, run.begin, samples=0)
    for curve in (predict.from_stage(run, fit.laws, fit.walls), predict.from_start(run, fit.laws, fit.walls)):
        rms, last = predict.errors(run, curve)
        assert rms < 0.02 * run.fall and abs(last) < 0.05 * run.fallen
        assert curve.time_90 == pytest.approx(predict.simulated_90(run), rel=0.1)


def test_another_height_is_foretold(folder, tmp_path, capsys):
    """With the laws of one column, another's settlement within 5 % of its fall, knowing its height and solids alone."""
    taller = made(tmp_path / "taller", settings={"fill_height": 0.25, "tube_height": 0.25}, end=120.0, seed=2)
    assert command(folder, "--samples", "20") == 0
    assert command(taller, "--laws", os.path.join(folder, "consolidation.json")) == 0
    assert "of another run" in capsys.readouterr().out
    with open(os.path.join(taller, "consolidation.json"), encoding="utf-8") as f:
        found = json.load(f)
    foretold = found["computed"]["from the start"]
    assert foretold["rms_error_m"] < 0.05 * found["fall_m"] and abs(foretold["error_at_end_m"]) < 0.05 * found["fall_m"]
    assert foretold["time_90_s"] == pytest.approx(found["simulated"]["time_90_s"], rel=0.1)


def test_what_it_writes(folder, capsys):
    assert command(folder, "--samples", "20") == 0
    said = capsys.readouterr().out
    for words in ("95 % interval", "walls hold 20 %", "from the first stage", "90 % at"):
        assert words in said
    assert os.path.getsize(os.path.join(folder, "consolidation.png")) > 10000
    with open(os.path.join(folder, "consolidation.csv"), encoding="utf-8", newline="") as f:
        rows = list(csv.DictReader(f))
    assert rows[0]["interface_from_the_first_stage_m"] == "" and float(rows[-1]["interface_from_the_start_m"]) > 0
    assert len(rows) == 401


@pytest.mark.parametrize("change, says", [
    ({"complete": False, "reason": "it was stopped"}, "is not complete: it was stopped"),
    ({"settings": {"sphere_radius": 1e-3}}, "is no column: its settings lack density"),
    (None, "holds no summary.json of a run"),
])
def test_runs_that_are_refused(folder, tmp_path, change, says):
    for name in ("settling.csv", "profile.csv", "summary.json"):
        with open(os.path.join(folder, name), encoding="utf-8") as f:
            (tmp_path / name).write_text(f.read())
    if change is None:
        (tmp_path / "summary.json").unlink()
    else:
        whole = json.loads((tmp_path / "summary.json").read_text())
        (tmp_path / "summary.json").write_text(json.dumps({**whole, **change}))
    with pytest.raises(CaseError, match=says):
        predict.read(str(tmp_path))


def test_too_little_compression_is_refused(tmp_path):
    # a bed that hardly yields: void ratio 5.4 to 5.0
    stiff = gibson.PowerLaws(a=5.4, b=0.015, z=1.0, c=6e-8, d=1.8, viscosity=0.2784)
    with pytest.raises(CaseError, match=r"the interface falls by .* mm, .* sphere diameters; 2 are needed"):
        predict.read(made(tmp_path, laws=stiff))


def test_curves_without_a_second_stage_are_refused(folder, tmp_path):
    made(tmp_path, end=4.0)
    with pytest.raises(CaseError, match="its curve has one stage"):
        predict.read(str(tmp_path))


def test_too_few_points_are_refused(folder):
    run = predict.read(folder)
    none = {**run.columns, "permeability_m2": np.full_like(run.columns["permeability_m2"], np.nan)}
    with pytest.raises(CaseError, match="0 points of permeability in profile.csv"):
        lawfit.fit(none, run.settings, run.begin)


def test_arguments(folder, tmp_path):
    for words, says in ((("--samples", "3"), "--samples 3: must be at least 20"),
                        (("--set", "charge=0"), "is a run; --set, --end and --store go with a case"),
                        (("--laws", str(tmp_path / "none.json")), "--laws .*none.json: is no consolidation.json")):
        with pytest.raises(CaseError, match=says):
            command(folder, *words)


def test_an_exponential_is_said(tmp_path, capsys):
    laws = gibson.PowerLaws(a=13.4 * 3000.0**60, b=60.0, z=3000.0, c=6e-8, d=1.8, viscosity=0.2784)
    assert command(made(tmp_path, laws=laws, noise=0.005), "--samples", "20") == 0
    assert "B is at its bound: log e falls with s, by one in" in capsys.readouterr().out
