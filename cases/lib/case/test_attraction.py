# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Van der Waals forces at the model's scale, in a clump column's settings."""

import math

import pytest

from cases.lib.case import suspension
from cases.lib.case.casefile import Case
from cases.lib.case.errors import CaseError
from cases.lib.theory import attraction


def settings(**changes):
    case = Case("clump-half")
    for key, value in changes.items():
        case.set(key, str(value))
    return {**case.values, **suspension.resolve(case.values)}


def test_without_it_nothing_is_there():
    v = settings()
    assert (v["attracted"], v["far_forces"], attraction.line(v)) == (0, "sharp", "")
    assert "hamaker" not in v


def test_force_over_weight_is_the_prototypes():
    v = settings(attraction=2e-20, gravity=9.81, prototype_diameter=2e-6)

    def over_weight(constant, d, wave):  # at a gap of a tenth of d, by Gregory's form
        h, weight = d / 10, math.pi / 6 * d**3 * (v["density"] - v["fluid_density"]) * 9.81
        return constant * (d / 4) / (6 * h * h) / (1 + 5.32 * h / wave) / weight

    words = v["far_forces"].split()
    model = {words[i]: float(words[i + 1]) for i in (3, 5, 7, 9)}
    assert words[:2] == ["sharp", "dlvo/clump"]
    assert over_weight(model["hamaker"], 2e-3, model["retarded"]) == pytest.approx(
        over_weight(2e-20, 2e-6, 1e-7), rel=1e-9)
    assert v["hamaker"] == pytest.approx(2e-8, rel=1e-9)
    assert (model["contact"], float(words[2])) == (4e-5, 2e-3)


def test_held_with_the_charges_and_beside_salt():
    v = settings(attraction=1e-20, salinity=1e-6, coulomb_steps=10)
    assert v["far_forces"].startswith("sharp screened 0.000304 dlvo/clump 0.002 debye 0.002 hamaker ")
    assert v["far_forces"].endswith(" every 10 hold")


def test_what_it_means_is_said():
    v = settings(attraction=2e-20, gravity=9.81)
    # 2e-8 J, R = 0.5 mm, h = 0.04 mm, 1 + 5.32*0.04/0.1 = 3.128
    weight = math.pi / 6 * 8e-9 * (v["density"] - v["fluid_density"]) * 9.81
    pull = 2e-8 * 5e-4 / (6 * 1.6e-9) / 3.128 / weight
    assert attraction.line(v) == ("attraction 2e-20 J: at the model's scale 2e-08 J; spheres within 0.04 mm pull each "
                                  f"other with {pull:.4g} times their weight")


def test_no_weight_to_scale_by():
    with pytest.raises(CaseError, match="attraction = 2e-20 J: .* gravity = 0 m/s2.* attraction = none"):
        settings(attraction=2e-20, gravity=0)


def test_words_that_are_no_constant():
    case = Case("clump-half")
    for bad in ("0", "-1e-20", "1e-10", "some"):
        with pytest.raises(CaseError, match="attraction"):
            case.set("attraction", bad)
