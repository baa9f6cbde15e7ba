# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A grain in a Bingham fluid: held below the critical yield number of Beris et al., falling above it."""

import math

from validation.lib.checks import coupled, single_sphere

TITLE = "grain in a Bingham fluid: Newtonian limit, falls, held"

_D, _MU, _LARGEST = 2e-3, 1.0, 1000.0                  # m, Pa s
_WEIGHT = 1600 * 9.81 * math.pi / 6 * _D**3            # submerged [N]
_CRITICAL = 0.143 * _WEIGHT / (2 * math.pi * (_D / 2)**2)  # yield stress that just holds it [Pa]


def _speed(name, part):
    """Last downward velocity [m/s] in a fluid of that part of the critical yield stress."""
    folder = coupled.finished("bingham-grain", f"bingham-grain/{name}", "--no-pictures",
                              "--set", f"yield_stress={part * _CRITICAL:.10g}")
    return -single_sphere.path(folder)[2][-1]


def run(checks):
    stokes = _WEIGHT / (3 * math.pi * _MU * _D)
    creep = _WEIGHT / (3 * math.pi * _LARGEST * _D)
    checks.close("no yield stress: velocity against Stokes's [m/s]", _speed("newtonian", 0.0), stokes, 0.01)
    for part in (0.5, 0.9):
        checks.close(f"{part:g} of the critical stress: velocity by the weight it leaves [m/s]",
                     _speed(f"falls-{part:g}", part), (1 - part) * stokes, 0.05)
    for part in (1.1, 2.0):
        checks.at_most(f"{part:g} of the critical stress: velocity over that of the largest viscosity",
                       _speed(f"held-{part:g}", part) / creep, 1.05)
