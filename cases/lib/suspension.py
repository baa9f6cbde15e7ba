# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What a column's words stand for: water's properties, volumes, numbers."""

import math
import os
import sys

from casefile import TOP, CaseError


def theory():
    """The package of formulas, validation/theory."""
    folder = os.path.join(TOP, "validation")
    if folder not in sys.path:
        sys.path.insert(0, folder)
    import theory as package
    return package


def solid_fraction(solids, density, fluid_density):
    """Solids by volume, of a suspension with so many percent by mass."""
    w = 0.01 * solids
    return w / density / (w / density + (1 - w) / fluid_density)


def particle_volume(v):
    """Volume [m3] of a sphere, or of a clump of two layers of seven."""
    r = v["sphere_radius"]
    sphere = 4 / 3 * math.pi * r**3
    if "clumps" not in v:
        return sphere
    # only a sphere and the one of the other layer above it overlap
    gap = v["layer_spacing"]
    lens = math.pi * (4 * r + gap) * (2 * r - gap)**2 / 12 if gap < 2 * r else 0.0
    return 14 * sphere - (7 * lens if v["volume"] == "union" else 0.0)


def resolve(values):
    """The values that are given by a word, as numbers: words of casefile's
    entry "or"; the mass of a particle [kg]. Empty where nothing is."""
    found = {}

    def now(key):
        return found.get(key, values.get(key))

    for key, law in (("fluid_density", "density"), ("viscosity", "dynamic_viscosity")):
        if now(key) == "water":
            theory()
            from theory import water
            found[key] = float(f"{float(getattr(water, law)(values['temperature'])):.6g}")
    if now("fill_height") == "tube_height":
        found["fill_height"] = values["tube_height"]
    if "fill_height" in values and now("fill_height") > values["tube_height"]:
        raise CaseError(f"fill_height = {now('fill_height')} m: at most tube_height = {values['tube_height']} m is wanted")
    counted = next((k for k in ("clumps", "spheres") if k in values), None)
    if counted:
        space = math.pi * values["tube_radius"]**2 * now("fill_height")
        one = particle_volume(values)
        if values[counted] == "solid_fraction":
            if now("solid_fraction") == "solids":
                found["solid_fraction"] = solid_fraction(values["solids"], values["density"], now("fluid_density"))
            found[counted] = round(now("solid_fraction") * space / one)
            if found[counted] < 1:
                raise CaseError(f"solid_fraction = {now('solid_fraction'):.3g}: leaves no room for one particle")
        found["solid_fraction"] = now(counted) * one / space
        found["body_mass"] = values["density"] * one
    return found
