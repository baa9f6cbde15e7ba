# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Momentum of particles and fluid in a box, from what both halves have written."""

import os

import numpy as np

from cases.lib.case import openfoam
from validation.lib.checks import coupled


def momenta(folder, rho, box, cells):
    """(t [s], momentum of the particles, of the fluid, owed to it [N s]) at each output.

    rho [kg/m3]; box: its three sides [m], cut into so many equal cells. The particles' is the DEM half's
    own sum (means.csv), the fluid's is rho n U over the written fields.
    """
    particles = coupled.columns(os.path.join(folder, "DEM", "means.csv"))
    cell = np.prod(box) / cells
    rows = []
    for t, path in openfoam.times(os.path.join(folder, "CFD")):
        if not os.path.exists(os.path.join(path, "couplingImpulse")) or t == 0:
            continue
        n, U, owed = (openfoam.internal_field(os.path.join(path, f), cells)
                      for f in ("voidfraction", "U", "couplingImpulse"))
        i = int(np.argmin(np.abs(np.array(particles["t"]) - t)))
        rows.append((t, np.array([particles[k][i] for k in ("px", "py", "pz")]),
                     rho * cell * (n.reshape(-1, 1) * U.reshape(-1, 3)).sum(axis=0),
                     cell * owed.reshape(-1, 3).sum(axis=0)))
    return rows
