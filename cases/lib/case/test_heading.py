# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What a run is called, what decides nothing in it, and the mesh that follows its dimensions."""

import re

import pytest

from cases.lib.case import heading, settings
from cases.lib.case.casefile import Case


def case(name, *words):
    found = Case(name)
    settings.apply(found, settings.read(words))
    return found


def title(name, *words):
    made = case(name, *words)
    return heading.of(made, made.derive(1, 1))


def test_titles_are_those_of_the_settings():
    assert title("clump-half") == Case("clump-half").title
    assert title("clump-half", "end=1", "seed=3") == Case("clump-half").title
    assert title("clump-half", "clumps=60", "illite_share=1") == (
        "60 charged clumps of illite in a tube of 32.5 mm, 150 mm high; clump-half with clumps = 60, illite_share = 1")
    assert title("clump-half", "charge=0").startswith("135 uncharged clumps, 50 % of them illite in a tube")
    assert "solids = 5 %" in title("sphere-half", "solids=5")
    assert re.match(r"\d+ spheres in a tube", title("sphere-half", "solids=5"))
    words = ("density=2500", "viscosity=1e-3", "spheres=900", "restitution=0.5", "friction=0.1")
    assert title("ergun-bed", *words).endswith(
        "in a box of 10 x 10 x 50 mm; ergun-bed with density = 2500 kg/m3, restitution = 0.5, friction = 0.1, "
        "viscosity = 0.001 Pa s, 1 more")


def test_titles_of_sweeps():
    assert heading.of_several(case("clump-half", "end=1"), ["charge"]) == "clump-half, charge varied"
    assert heading.of_several(case("clump-half", "clumps=60"), ["charge", "salinity"]) == (
        "clump-half, charge and salinity varied, with clumps = 60")


@pytest.mark.parametrize("name, words, known", [
    ("clump-half", [], True), ("clump-half", ["clumps=60", "stiffness=900"], True), ("rp-04a", [], True),
    ("clump-half", ["illite_share=1"], False), ("clump-half", ["charge=1e-10"], False),
    ("clump-half", ["charge=1e-10", "time_scale=5e5"], True), ("sphere-half", [], False), ("column1890", [], False),
    ("sphere-half", ["time_scale=5e5"], True)])
def test_days_where_the_time_scale_was_calibrated(name, words, known):
    made = case(name, *words)
    assert heading.days(made) == (made.values["time_scale"] if known else None)


def test_what_decides_nothing_is_not_said():
    assert Case("clump-half").idle() == {"solids": "clumps", "solid_fraction": "clumps", "temperature": "fluid_density"}
    assert case("clump-half", "solids=5").idle() == {"temperature": "fluid_density"}
    assert case("clump-half", "solid_fraction=0.05").idle()["solids"] == "solid_fraction"
    assert case("clump-half", "viscosity=water").idle().keys() == {"solids", "solid_fraction"}
    line = next(x for x in case("clump-half", "clumps=60").table().splitlines() if x.startswith("  solids "))
    assert re.match(r"  solids +-  +% ", line) and "15" not in line
    assert line.endswith("(decides nothing here: clumps = 60)")


def test_the_columns_of_keys_keep_apart():
    for name in ("clump-half", "ergun-bed", "column1890", "rp-04a"):
        made = Case(name)
        rows = [re.split(r" {2,}", line.strip(), maxsplit=3) for line in made.table().splitlines()]
        assert [r[0] for r in rows] == list(made.parameters)
        assert all(len(r) == 4 for r in rows)


def test_the_mesh_follows_the_dimensions():
    said = []
    made = Case("clump-half")
    given = settings.apply(made, settings.read(["tube_radius=0.0325", "tube_height=0.3"]), said.append)
    full = Case("clump-full")
    for key in ("core_cells", "ring_cells", "layers"):
        assert made.values[key] == given[key] == full.values[key]
    assert said == ["the mesh follows: core_cells = 8, ring_cells = 4, layers = 24"]
    # cells that are given stay
    made = case("clump-half", "tube_height=0.3", "layers=5")
    assert (made.values["layers"], made.values["core_cells"]) == (5, 4)
    assert case("clump-half", "tube_height=0.151").values["layers"] == 12
