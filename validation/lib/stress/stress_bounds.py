# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""When a run of the stability map is bounded: limits, and what a run reached."""

import glob
import json
import math
import os

from validation.lib.stress import stress_design as design

# limits that are the same for all runs
OVERLAP = 0.5           # of two particles over the diameter: beyond it they have passed into each other
COURANT = 5.0           # of the fluid's own steps: 0.5 is kept, but not by a step in which the flow begins
MOMENTUM = 1e-8         # residual of the exchange, relative
VOLUME = 1e-9           # error of the solid volume in the cells, relative
SPEED = 3.0             # of particles over what gravity, drag, inlet, charges and springs can give
FLUID_SPEED = 5.0       # of the fluid, over the same: it flows around them


def speed_scale(scene):
    """What a particle's speed [m/s] can come to: falling through the box without
    drag, at its terminal velocity, with the inlet's jet, or pulled in by charges."""
    v = scene["values"]
    reduced = design.GRAVITY * abs(1 - design.FLUID / v["density"])
    energy = 2 * reduced * v["size_z"]
    # a pair of unlike charges from the cut-off to contact, some in reach
    spheres = 14 if v["shape"] == "clumps" else 1
    energy += 12 * spheres * design.COULOMB * v["charge"]**2 / (2 * v["sphere_radius"]) / scene["mass"]
    jet = abs(v["inlet_velocity"]) / max(0.1, 1 - min(0.9, 1.5 * scene["solids"]))
    return max(math.sqrt(energy), scene["terminal"], jet)


def exceeded(measures, scene):
    """The bounds a run has left, in words; empty when it is bounded."""
    scale = speed_scale(scene)
    found = []
    for name, value, most in (
            ("overlap/d", measures["overlap_over_d"], OVERLAP), ("Courant number", measures["courant"], COURANT),
            ("momentum residual", measures["momentum"], MOMENTUM),
            ("void fraction volume error", measures["volume_error"], VOLUME),
            ("particle speed [m/s]", measures["fastest"], SPEED * scale),
            ("fluid speed [m/s]", measures["fluid"], FLUID_SPEED * scale)):
        if not math.isfinite(value):
            found.append(f"{name} is NaN or infinite")
        elif value > most:
            found.append(f"{name} {value:.3g} is above {most:.3g}")
    low, high = measures["void_fraction"]
    if not (0 < low and high <= 1 + 1e-9):
        found.append(f"void fraction {low:.3g} to {high:.3g} is not within 0 and 1")
    if measures["lost"]:
        found.append(f"{measures['lost']} spheres were lost")
    return found


def measure(folder, openfoam):
    """What a run that came to its end has reached; openfoam: the reader of fields."""
    with open(os.path.join(folder, "DEM", "dem.json"), encoding="utf-8") as f:
        dem = json.load(f)
    with open(os.path.join(folder, "CFD", "cfd.json"), encoding="utf-8") as f:
        cfd = json.load(f)
    with open(os.path.join(folder, "DEM", "fastest.txt"), encoding="utf-8") as f:
        rows = [[float(x) for x in line.split()] for line in f.readlines()[1:]]
    fluid, low, high = 0.0, math.inf, -math.inf
    for time, place in openfoam.times(os.path.join(folder, "CFD")):
        if time == 0:
            continue
        cells = int(cfd["settings"]["meshCells"])
        u = openfoam.internal_field(os.path.join(place, "U"), cells)
        # max() of numbers passes over what is none
        fluid = max(fluid, float((u**2).sum(axis=1).max()**0.5)) if math.isfinite(u.sum()) else math.nan
        for name in glob.glob(os.path.join(place, "voidfraction")):
            n = openfoam.internal_field(name, cells)
            low, high = min(low, float(n.min())), max(high, float(n.max()))
    fastest = [r[2] for r in rows]
    return {"overlap_over_d": dem["max_overlap_over_d"], "courant": cfd["courant_max"],
            "momentum": cfd["max_momentum_residual"], "volume_error": cfd["max_void_fraction_volume_error"],
            "fastest": max(fastest) if all(map(math.isfinite, fastest)) else math.nan, "fluid": fluid,
            "void_fraction": [low, high], "lost": dem["particles_lost"], "reynolds": cfd["reynolds_max"],
            "cells_crossed": cfd["cells_crossed_max"], "drag_change": cfd["drag_change_mean"],
            "relaxations": cfd["interval_over_relaxation_max"], "wall_overlap": dem.get("max_wall_overlap_over_d"),
            "warnings": dem["warnings"] + cfd["warnings"]}
