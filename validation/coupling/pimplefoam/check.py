# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""clayFoam without grains against OpenFOAM's pimpleFoam, on the same files."""

import math
import os
import shutil

from cases.lib.case import openfoam
from cases.lib.run import launch
from validation.lib.checks import coupled
from validation.lib.checks.verdicts import Broken

TITLE = "the fluid alone: clayFoam against pimpleFoam"

SOURCE = os.path.dirname(os.path.abspath(__file__))
LID = {"endsType": "wall", "topU": "fixedValue", "bottomU": "noSlip", "endsP": "zeroGradient",
       "endsK": "kqRWallFunction", "endsEpsilon": "epsilonWallFunction", "endsOmega": "omegaWallFunction",
       "endsNut": "nutkWallFunction", "forced": "no", "carrier": "Newtonian", "simulation": "laminar",
       "turbulence": "none"}
DUCT = LID | {key: "cyclic" for key in LID if key[:4] in ("ends", "topU", "bott")} | {"forced": "yes"}
MODELS = {"Newtonian": {}, "Herschel-Bulkley": {"carrier": "HerschelBulkley"},
          "Smagorinsky": {"simulation": "LES", "turbulence": "Smagorinsky"},
          "k-epsilon": {"simulation": "RAS", "turbulence": "kEpsilon"},
          "k-omega SST": {"simulation": "RAS", "turbulence": "kOmegaSST"}}


def _case(folder, scene, across):
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(SOURCE, folder, ignore=shutil.ignore_patterns("check.py", "README*", "__pycache__"))
    os.makedirs(os.path.join(folder, "DEM"))
    case = os.path.join(folder, "CFD")
    with open(os.path.join(case, "row"), "w", encoding="utf-8") as f:
        f.writelines(f"{key} {value};\n" for key, value in {**scene, "across": across, "along": 2*across}.items())
    openfoam.run("blockMesh", case)
    shutil.copytree(case, os.path.join(folder, "alone"))


def _both(name, scene, across):
    """U of the cells, of clayFoam and of pimpleFoam."""
    folder = os.path.join(coupled.RUNS, "pimplefoam", name.replace(",", "").replace(" ", "-"), str(across))
    _case(folder, scene, across)
    openfoam.run("pimpleFoam", os.path.join(folder, "alone"))
    halves = launch.Run(folder, 1, 1)
    words = halves.command()
    at = words.index("liggghts-clay") + 1
    words[at:at] = ["-var", "ends", "p" if scene["endsType"] == "cyclic" else "f"]
    outcome = coupled.execute(words, 300, cwd=folder, env=halves.environment())
    if outcome.status != 0:
        raise Broken(f"{name}: ended with {outcome.status}: {outcome.output.strip()[-300:]}")
    return [openfoam.internal_field(os.path.join(folder, which, "0.2", "U"), 2*across**3) for which in ("CFD", "alone")]


def _apart(ours, theirs):
    """Root mean square of the difference over that of pimpleFoam's."""
    squares = [sum(x*x for x in v) for v in theirs]
    return math.sqrt(sum(sum((a - b)**2 for a, b in zip(u, v)) for u, v in zip(ours, theirs)) / sum(squares))


def run(checks):
    for name in ("Newtonian", "Herschel-Bulkley"):
        coarse, fine = (_apart(*_both(f"lid {name}", LID | MODELS[name], across)) for across in (6, 12))
        checks.at_most(f"lid, {name}: difference of U in cells of 1/12 [rms over rms]", fine, 0.05)
        checks.at_least(f"lid, {name}: that in cells of 1/6 over it", coarse/fine, 2.0)
    plain = None
    for name, model in MODELS.items():
        ours, theirs = _both(f"duct {name}", DUCT | model, 12)
        plain = theirs if plain is None else plain
        checks.at_most(f"duct, {name}: difference of U [rms over rms]", _apart(ours, theirs), 1e-9)
        if name != "Newtonian":
            checks.at_least(f"duct, {name}: difference of pimpleFoam's U from the Newtonian one", _apart(theirs, plain),
                            1e-5)
