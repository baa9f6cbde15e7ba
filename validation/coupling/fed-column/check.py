# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Grains that come and go: a column with a steady feed, the momentum of grains and
fluid while some are inserted and deleted, one that leaves the fluid and returns."""

import json
import os

import numpy as np

from cases.lib.output import spheres
from cases.lib.theory.flux import DragLawFlux
from validation.lib.checks import coupled, plots
from validation.lib.checks.fed_column import AREA, CELL, G, R, RHO, RHO_P, layers

from .balance import drift

TITLE = "grains that come and go: a steady feed, exact momentum, out of the fluid and back"

FEED, FROM = 250.0, 0.096                # 1/s, m
CLOSED = ["bottom=cyclic", "top=cyclic", "gravity=0", "size_z=0.024", "cells_z=6", "feed_from=0.007", "feed_to=0.016",
          "feed_speed=0.2", "feed_rate=100", "viscosity=1e-3", "coupling_steps=20", "end=0.4", "frames=4000",
          "look_steps=1"]
THROWN = ["headroom=0.1", "thrown=2.5", "size_z=0.024", "cells_z=6", "viscosity=1e-3", "coupling_steps=10", "end=0.16",
          "frames=160", "look_steps=10"]


def scene(where, settings):
    return coupled.finished("fed-column", os.path.join("fed-column", where), "--no-pictures",
                            *(w for s in settings for w in ("--set", s)))


def counts(folder):
    with open(os.path.join(folder, "DEM", "dem.json"), encoding="utf-8") as f:
        return json.load(f)


def fed(checks):
    folder = scene("fed", [])
    law = DragLawFlux("ergunWenYu", 2 * R, RHO_P, RHO, 2e-5, phi_m=0.7)
    at = layers(folder)
    expected = law.velocity(at["phi"])
    flux = FEED * 4 / 3 * np.pi * R**3 / AREA
    checks.close("feed: velocity below it, mean over cells and times [m/s]", float(at["v"].mean()),
                 float(expected.mean()), 0.005)
    checks.at_most("feed: velocity in a cell against the law at its solid fraction, root mean square",
                   float(np.sqrt(((at["v"] / expected - 1)**2).mean())), 0.03)
    checks.close("feed: flux of solid below it, what comes by the area [m/s]", float((at["phi"] * at["v"]).mean()),
                 flux, 0.01)
    checks.close("feed: flux of fluid below it, upwards [m/s]", float(at["flow"].mean()), flux, 0.01)
    checks.at_most("feed: flux of fluid at the top over that", float(np.abs(at["above"]).max() / flux), 0.01)
    last, said = spheres.read(spheres.dumps(folder)[-1][1]), counts(folder)
    checks.equal("feed: spheres at the start, in the report", said["particles_at_start"], 0)
    checks.equal("feed: spheres that came, in the report", said["particles_inserted"], int(last["id"].max()))
    checks.equal("feed: spheres that were taken out, in the report", said["particles_deleted"],
                 int(last["id"].max()) - len(last["id"]))
    checks.equal("feed: spheres that left or were lost, in the report",
                 said["particles_left"] + said["particles_lost"], 0)
    checks.at_most("feed: largest residual of the ledger", coupled.summary(folder)["max_momentum_residual"], 1e-10)
    where = os.path.join(coupled.RUNS, "fed-column", "fed.png")
    order = np.argsort(at["phi"].ravel())
    checks.picture(plots.compare(where, [("cells", at["phi"].ravel()[order], at["v"].ravel()[order], "dots"),
                                         ("drag law", at["phi"].ravel()[order], expected.ravel()[order], "line")],
                                 "solid fraction of a cell", "velocity downwards [m/s]", "a column with a steady feed"))


def momentum(checks):
    folder = scene("closed", CLOSED)
    worst, came, gone = drift(folder, 6)
    checks.at_least("momentum: spheres that came", came, 40)
    checks.at_least("momentum: spheres that were deleted amid an interval", gone, 5)
    checks.at_most("momentum: drift of the sum, over what the spheres have given to the fluid", worst, 1e-9)


def thrown(checks):
    folder = scene("thrown", THROWN)
    with open(os.path.join(folder, "DEM", "steps.dump"), encoding="utf-8") as f:
        rows = [x.split() for x in f]
    z, v = (np.array([float(r[k]) for r in rows if len(r) == 7]) for k in (3, 6))
    outside = z > 0.024 + R
    first, last = np.flatnonzero(outside)[[0, -1]]
    checks.at_least("thrown out: part of the time spent outside of the fluid", float(outside.mean()), 0.2)
    checks.true("thrown out: it leaves once and returns", outside[first:last + 1].all() and not outside[-1])
    checks.close("thrown out: acceleration outside of the fluid [m/s2]",
                 float((v[last - 10] - v[first + 10]) / ((last - first - 20) * 1e-3)), -G, 1e-6)
    law = DragLawFlux("ergunWenYu", 2 * R, RHO_P, RHO, 1e-6, phi_m=0.7)
    checks.close("thrown out: velocity at which it falls through the fluid again [m/s]", -v[-1],
                 float(law.velocity(4 / 3 * np.pi * R**3 / (AREA * CELL))), 0.01)
    said = counts(folder)
    checks.equal("thrown out: spheres inserted, left, deleted, lost, beyond the fluid, in the report",
                 [said[f"particles_{k}"] for k in ("inserted", "left", "deleted", "lost", "beyond_the_fluid")], [0] * 5)
    checks.at_most("thrown out: largest residual of the ledger", coupled.summary(folder)["max_momentum_residual"],
                   1e-10)


def away(checks):
    # above the fluid lie 4 mm of the grains' box, and it flies 6 mm high
    folder = scene("away", ["headroom=0.004" if s.startswith("headroom") else s for s in THROWN])
    said = counts(folder)
    checks.equal("thrown away: spheres inserted, left, deleted, lost, there at the end, in the report",
                 [said[f"particles{k}"] for k in ("_inserted", "_left", "_deleted", "_lost", "")], [0, 1, 0, 0, 0])
    checks.equal("thrown away: spheres in the last dump", len(spheres.read(spheres.dumps(folder)[-1][1])["id"]), 0)
    checks.at_most("thrown away: largest residual of the ledger", coupled.summary(folder)["max_momentum_residual"],
                   1e-10)

    # no wall of the grains' holds it at the closed floor
    outcome, _ = coupled.case("fed-column", os.path.join("fed-column", "lost"), "--no-pictures",
                              *(w for s in [*THROWN, "thrown=0.1", "end=0.3"] for w in ("--set", s)))
    checks.true("through the floor: ends the run", outcome.status not in (0, None), outcome.status)
    checks.true("through the floor: names the sphere", "particle 1 was pushed out of the box" in outcome.output)


def run(checks):
    fed(checks)
    momentum(checks)
    thrown(checks)
    away(checks)
