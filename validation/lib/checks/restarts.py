# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A run of 2 T against one that stopped at T and went on, by feature."""

import os
import shutil

from cases.lib.case.casefile import TOP
from validation.lib.checks import coupled, saved_states
from validation.lib.checks.verdicts import Broken

# by name: case, T in intervals of the coupling, settings
FEATURES = {
    "spheres": ("restart-scene", 20, ()),
    "stiff drag": ("restart-scene", 20, ("viscosity=0.5",)),
    "added mass": ("restart-scene", 20, ("forces=pressureGradient+buoyancy+addedMass",)),
    "lubrication": ("restart-scene", 20, ("extra=films",)),
    "Brownian": ("restart-scene", 20, ("extra=thermal",)),
    "gravity that changes": ("restart-scene", 20, ("extra=swing", "viscosity=0.5")),
    "charged clumps": ("clump-half", 10, ("clumps=4",)),
    "resistance drag": ("clump-half", 10, ("clumps=4", "clump_drag=resistance")),
    "inlet ramp": ("fluidised-bed", 20, ("settle=0.02", "hold=0.001", "ramp=0.004")),
    "diffusion smoothing": ("restart-scene", 20, ("smoothing=diffusion",)),
    # one comes in each interval, those of before are taken out
    "fed column": ("fed-column", 100, ("bottom=cyclic", "top=cyclic", "gravity=0", "size_z=0.024", "cells_z=6",
                                       "feed_from=0.007", "feed_to=0.016", "feed_speed=0.2", "feed_rate=500",
                                       "viscosity=1e-3", "coupling_steps=20")),
    "turbulence": ("restart-turbulence", 20, ()),
    "bed at rest": ("restart-scene", 400, ("extra=rest", "layers=1", "speed=0")),
}
# LIGGGHTS makes the places of a body's spheres anew when it reads it: to rounding
BODIES = {"charged clumps", "resistance drag"}


def _run(name, where, *words):
    outcome, folder = coupled.case(name, where, "--no-pictures", *words, limit=900)
    if outcome.status not in (0, 3):
        said = [x for x in outcome.output.splitlines() if x.strip()]
        raise Broken(f"the run in {where} ended with {outcome.status}: {said[-1] if said else ''}")
    return folder


def go_on(name, folder, *words):
    """cases/run --continue in that folder; gives what it said."""
    program = os.path.join(TOP, "cases", "run")
    given = [program, "--no-setup", name, "--out", folder, "--continue", "--no-pictures", *words]
    outcome = coupled.execute(given, 900)
    if outcome.status not in (0, 3):
        said = [x for x in outcome.output.splitlines() if x.strip()]
        raise Broken(f"{folder}: --continue ended with {outcome.status}: {said[-1] if said else ''}")
    return outcome.output


def settings(feature):
    """Case, T in DEM steps, end of 2 T [s], the words of --set."""
    from cases.lib.case import settings as values
    from cases.lib.case.casefile import Case
    name, intervals, changes = FEATURES[feature]
    case = Case(name)
    values.apply(case, values.read(list(changes)))
    steps = intervals * int(case.values["coupling_steps"])
    words = [w for change in (*changes, f"checkpoint_steps={steps}") for w in ("--set", change)]
    return name, steps, case.values["dem_step"], words


def _output(parts):
    return ("--set", f"frames={2 * parts}", "--set", f"curve_rows={200 * parts}")


def compare(feature, where, ranks=(), other_ranks=()):
    """2 T in one run that saves at T, and T with another T: how far they are apart."""
    name, steps, dt, words = settings(feature)
    # output at the same steps in both
    whole = _run(name, f"{where}/whole", "--end", f"{2 * steps * dt:.12g}", *words, *_output(2), *ranks)
    parts = _run(name, f"{where}/parts", "--end", f"{steps * dt:.12g}", *words, *_output(1), *ranks)
    said = go_on(name, parts, "--end", f"{2 * steps * dt:.12g}", *other_ranks)
    found = saved_states.differences(saved_states.last(whole), saved_states.last(parts))
    found.update(whole=whole, parts=parts, said=said)
    return found


def clear(where):
    shutil.rmtree(os.path.join(coupled.RUNS, where), ignore_errors=True)
