# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of the stability map with beds: at rest, jammed, held, fed, and what they must do."""

import itertools
import math

from cases.lib.theory.flux import DragLawFlux
from validation.lib.checks import coupled, fed_column, stiff_beds
from validation.lib.checks.verdicts import Broken

ENERGY = 1e-12      # of a bed at rest over m g d a grain
MOVED = 1e-3        # of its grains off their way to Hertz's column, and of its mean height, over d
DROP = 0.01         # of a jammed or held bed off the law on the cells' own n
FED = 0.03          # of a fed one: mean velocity off the law at the cells' solid fraction, fluxes off the feed's
ABOVE = 0.03        # flux of the fluid above its feed over the feed's
MOMENTUM = 1e-10    # residual of the exchange, relative

EXCHANGES = 60      # a bed at rest has at least
FED_TIME = 6.0      # of a fed one at least [s]; it is steady after two thirds of it


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
    # grains of a fed one cross a quarter of a cell in four of theirs
    fed = {**plain, "bed": "fed", "diameter": 2 * fed_column.R, "viscosity": fed_column.VISCOSITY,
           "density_ratio": fed_column.RHO_P / fed_column.RHO}
    for x, model, overlap, scheme in itertools.product(
            (0.1, 1.0, 4.0), ("A", "B"), ("yes", "no"), ("exactOverlap", "divided")):
        found.append({**fed, "relaxations": x, "model": model, "overlap": overlap, "scheme": scheme})
    for p in found:
        if p["relaxations"] >= 100.0:  # an interval of as many DEM steps as at 10 in water
            p["viscosity"] *= 10
    return found


def exceeded(measures):
    """The bounds that a bed has left, in words; a bound whose measure is no number is left."""
    bounds = {"energy": ENERGY, "moved": MOVED, "height": MOVED, "drop_error": DROP, "velocity_error": FED,
              "solid_flux_error": FED, "fluid_flux_error": FED, "above": ABOVE, "momentum": MOMENTUM, "lost": 0}
    return [f"{key} {measures[key]:.3g} is above {most:g}" for key, most in bounds.items()
            if key in measures and not measures[key] <= most]


def feed(where, relaxations, words):
    """A column with a steady feed: what it does over what it must do."""
    step, frames = fed_column.DEM_STEP, 60
    steps = max(1, round(relaxations * fed_column.RELAXATION / step))
    end = frames * math.ceil(FED_TIME / (frames * steps * step) - 1e-9) * steps * step
    settings = {**words, "coupling_steps": steps, "end": f"{end:.12g}", "frames": frames}
    folder = coupled.finished("fed-column", where, "--no-pictures",
                              *(w for k, v in settings.items() for w in ("--set", f"{k}={v}")))
    at, said = fed_column.layers(folder), coupled.summary(folder)
    law = DragLawFlux("ergunWenYu", 2 * fed_column.R, fed_column.RHO_P, fed_column.RHO,
                      fed_column.VISCOSITY / fed_column.RHO, phi_m=0.7)
    flux = fed_column.FLUX
    return {"velocity_error": abs(float(at["v"].mean() / law.velocity(at["phi"]).mean()) - 1),
            "solid_flux_error": abs(float((at["phi"] * at["v"]).mean()) / flux - 1),
            "fluid_flux_error": abs(float(at["flow"].mean()) / flux - 1),
            "above": float(abs(at["above"]).max()) / flux,
            "momentum": said["max_momentum_residual"], "lost": said["particles_lost"], "exchanges": said["exchanges"]}


def measure(point, where):
    """Makes the run and says what the bed did."""
    words = {"model": point["model"], "overlap": point["overlap"], "void_fraction": point["scheme"]}
    x = point["relaxations"]
    if point["bed"] == "fed":
        return feed(where, x, words)
    bed = stiff_beds.Bed(point["diameter"], 1000.0 * point["density_ratio"], point["viscosity"],
                         layers=6 if point["bed"] == "rest" else 10)
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
