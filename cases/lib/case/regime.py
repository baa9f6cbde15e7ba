# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""regime = stokes: what a column needs to settle in Stokes flow.

The viscosity is that at which a sphere at its own Stokes speed has Re 0.09; all
charges, weights and sizes stay, and so does the ratio of charge to weight. What
falls slower may meet in softer contacts, with longer steps.
"""

import math

from cases.lib.case import suspension
from cases.lib.case.errors import CaseError
from cases.lib.theory import similarity
from cases.lib.theory.scaling import stokes_velocity

_RELAXATION = 0.5   # of a sphere's relaxation time, an exchange at least so often
_CELL = 0.1         # of a cell's height, a sphere's way in an exchange
_LOAD = 0.005       # of d, overlap under a bed's mean load
_PULL = 0.02        # of d, under the pull of a clump's face of seven on the ten net charges of another, 2.5 d away
_FACE = 7 * 10 / 2.5**2


def _down(x):
    """The largest of 1, 2, 5 times a power of ten up to x."""
    power = 10.0**math.floor(math.log10(x) + 1e-9)
    return float(f"{max(k for k in (1, 2, 5) if k * power <= x * (1 + 1e-9)) * power:.3g}")


def _stiffness(v, stokes):
    """Contact stiffness [N/m] at which impacts at the Stokes speed make no larger overlaps than the case's own do in
    its fluid, the bed's weight none above _LOAD, and charges none above _PULL."""
    from cases.lib.theory import drag  # numpy: lists of cases and keys go without it

    d = 2 * v["sphere_radius"]
    fast = drag.terminal_velocity(d, v["density"], v["fluid_density"], v["viscosity"], v["gravity"])
    load = (v["density"] - v["fluid_density"]) * v["gravity"] * v["solid_fraction"] * v["fill_height"] * d**2
    pull = similarity.COULOMB * v.get("charge", 0.0)**2 / d**2
    wanted = max(v["stiffness"] * (stokes / fast)**2, load / (_LOAD * d), _FACE * pull / (_PULL * d))
    return min(v["stiffness"], float(f"{wanted:.2g}"))


def values(case, given):
    """What regime = stokes makes of a case's values, {key: number}; {} with another regime. Keys of `given` stay."""
    if given.get("regime") != "stokes":
        return {}
    if "viscosity" in given:
        raise CaseError(f"viscosity = {given['viscosity']}: regime = stokes sets it; set one of the two")
    v = {**case.values, **suspension.resolve(case.values)}
    if v["density"] <= v["fluid_density"] or not v["gravity"]:
        raise CaseError(f"regime = stokes: nothing falls with density = {v['density']:g}, "
                        f"fluid_density = {v['fluid_density']:g} kg/m3, gravity = {v['gravity']:g} m/s2")
    own = {k: before for k, (before, _) in case.changed().items()}
    d, rho_p, rho_f, g = 2 * v["sphere_radius"], v["density"], v["fluid_density"], v["gravity"]
    mu = float(f"{similarity.viscosity_for(similarity.WANTED, d, rho_p, rho_f, g):.4g}")
    most = case.parameters["viscosity"]["max"]
    if mu > most:
        raise CaseError(f"regime = stokes: spheres of {d:g} m need viscosity = {mu:g} Pa s, which may be at most "
                        f"{most:g}; take smaller spheres or less gravity")
    if mu <= v["viscosity"]:  # Stokes flow already
        return {}
    stokes = stokes_velocity(d, rho_p, rho_f, mu, g)
    found = {"viscosity": mu}
    if v["prototype_viscosity"] == v["viscosity"]:
        found["prototype_viscosity"] = v["viscosity"]
    prototype = stokes_velocity(v["prototype_diameter"], rho_p, rho_f, v["prototype_viscosity"], similarity.EARTH)
    found["time_scale"] = float(f"{stokes / prototype:.4g}")
    found["stiffness"] = float(given.get("stiffness", _stiffness(v, stokes)))
    interval = _down(min(_RELAXATION * rho_p * d**2 / (18 * mu), _CELL * v["tube_height"] / v["layers"] / stokes))
    # the limit of the step of a case's contacts goes with the root of their stiffness
    longest = own.get("dem_step", v["dem_step"]) * math.sqrt(own.get("stiffness", v["stiffness"]) / found["stiffness"])
    found["coupling_steps"] = math.ceil(interval / longest - 1e-9)
    if "dem_step" in given:
        found["coupling_steps"] = max(1, math.floor(interval / float(given["dem_step"]) + 1e-9))
    found["dem_step"] = float(f"{interval / found['coupling_steps']:.12g}")
    if "coulomb_steps" in v:
        exchange = v["coupling_steps"] if "coupling_steps" in given else found["coupling_steps"]
        found["coulomb_steps"] = min(v["coulomb_steps"], exchange)
    return {k: x for k, x in found.items() if k not in given}
