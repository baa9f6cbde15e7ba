# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What a scene does not have costs it nothing: instructions, counted by callgrind."""

import json
import os
import shutil
from concurrent import futures

from cases.lib.run import launch, openmpi
from validation.lib.checks import callgrind, coupled
from validation.lib.checks.verdicts import Broken

TITLE = "a scene pays nothing for features it does not have (instruction counts)"
STEPS = 25  # DEM steps an exchange
LAST = 3    # exchanges that are counted, of seven

# feature: half, what its functions' names begin with
FEATURES = {
    "charges (pair coul/clump)": ("dem", r"LAMMPS_NS::PairCoulClump::|clay::(coulomb|ChargeGroups|ChargeTiles)"),
    "bodies (fix multisphere/clump)": ("dem", r"LAMMPS_NS::(FixMultisphere|Multisphere)|clay::Body"),
    "a clump's own resistance": ("dem", r"LAMMPS_NS::CoupledClumps::|clay::(ClumpDrag|shapeLaw|growth)"),
    "resting bed (rest=no)": ("dem", r"LAMMPS_NS::FixRestBed::|clay::Rest(Track|Watch)::"),
    "random forces (fix brownian)": ("dem", r"LAMMPS_NS::FixBrownian::"),
    "films (fix lubrication)": ("dem", r"LAMMPS_NS::FixLubrication::|clay::(Lubrication|lubrication|NearPairs)"),
    "values shown of the spheres (f_ID)": ("dem", r"clay::(show_spheres|sphere_action|show_bod)"),
    "added mass and torque in the DEM half": ("dem", r"clay::(push_inertial_spheres|turn_sphere)\("),
    "torque": ("cfd", r"Foam::forceModels::torque::"),
    "Magnus lift": ("cfd", r"Foam::forceModels::magnus::"),
    "Saffman lift": ("cfd", r"Foam::forceModels::saffmanMei::"),
    "added mass": ("cfd", r"Foam::forceModels::addedMass::"),
    "viscous force": ("cfd", r"Foam::forceModels::viscous::"),
    "vorticity and spin at the spheres": ("cfd", r"Foam::particleForces::evaluateMore\("),
    "diffusion smoothing": ("cfd", r"Foam::smoothingModels::diffusion::"),
    "latticeMemory": ("cfd", r"Foam::selfDisturbanceModels::latticeMemory::|Foam::disturbanceHistory::"),
    "other drag laws": ("cfd", r"Foam::dragModels::(?!ergunWenYu::)"),
    "other void fraction schemes": ("cfd", r"Foam::voidFractionModels::(?!exactOverlap::)"),
}

# with clump_drag=resistance, whose start takes longer under callgrind than all the rest: seen once, see README.md
SEEN_ONCE = ("a clump's own resistance",)

_SMALL = {"end": 0.0035, "dem_step": 2e-5, "frames": 7, "core_cells": 1, "ring_cells": 1, "layers": 6,
          "fill_height": 0.03, "rest": "no", "smoothing": "none"}
_FORCES = "pressureGradient+buoyancy"
# scene: case, values, lines that come before the fluid's
SCENES = {
    "plain": ("sphere-half", {"spheres": 60}, ""),
    "clumps": ("clump-half", {"clumps": 4, "coupling_steps": 25, "void_fraction": "divided",
                              "forces": _FORCES + "+viscous+addedMass", "smoothing": "diffusion", "drag": "Gidaspow"},
               "fix rest all rest/bed window 2e-4\n"),
    "spheres": ("sphere-half", {"spheres": 60, "forces": _FORCES + "+torque+magnus+saffmanMei+addedMass",
                                "self_disturbance": "latticeMemory"},
                "variable shown atom f_fluid[1]\n"
                "fix thermal all brownian temperature 293 seed 10007\n"
                "fix films all lubrication viscosity ${viscosity} outer 0.5 inner 1e-3\n"),
}
_COUPLED = {"dem": "LAMMPS_NS::FixCoupleFoam::send*", "cfd": "Foam::fluidSolver::march*"}


def same(text):
    return text


def prepared(name, case, values, change, script="in.liggghts"):
    """A run folder, one of whose scripts change(text) has gone over."""
    options = [x for k, v in {**_SMALL, **values}.items() for x in ("--set", f"{k}={v}")]
    outcome, folder = coupled.case(case, "zero-cost/" + name, "--no-pictures", "--dry-run", *options)
    if outcome.status != 0:
        raise Broken(f"{name}: {outcome.output.strip().splitlines()[-1:]}")
    path = os.path.join(folder, script)
    with open(path, encoding="utf-8") as f:
        before = f.read()
    text = change(before)
    if change is not same and text == before:
        raise Broken(f"{name}: nothing in {script} to change")
    with open(path, "w", encoding="utf-8") as f:
        f.write(text)
    for old in os.listdir(folder):
        if ".counts" in old:
            os.remove(os.path.join(folder, old))
    return folder


def counted(folder, words, halves):
    """Parts of each half: the last whole ones but one."""
    idle = openmpi.YIELD  # no instructions for waiting
    outcome = coupled.execute(words, 300, cwd=folder, env={**launch.Run(folder, 1, 1).environment(), **idle})
    if outcome.status != 0:
        wrong = [x for x in outcome.output.splitlines()
                 if "ERROR" in x or x.startswith(("clayFoam: ", "liggghts-clay: "))]
        raise Broken(f"{os.path.basename(folder)}: {wrong[-1:]}")
    found = {}
    for half in halves:
        parts = callgrind.parts(os.path.join(folder, half + ".counts"))
        if len(parts) < LAST + 3:
            raise Broken(f"callgrind cut the run of the {half} half into {len(parts)} parts: has a function been "
                         "renamed?")
        found[half] = parts[-LAST - 1:-1]  # the last step of a run is shown whoever may ask
    return found


def together(name):
    """Both halves of a scene."""
    case, values, lines = SCENES[name]
    fluid = "include fluid_"
    change = (lambda text: text.replace(fluid, lines + fluid)) if lines else same
    folder = prepared(name, case, values, change, "settle.liggghts")
    words = ["mpirun", "--bind-to", "none", *openmpi.CROWDED, "-np", "1",
             *callgrind.words(os.path.join(folder, "dem.counts"), _COUPLED["dem"]),
             "liggghts-clay", "-in", "in.liggghts", "-log", "DEM/log", ":", "-np", "1",
             *callgrind.words(os.path.join(folder, "cfd.counts"), _COUPLED["cfd"]), "clayFoam", "-case", "CFD"]
    return counted(folder, words, ("dem", "cfd"))


def alone(change):
    """Instructions a step of the DEM half of the plain scene alone, its script changed."""
    folder = prepared("alone-" + change.__name__, *SCENES["plain"][:2], change)
    words = ["mpirun", "-np", "1",
             *callgrind.words(os.path.join(folder, "dem.counts"), "LAMMPS_NS::Thermo::compute(int)"),
             "liggghts-clay", "-in", "in.liggghts", "-log", "DEM/log", "-var", "fluid", "alone"]
    parts = counted(folder, words, ("dem",))["dem"]
    return sum(p.total() for p in parts) / (LAST * STEPS)


def spent(found, feature):
    """(instructions, calls) an exchange within a feature's functions."""
    half, pattern = FEATURES[feature]
    parts = [p.within(pattern) for p in found[half]]
    return tuple(sum(p[k] for p in parts) / LAST for k in (0, 1))


def unused_charges(text):
    return text.replace("pair_style gran/lean model hooke/stiffness tangential history\npair_coeff * *",
                        "pair_style hybrid/overlay gran/lean model hooke/stiffness tangential history "
                        "coul/clump 0.012\npair_coeff * * gran/lean\npair_coeff * * coul/clump 0.")


def unused_bodies(text):
    return text.replace("include packing.liggghts", "fix bodies all multisphere/clump\ninclude packing.liggghts")


def run(checks):
    if not shutil.which("valgrind"):
        raise Broken("valgrind is not installed")
    plain, others = together("plain"), [together("clumps"), together("spheres")]
    for half, name in (("dem", r"(LAMMPS_NS::FixCoupleFoam|clay::push_spheres)"), ("cfd", r"Foam::particleForces::")):
        checks.at_least(f"instructions an exchange in what the scene has, {half}",
                        sum(p.within(name)[0] for p in plain[half]) / LAST, 1.0)
    for feature in FEATURES:
        instructions, calls = spent(plain, feature)
        checks.equal(f"{feature}: instructions an exchange", instructions + calls, 0.0)
        if feature in SEEN_ONCE:
            continue
        checks.at_least("the same in a scene that has it", max(spent(o, feature)[0] for o in others), 1.0)

    # what is compiled into other functions shows in the sum
    with futures.ThreadPoolExecutor(2) as pool:
        base, *unused = pool.map(alone, (same, unused_charges, unused_bodies))
    for what, found in zip(("pair coul/clump, all charges zero", "fix multisphere/clump, no body"), unused):
        checks.at_most(f"{what}: instructions a DEM step over those without", found / base, 1.05)

    sent = {}
    for half, path in (("dem", "DEM/dem.json"), ("cfd", "CFD/cfd.json")):
        with open(os.path.join(coupled.RUNS, "zero-cost", "plain", path), encoding="utf-8") as f:
            sent[half] = json.load(f)
    each = sent["dem"]["particles"] * sent["dem"]["exchanges"] * 8
    # mean velocity, other forces and touch (7) are told in every exchange: whether drag is stiff is known after it only
    for half, doubles in (("dem", 20), ("cfd", 8)):
        checks.equal(f"numbers a sphere and exchange on the wire, from the {half} half",
                     int(sent[half]["bytes_sent"] / each), doubles)
