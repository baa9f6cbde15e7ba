# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The study's columns: a small one of charged clumps in Stokes flow, and what is changed of it, one thing at a time."""

CASE = "clump-half"
#: 32 clumps in a tube of 25 mm, 60 mm high.
BASE = {"regime": "stokes", "tube_radius": "0.0125", "tube_height": "0.06", "solids": "15", "end": "16"}

#: {name: (what it is, changes)}
ROWS = {
    "stokes": ("Stokes flow, as the others but for what they say", {}),
    "water": ("in water, Re 640", {"regime": "water", "end": "2"}),
    "resistance": ("a clump's own resistance in place of its spheres' sum", {"clump_drag": "resistance", "end": "6"}),
    "height": ("twice as high, 120 mm", {"tube_height": "0.12", "end": "32"}),
    "half-charge": ("half the charge", {"charge": "1.965e-10"}),
    "no-charge": ("no charges", {"charge": "0"}),
    "cutoff": ("charges cut at 6 mm in place of 12", {"cutoff": "0.006"}),
    "salt": ("1e-6 mol/l of salt: Debye length 0.3 mm", {"salinity": "1e-6"}),
    "solids": ("7 % solids by mass in place of 15", {"solids": "7"}),
    "spacing": ("layers of a clump 2 mm apart in place of 1", {"layer_spacing": "0.002"}),
    "wide": ("the paper's half-size tube, 135 clumps, 150 mm high",
             {"tube_radius": "0.01625", "tube_height": "0.15", "end": "40"}),
    "long-range": ("charges cut at 18 mm in place of 12", {"cutoff": "0.018"}),
}


def changes(name, seed):
    """What is set of the case for a row and a packing."""
    return {**BASE, **ROWS[name][1], "seed": str(seed)}
