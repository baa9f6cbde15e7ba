# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The dimensionless groups of a column and of its prototype, and the viscosity
that brings the column into Stokes flow.

Eqs 14 to 16 take both to be in Stokes flow over the same distance. Where a
group is alike on both sides, or below a bound on both, it is kept.
"""

import math
from dataclasses import dataclass

from cases.lib.theory import screening
from cases.lib.theory.scaling import stokes_velocity

#: Re up to which a flow counts as Stokes flow, and that of `regime = stokes`.
STOKES, WANTED = 0.1, 0.09
#: Gravity at the prototype's [m/s2].
EARTH = 9.81
#: 1/(4 pi epsilon_0) [N m2/C2], Boltzmann's constant [J/K], the elementary charge [C].
COULOMB, BOLTZMANN, ELEMENTARY = 8.98755e9, 1.380649e-23, 1.602177e-19
_ALIKE = 0.01


@dataclass(frozen=True)
class Group:
    """A dimensionless group: of model and prototype (None: there is none), whether it is kept."""

    name: str
    model: float
    prototype: float
    kept: bool
    remark: str = ""


def reynolds(d, rho_p, rho_f, mu, g):
    """Re of a sphere that falls at its own Stokes speed."""
    return rho_f * stokes_velocity(d, rho_p, rho_f, mu, g) * d / mu


def viscosity_for(re, d, rho_p, rho_f, g):
    """Dynamic viscosity [Pa s] at which reynolds(...) is re."""
    return math.sqrt(rho_f * (rho_p - rho_f) * g * d**3 / (18.0 * re))


def buoyant_weight(d, rho_p, rho_f, g):
    """Of a sphere [N]."""
    return math.pi / 6 * d**3 * (rho_p - rho_f) * g


def groups(v):
    """The Groups of a column with values v, those that follow from them among them; [] where nothing falls."""
    d, d_p, rho_p, rho_f = 2 * v["sphere_radius"], v["prototype_diameter"], v["density"], v["fluid_density"]
    if rho_p <= rho_f or not v["gravity"]:
        return []
    kelvin = 273.15 + v["temperature"]
    sides = ((d, v["viscosity"], v["gravity"]), (d_p, v["prototype_viscosity"], EARTH))
    re = [reynolds(x, rho_p, rho_f, mu, g) for x, mu, g in sides]
    weight = [buoyant_weight(x, rho_p, rho_f, g) for x, _, g in sides]
    found = [Group("Re, a sphere at its Stokes speed", *re, max(re) <= STOKES, f"Stokes flow up to {STOKES:g}")]
    if v.get("clump_drag") == "resistance":
        part = v["body_mass"] / (rho_p * math.pi / 6 * d**3)
        found.append(Group("Re, a sphere of a clump's volume", *(part * x for x in re), part * max(re) <= STOKES,
                           "a clump's own resistance lets it fall about so"))
    found += [
        Group("density of solids over fluid", rho_p / rho_f, rho_p / rho_f, True),
        Group("relaxation over time to fall d", *(x * rho_p / rho_f / 18 for x in re),
              max(re) * rho_p / rho_f / 18 <= STOKES, f"inertia plays no part up to {STOKES:g}"),
    ]
    if v.get("charge"):
        ratio = COULOMB * v["charge"]**2 / d**2 / weight[0]
        charge = math.sqrt(ratio * weight[1] * d_p**2 / COULOMB)
        found += [
            Group("force of charges d apart over weight", ratio, ratio, True,
                  f"by definition: it gives the prototype's spheres {charge:.3g} C, {charge / ELEMENTARY:.3g} "
                  "elementary charges"),
            Group("r_c / d", v["cutoff"] / d, None, False, "the cut-off is the model's; nature has none"),
        ]
        debye = screening.lengths(v)
        found.append(Group("Debye length / d", debye[1] / d, debye[0] / d_p, True) if debye else
                     Group("Debye length / d", None, None, False,
                           "charges are not screened (salinity = none); the prototype's water has some salt"))
    found += [
        Group("H / d", v["fill_height"] / d, v["fill_height"] / d_p, abs(d_p / d - 1) <= _ALIKE,
              "Eqs 15 and 16 keep H, not H / d"),
        # the height over which Brownian motion lifts a sphere; over d it is one over a Peclet number
        Group("Brownian length / d", *(BOLTZMANN * kelvin / w / x for w, (x, _, _) in zip(weight, sides)),
              abs(d_p / d - 1) <= _ALIKE, "kT over weight; spheres of the model do not diffuse"),
    ]
    return found


def as_json(found):
    """Groups as summary.json has them."""
    return [{"group": g.name, "model": g.model, "prototype": g.prototype, "kept": g.kept, "remark": g.remark}
            for g in found]


def table(found):
    """Groups side by side, as text; the last column says what is not kept."""
    def cell(x):
        return "none" if x is None else f"{x:.4g}"

    return "\n".join([f"  {'':<40}{'model':>11}{'prototype':>11}"] + [
        f"  {g.name:<40}{cell(g.model):>11}{cell(g.prototype):>11}  {'kept' if g.kept else 'NOT KEPT'}"
        + (f": {g.remark}" if g.remark else "") for g in found])
