# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Beds whose drag is stiff for the coupling interval, at rest, jammed, held; suspensions; clumps."""

from validation.lib.checks import stiff_beds
from validation.lib.checks.stiff_beds import Bed
from validation.lib.stress import stiff_clumps

TITLE = "stiff drag on grains that something holds: rest, jammed and held beds at any interval"

ADDED = "pressureGradient+buoyancy+addedMass"
# name: bed, relaxation times an interval, light, settings
RESTS = {
    "0.1 mm, 1": (Bed(1e-4), 1, False, {}),
    "0.1 mm, 10": (Bed(1e-4), 10, False, {}),
    "0.1 mm in a fluid of 10 mPa s, 100": (Bed(1e-4, viscosity=1e-2), 100, False, {}),
    "0.1 mm, 10, overlap no": (Bed(1e-4), 10, False, {"overlap": "no"}),
    "0.1 mm, 10, model B": (Bed(1e-4), 10, False, {"model": "B"}),
    "0.1 mm, 10, divided": (Bed(1e-4), 10, False, {"void_fraction": "divided"}),
    "0.1 mm, 10, centre": (Bed(1e-4), 10, False, {"void_fraction": "centre"}),
    "0.1 mm, 10, added mass": (Bed(1e-4), 10, False, {"forces": ADDED}),
    "1 mm, 0.1, by half a period of the column's": (Bed(1e-3), 0.1, False, {}),
    "1 mm in a fluid of 1 Pa s, 30, on springs that creep": (Bed(1e-3, viscosity=1.0), 30, False, {}),
    "0.1 mm, half as dense as the fluid, 10": (Bed(1e-4, 500.0), 10, True, {}),
    "0.1 mm, a twentieth as dense, 10": (Bed(1e-4, 50.0), 10, True, {}),
}


def rest(checks, name, bed, relaxations, light, more):
    """The three gates of a bed at rest."""
    where = "stiff-drag/rest-" + name.replace(" ", "-").replace(",", "").replace("'", "")
    found = stiff_beds.rest(where, bed, relaxations, exchanges=60, light=light, **more)
    checks.at_most(f"at rest, {name}: kinetic energy over m g d a grain", found["energy"], 1e-12)
    checks.at_most("the same: a grain off its way to Hertz's column, over d", found["moved"], 1e-3)
    checks.at_most("the same: mean height off it, over d", found["height"], 1e-3)


def flows(checks, name, bed, held, intervals, where):
    """Drops through a bed by interval, against the law on the cells' own n and U,
    and their spread."""
    speed, drops = 2 * bed.onset(), []
    for relaxations, count in intervals:
        drop, law, _ = stiff_beds.through(f"{where}-{relaxations:g}", bed, relaxations, speed, count, held)
        checks.close(f"{name}, {relaxations:g} relaxation times: drop [m2/s2]", drop, law, 0.01)
        drops.append(drop)
    checks.at_most(f"{name}: spread of the drop over the intervals", (max(drops) - min(drops)) / min(drops), 5e-3)


def falls(checks, solids, relaxations):
    """A free suspension: the law's hindered velocity, without net flux."""
    found, law, net = stiff_beds.suspension(f"stiff-drag/falls-{solids:g}-{relaxations}", solids, relaxations)
    name = f"free, solid fraction {solids:g}, {relaxations} relaxation times"
    checks.close(f"{name}: velocity [m/s]", found, law, 0.02)
    checks.at_most(f"{name}: net volume flux over it", abs(net / law), 0.02)


def clumps(checks, model, cell, steps):
    """Free clumps fall at one speed, whatever the interval."""
    where = f"stiff-drag/clumps-{model}-{cell:g}"
    free, _ = stiff_clumps.velocity(f"{where}-1", 1, model=model, cell=cell)
    for every in steps:
        found, relaxations = stiff_clumps.velocity(f"{where}-{every}", every, model=model, cell=cell)
        name = f"free clumps, model {model}, cells of {cell:g} d, {relaxations:.2g} relaxation times"
        checks.close(f"{name}: velocity [m/s]", found, free, 0.05)


def run(checks):
    for name, (bed, relaxations, light, more) in RESTS.items():
        rest(checks, name, bed, relaxations, light, more)
    bed = Bed(1e-4, layers=10)
    flows(checks, "jammed", bed, 0, ((0.1, 124), (1, 20), (10, 20)), "stiff-drag/jammed")
    bed = Bed(1e-4, viscosity=1e-2, layers=10)
    flows(checks, "no fix moves it", bed, 1, ((5, 30), (100, 30)), "stiff-drag/held")
    flows(checks, "frozen", bed, 2, ((5, 30), (100, 30)), "stiff-drag/frozen")
    falls(checks, 0.3, 10)
    falls(checks, 0.5, 100)
    clumps(checks, "A", 2.4, (50, 250))
    clumps(checks, "A", 5.0, (250,))
    clumps(checks, "B", 5.0, (250,))
