# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of the stability map with beds: at rest, jammed, held, and what they must do."""

import itertools

from validation.lib.checks import stiff_beds
from validation.lib.checks.verdicts import Broken

ENERGY = 1e-12      # of a bed at rest over m g d a grain
MOVED = 1e-3        # of its grains off their way to Hertz's column, and of its mean height, over d
DROP = 0.01         # of a jammed or held bed off the law on the cells' own n

EXCHANGES = 60      # a bed at rest has at least


def points():
    """What is run: state, grains, interval in relaxation times, settings."""
    plain = {"diameter": 1e-4, "viscosity": 1e-3, "density_ratio": 2.65, "scheme": "exactOverlap", "model": "A",
             "overlap": "yes"}
    found = []
    for x, model, overlap, scheme in itertools.product(
            (1.0, 10.0, 100.0), ("A", "B"), ("yes", "no"), ("exactOverlap", "divided")):
        found.append({**plain, "bed": "rest", "relaxations": x, "model": model, "overlap": overlap, "scheme": scheme})
    for ratio, x in itertools.product((0.05, 0.5), (1.0, 10.0, 100.0)):
        found.append({**plain, "bed": "rest", "relaxations": x, "density_ratio": ratio})
    for state, x in itertools.product(("jammed", "held", "frozen"), (1.0, 10.0, 100.0)):
        found.append({**plain, "bed": state, "relaxations": x})
    for p in found:
        if p["relaxations"] >= 100.0:  # an interval of as many DEM steps as at 10 in water
            p["viscosity"] *= 10
    return found


def exceeded(measures):
    """The bounds that a bed has left, in words; a bound whose measure is no number is left."""
    bounds = {"energy": ENERGY, "moved": MOVED, "height": MOVED, "drop_error": DROP}
    return [f"{key} {measures[key]:.3g} is above {most:g}" for key, most in bounds.items()
            if key in measures and not measures[key] <= most]


def measure(point, where):
    """Makes the run and says what the bed did."""
    bed = stiff_beds.Bed(point["diameter"], 1000.0 * point["density_ratio"], point["viscosity"],
                         layers=6 if point["bed"] == "rest" else 10)
    words = {"model": point["model"], "overlap": point["overlap"], "void_fraction": point["scheme"]}
    x = point["relaxations"]
    if point["bed"] == "rest":
        found = stiff_beds.rest(where, bed, x, EXCHANGES, point["density_ratio"] < 1, **words)
        return {k: found[k] for k in ("energy", "moved", "height", "exchanges")}
    held = {"jammed": 0, "held": 1, "frozen": 2}[point["bed"]]
    drop, law, _ = stiff_beds.through(where, bed, x, 2 * bed.onset(), 30, held, **words)
    return {"drop_error": abs(drop / law - 1), "exchanges": 30}


def one(point, where):
    """The run's row of the map; none of these may be refused."""
    try:
        measures = measure(point, where)
    except Broken as e:
        return {**point, "outcome": "failed", "reason": str(e)}
    left = exceeded(measures)
    return {**point, **measures, "outcome": "failed" if left else "bounded", "reason": "; ".join(left)}
