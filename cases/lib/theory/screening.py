# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Debye length of salt water, and of a model whose spheres are larger than the
prototype's.

By the similarity all lengths about a sphere go with its diameter, the Debye
length too.
"""

import math
import re


def debye_length(salinity):
    """Debye length [m] of a 1:1 salt of so many mol/l in water at 25 C:
    0.304 nm over the root of it."""
    return 0.304e-9 / math.sqrt(salinity)


def lengths(values):
    """Debye lengths [m] of prototype and model and their ratio, of a case's
    values; None without salinity."""
    if values.get("salinity", "none") == "none":
        return None
    ratio = 2 * values["sphere_radius"] / values["prototype_diameter"]
    prototype = debye_length(values["salinity"])
    return prototype, ratio * prototype, ratio


def left_at_contact(radius, debye):
    """Part of Coulomb's force that is left between two spheres of a radius [m] that touch: the ions
    stay outside of them."""
    return (1 + 2 * radius / debye) / (1 + radius / debye)**2


def line(values):
    """What a case's salinity means, in a line; "" without."""
    found = lengths(values)
    if not found:
        return ""
    prototype, model, ratio = found
    part = left_at_contact(values["sphere_radius"], model)
    return (f"salinity {values['salinity']:.4g} mol/l: Debye length {1e9 * prototype:.4g} nm, at the model's scale "
            f"{1e3 * model:.4g} mm ({ratio:.4g} times); spheres in contact keep {part:.3g} of Coulomb's force")


def of_scripts(values, scripts):
    """Plain words, a list, on LIGGGHTS scripts (name: text) whose pair dlvo/clump has another
    Debye length than the salinity gives."""
    found = lengths(values)
    said = []
    for name, words in sorted(scripts.items()) if found else ():
        for style in re.findall(r"^[^#\n]*dlvo/clump\s+\S+[^\n]*", re.sub(r"&\s*\n", " ", words), re.M):
            if style.startswith("pair_style") and "debye ${debye_length}" not in " ".join(style.split()):
                said.append(f"{name}: pair dlvo/clump has a Debye length of its own, salinity's is "
                            f"{found[1]:.4g} m: 'debye ${{debye_length}}' there takes it")
    return said


def warnings(values, overlap):
    """Plain words, a list, where spheres overlap, over d, by more than a fifth
    of the Debye length."""
    found = lengths(values)
    if not found or overlap is None:
        return []
    deep, model = 2 * values["sphere_radius"] * overlap, found[1]
    if deep <= 0.2 * model:
        return []
    return [f"spheres overlap by {1e3 * deep:.3g} mm, more than a fifth of the Debye length, {1e3 * model:.3g} mm: "
            "their charges' force in contact is that of a wrong distance; a higher stiffness makes overlaps smaller"]
