# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""regime = stokes: what it sets, what it leaves, what it refuses."""

import json
import math

import pytest

from cases.lib.case import heading, settings
from cases.lib.case.casefile import Case
from cases.lib.case.errors import CaseError
from cases.lib.theory import similarity

COLUMNS = ("clump-half", "sphere-half", "clump-full", "sphere-full", "rp-04a", "rp-07a")


def applied(name, *words, said=None):
    case = Case(name)
    settings.apply(case, settings.read(words), said.append if said is not None else None)
    return {**case.values, **case.derive(1, 1)}


def reynolds(v):
    """By hand, from the values alone."""
    d = 2 * v["sphere_radius"]
    speed = (v["density"] - v["fluid_density"]) * v["gravity"] * d**2 / (18 * v["viscosity"])
    return v["fluid_density"] * speed * d / v["viscosity"]


@pytest.mark.parametrize("name", COLUMNS)
def test_re_is_below_a_tenth(name):
    for words in ((), ("sphere_radius=5e-4",), ("density=2000", "gravity=3")):
        v = applied(name, "regime=stokes", *words)
        assert 0.085 < reynolds(v) < 0.1


@pytest.mark.parametrize("name", COLUMNS)
def test_water_changes_nothing(name):
    assert applied(name, "regime=water") == applied(name)


@pytest.mark.parametrize("name", COLUMNS)
def test_what_else_it_sets(name):
    before, v = applied(name), applied(name, "regime=stokes")
    changed = {k for k in before if before[k] != v[k]}
    assert changed <= {"regime", "viscosity", "prototype_viscosity", "time_scale", "stiffness", "dem_step", "steps",
                       "coupling_steps", "coulomb_steps", "coupling_time", "frame_steps", "frame_time", "curve_steps",
                       "profile_steps", "profile_time"}
    assert v["prototype_viscosity"] == before["viscosity"]
    # an exchange within half of a sphere's relaxation time, and while a sphere falls a tenth of a cell
    d = 2 * v["sphere_radius"]
    relaxation = v["density"] * d**2 / (18 * v["viscosity"])
    speed = (v["density"] - v["fluid_density"]) * v["gravity"] * d**2 / (18 * v["viscosity"])
    assert 0.2 * relaxation <= v["coupling_time"] <= 0.5 * relaxation
    assert speed * v["coupling_time"] <= 0.1 * v["tube_height"] / v["layers"]
    # contacts as far from their limit as the case's own, or farther
    assert v["dem_step"] * math.sqrt(v["stiffness"]) <= before["dem_step"] * math.sqrt(before["stiffness"]) * (1 + 1e-9)
    assert v["stiffness"] <= before["stiffness"]
    # by Stokes's law over the same distance
    prototype = d**2 / v["prototype_diameter"]**2 * v["prototype_viscosity"] / v["viscosity"]
    assert v["time_scale"] == pytest.approx(prototype * v["gravity"] / 9.81, rel=1e-3)


def test_what_is_set_by_name_wins():
    v = applied("clump-half", "regime=stokes", "dem_step=1e-5", "time_scale=1")
    assert (v["dem_step"], v["time_scale"], v["coupling_steps"]) == (1e-5, 1, 100)
    v = applied("clump-half", "regime=stokes", "stiffness=1050")
    assert v["stiffness"] == 1050 and v["dem_step"] <= Case("clump-half").values["dem_step"]
    v = applied("clump-half", "regime=stokes", "prototype_viscosity=2e-3")
    assert v["prototype_viscosity"] == 2e-3
    v = applied("clump-half", "regime=stokes", "accuracy=reference")
    assert (v["stiffness"], v["dem_step"]) == (5e6, 2.5e-7) and reynolds(v) < 0.1
    v = applied("clump-half", "regime=stokes", "coupling_steps=4")
    assert (v["coupling_steps"], v["coulomb_steps"]) == (4, 4)
    assert applied("clump-half", "regime=stokes", "coulomb_steps=30")["coulomb_steps"] == 30
    # Stokes flow already
    assert applied("sphere-half", "regime=stokes", "sphere_radius=1e-5")["viscosity"] == 8.94e-4


def test_refused():
    for name, words, says in (
            ("clump-half", ["viscosity=0.3"], "viscosity = 0.3: regime = stokes sets it; set one of the two"),
            ("clump-half", ["viscosity=water"], "viscosity = water: regime = stokes sets it"),
            ("sphere-half", ["sphere_radius=2e-3"], "need viscosity = 0.7875 Pa s, which may be at most 0.5"),
            ("sphere-half", ["gravity=0"], "regime = stokes: nothing falls with .* gravity = 0 m/s2"),
            ("sphere-half", ["density=1000"], "nothing falls with density = 1000")):
        with pytest.raises(CaseError, match=says):
            applied(name, "regime=stokes", *words)
    with pytest.raises(CaseError, match="regime = Stokes: must be one of water, stokes"):
        applied("clump-half", "regime=Stokes")
    with pytest.raises(CaseError, match="unknown key of case ergun-bed 'regime'"):
        applied("ergun-bed", "regime=stokes")


def test_a_case_of_ones_own_cannot_have_it(tmp_path):
    mine = {"title": "mine", "like": "clump-half", "set": {"regime": "stokes"}}
    (tmp_path / "case.json").write_text(json.dumps(mine))
    with pytest.raises(CaseError, match="regime stands for other keys; set those"):
        Case(str(tmp_path))


def test_it_is_said():
    said = []
    applied("rp-04a", "regime=stokes", "temperature=20", said=said)
    assert said[0].startswith("regime = stokes sets viscosity = 0.27") and "prototype_viscosity = 0.001" in said[0]
    assert len(said) == 1


def test_titles():
    case = Case("clump-half")
    settings.apply(case, settings.read(["regime=stokes", "charge=2e-10"]))
    assert heading.of(case, case.derive(1, 1)).endswith("clump-half with regime = stokes, charge = 2e-10 C")
    assert heading.days(case) == case.values["time_scale"]


def group(v, name):
    return next(g for g in similarity.groups(v) if g.name.startswith(name))


def test_groups():
    water, stokes = applied("clump-half"), applied("clump-half", "regime=stokes")
    # the paper's: 6.98e-3/mu^2 for 2 mm in water's density
    assert group(water, "Re").model == pytest.approx(6.976e-3 / 8.94e-4**2, rel=1e-3)
    assert not group(water, "Re").kept and group(stokes, "Re").kept
    assert group(water, "Re").prototype == group(stokes, "Re").prototype == pytest.approx(8.73e-6, rel=1e-3)
    # k_e q^2/d^2 over the buoyant weight: 3.47e-4 N over 6.57e-5 N
    for v in (water, stokes):
        assert group(v, "force of charges").model == pytest.approx(5.28, rel=1e-3)
        assert "1.24e-17 C, 77.6 elementary" in group(v, "force of charges").remark
    assert (group(stokes, "H / d").model, group(stokes, "H / d").prototype) == pytest.approx((75, 75000))
    assert group(stokes, "r_c / d").model == pytest.approx(6)
    assert group(stokes, "Debye").model is None
    # 4.1e-21 J over 6.6e-14 N and 2 um
    assert group(stokes, "Brownian").prototype == pytest.approx(0.0313, rel=2e-3)
    salty = applied("clump-half", "regime=stokes", "salinity=1e-6")
    assert group(salty, "Debye").model == pytest.approx(0.152) and group(salty, "Debye").kept
    bodies = applied("clump-half", "regime=stokes", "clump_drag=resistance")
    assert group(bodies, "Re, a sphere of a clump").model == pytest.approx(14 * 0.09, rel=1e-3)
    assert not group(bodies, "Re, a sphere of a clump").kept
    assert not [g for g in similarity.groups(applied("sphere-half")) if "charge" in g.name]


def test_table():
    rows = similarity.table(similarity.groups(applied("clump-half", "regime=stokes"))).split("\n")
    assert rows[0].split() == ["model", "prototype"]
    assert rows[1].index("8.728e-06") + 9 == len(rows[0])
    assert any(r.split()[:7] == ["r_c", "/", "d", "6", "none", "NOT", "KEPT:"] for r in rows)
    assert any(r.split()[:7] == ["H", "/", "d", "75", "7.5e+04", "NOT", "KEPT:"] for r in rows)
    assert sum("NOT KEPT" in r for r in rows) == 4
