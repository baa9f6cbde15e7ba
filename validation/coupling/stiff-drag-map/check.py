# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The map behind stiff-drag: grains of all sizes, more intervals and settings, and
beds of light grains with added mass."""

import itertools

from validation.lib.checks import rooms, stiff_beds
from validation.lib.checks.stiff_beds import Bed

TITLE = "stiff drag: a map of beds at rest, jammed and held, 1 um to 1 mm"
LONG = True

ADDED = "pressureGradient+buoyancy+addedMass"


def beds():
    """Name, bed, relaxation times an interval, light, settings."""
    for d, viscosity, times in ((1e-6, 1e-4, (0.1, 1, 10, 100, 1000)), (1e-5, 1e-3, (0.1, 1, 10, 100, 1000)),
                                (1e-4, 1e-3, (0.1, 1, 10, 100, 1000, 5000)), (1e-3, 1e-3, (0.1, 1, 10)),
                                (1e-3, 1.0, (1, 30, 1000))):
        for x in times:
            yield f"{d * 1e6:g} um, {viscosity:g} Pa s, {x:g}", Bed(d, viscosity=viscosity), x, False, {}
    for overlap, model, scheme, forces in itertools.product(
            ("yes", "no"), ("A", "B"), ("exactOverlap", "divided", "centre"), (False, True)):
        words = {"overlap": overlap, "model": model, "void_fraction": scheme}
        if forces:
            words["forces"] = ADDED if model == "A" else "buoyancy+addedMass"
        for x in (1, 10, 100):
            name = f"100 um, {x}, overlap {overlap}, model {model}, {scheme}{', added mass' if forces else ''}"
            yield name, Bed(1e-4), x, False, words
    for ratio, forces, x in itertools.product((0.05, 0.5), ("auto", ADDED), (1, 10, 100)):
        name = f"100 um, density ratio {ratio}, {x}{', added mass' if forces == ADDED else ''}"
        yield name, Bed(1e-4, 1000 * ratio), x, True, {"forces": forces}
    for x in (1, 10, 31, 100):
        yield f"10 um, 8 grains across, {x}", Bed(1e-5, across=8), x, False, {}


def run(checks):
    short = rooms.load("stiff-drag")
    for name, bed, x, light, more in beds():
        short.rest(checks, name, bed, x, light, more)
    for d, speeds in ((1e-5, ((1, 40), (10, 20), (100, 20), (1000, 20))), (1e-4, ((1, 20), (100, 20), (1000, 20)))):
        bed = Bed(d, layers=10)
        short.flows(checks, f"jammed, {d * 1e6:g} um", bed, 0, speeds, f"stiff-drag-map/jammed-{d:g}")
        short.flows(checks, f"frozen, {d * 1e6:g} um", bed, 2, ((5, 30), (100, 30), (1000, 30)),
                    f"stiff-drag-map/frozen-{d:g}")
    short.falls(checks, 0.3, 100)
    short.falls(checks, 0.5, 10)
    heights = []
    for x in (0.3, 1, 10, 30):
        height, crossed = stiff_beds.fluidised(f"stiff-drag-map/fluidised-{x:g}", x)
        checks.at_most(f"fluidised, {x:g} relaxation times: cells crossed in an interval", crossed, 0.3)
        heights.append(height)
        checks.close(f"the same: mean height over d, that of {0.3:g}", height, heights[0], 0.03)
