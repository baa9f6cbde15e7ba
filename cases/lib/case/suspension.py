# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What a column's words stand for: water's properties, volumes, numbers."""

import math

from cases.lib.case.errors import CaseError


_MOST_SOLID = 0.6  # as solid_fraction may be set


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


def _box(values):
    """What a box's sides are to the DEM half: its boundaries, whether there are walls."""
    if (values["bottom"] == "cyclic") != (values["top"] == "cyclic"):
        raise CaseError(f"top = {values['top']}, bottom = {values['bottom']}: both must be cyclic, or neither")
    around, along = (values[k] == "cyclic" for k in ("sides", "bottom"))
    return {"around": "p" if around else "f", "along": "p" if along else "f",
            "side_walls": int(not around), "end_walls": int(not along)}


def prime(seed):
    """The prime that stands for a seed where LIGGGHTS wants one above 10000."""
    n = 10007 + 1000 * (int(seed) % 100000)
    while any(n % k == 0 for k in range(2, math.isqrt(n) + 1)):
        n += 1
    return n


def resolve(values):
    """The values that are given by a word, as numbers: words of casefile's
    entry "or"; the mass of a particle [kg]. Empty where nothing is."""
    found = {}

    def now(key):
        return found.get(key, values.get(key))

    for key, law in (("fluid_density", "density"), ("viscosity", "dynamic_viscosity")):
        if now(key) == "water":
            from cases.lib.theory import water
            found[key] = float(f"{float(getattr(water, law)(values['temperature'])):.6g}")
    if now("prototype_viscosity") == "viscosity":
        found["prototype_viscosity"] = now("viscosity")
    if now("fill_height") == "tube_height":
        found["fill_height"] = values["tube_height"]
    if "fill_height" in values and now("fill_height") > values["tube_height"]:
        raise CaseError(f"fill_height = {now('fill_height')} m: must be at most "
                        f"tube_height = {values['tube_height']} m")
    if "forces" in values:
        named = values["forces"]
        if named == "auto":
            named = "pressureGradient+buoyancy" if values["model"] == "A" else "buoyancy"
        found["force_models"] = "(" + named.replace("+", " ").replace("none", "") + ")"
    plain = values.get("mesh", "hex") == "hex"
    found["non_orthogonal"] = 0 if plain else 2
    found["grad_scheme"] = "Gauss linear" if plain else "leastSquares"  # exact where cells are skew, too
    if "size_x" in values:
        found.update(_box(values))
        found["prime"] = prime(values["seed"])
    if "sphere_radius" not in values:
        return found
    if "coulomb" in values:
        from cases.lib.theory import screening
        found["coulomb_law"], debye = values["coulomb"], screening.lengths(values)
        if debye:
            found["debye_length"] = debye[1]
            found["coulomb_law"] += f" screened {debye[1]:.12g}"
    if "attraction" in values:
        from cases.lib.theory import attraction
        resolved = {**values, **found}
        try:
            constant, law = attraction.hamaker(resolved), attraction.law(resolved)
        except ValueError as e:
            raise CaseError(str(e)) from e
        found["attracted"], found["far_forces"] = int(constant is not None), f"{found['coulomb_law']} {law}".strip()
        if constant is not None:
            found["hamaker"] = constant
    one = particle_volume(values)
    found["body_mass"] = values["density"] * one
    counted = next((k for k in ("clumps", "spheres") if k in values), None)
    if counted:
        if "tube_radius" in values:
            space = math.pi * values["tube_radius"]**2 * now("fill_height")
        else:
            space = values["size_x"] * values["size_y"] * values["size_z"]
        if values[counted] == "solid_fraction":
            if now("solid_fraction") == "solids":
                phi = solid_fraction(values["solids"], values["density"], now("fluid_density"))
                found["solid_fraction"] = phi
                if phi > _MOST_SOLID:
                    raise CaseError(f"solids = {values['solids']:.4g} %: are {phi:.3g} of the suspension by volume and "
                                    f"must be at most {_MOST_SOLID} (solids in the suspension by mass)")
            found[counted] = round(now("solid_fraction") * space / one)
            if found[counted] < 1:
                raise CaseError(f"solid_fraction = {now('solid_fraction'):.3g}: leaves no room for one particle")
        found["solid_fraction"] = now(counted) * one / space
        if found["solid_fraction"] > 1:
            raise CaseError(f"{counted} = {now(counted):.0f}: would fill {found['solid_fraction']:.3g} times their "
                            "room; take less, or more room")
    return found
