# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Van der Waals forces of a model whose spheres are larger than the prototype's.

By the similarity lengths go with the spheres' diameter and forces with their
buoyant weight, so that Hamaker's constant goes with both.
"""

from cases.lib.theory import similarity

#: Characteristic wave length of dispersion forces [m], Gregory's.
WAVE = 1e-7
#: Over a sphere's diameter: gap below which the force stays, largest gap.
CONTACT, GAP = 0.02, 1.0


def _ratios(v):
    """Lengths and weights of the model's spheres over those of the prototype's;
    throws ValueError where there is no weight."""
    d, d_p = 2 * v["sphere_radius"], v["prototype_diameter"]
    weights = [similarity.buoyant_weight(x, v["density"], v["fluid_density"], g)
               for x, g in ((d, v["gravity"]), (d_p, similarity.EARTH))]
    if weights[0] <= 0:
        raise ValueError(f"attraction = {v['attraction']:g} J: forces are scaled by weights, and the model's spheres "
                         f"have none with gravity = {v['gravity']:g} m/s2, density = {v['density']:g} kg/m3; "
                         "attraction = none leaves it out")
    return d / d_p, weights[0] / weights[1]


def hamaker(v):
    """Hamaker's constant at the model's scale [J]; None without attraction."""
    if v.get("attraction", "none") == "none":
        return None
    lengths, weights = _ratios(v)
    return lengths * weights * v["attraction"]


def law(v):
    """The words of pair_style dlvo/clump, without double layers; "" without attraction."""
    constant = hamaker(v)
    if constant is None:
        return ""
    d = 2 * v["sphere_radius"]
    return (f"dlvo/clump {GAP * d:.12g} debye {d:.12g} hamaker {constant:.12g} contact {CONTACT * d:.12g} "
            f"retarded {_ratios(v)[0] * WAVE:.12g} every {v['coulomb_steps']:.0f} hold")


def in_contact(v):
    """Pull of two equal spheres at gaps up to the contact distance, over their weight."""
    d, constant = 2 * v["sphere_radius"], hamaker(v)
    h = CONTACT * d
    pull = constant * d / 4 / (6 * h * h) / (1 + 5.32 * h / (_ratios(v)[0] * WAVE))
    return pull / similarity.buoyant_weight(d, v["density"], v["fluid_density"], v["gravity"])


def line(v):
    """What a case's attraction means, in a line; "" without."""
    constant = hamaker(v)
    if constant is None:
        return ""
    return (f"attraction {v['attraction']:.4g} J: at the model's scale {constant:.4g} J; spheres within "
            f"{2e3 * CONTACT * v['sphere_radius']:.4g} mm pull each other with {in_contact(v):.4g} times their weight")
