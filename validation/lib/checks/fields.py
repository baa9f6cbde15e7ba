# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The fields a run wrote, by the reader of cases/lib."""

import os

import numpy as np

from cases.lib.case import openfoam


def times(folder):
    """The output times of a run folder's fluid, (seconds, folder), in order."""
    return openfoam.times(os.path.join(folder, "CFD"))


def centres(folder):
    """The cells' centres [m]."""
    return openfoam.cell_centres(os.path.join(folder, "CFD", "constant", "polyMesh"))


def field(at, name, cells):
    """A field of an output folder: one row a cell, (cells,) or (cells, 3)."""
    return np.squeeze(openfoam.internal_field(os.path.join(at, name), cells), axis=None) \
        if cells == 1 else _flat(openfoam.internal_field(os.path.join(at, name), cells))


def _flat(values):
    return values[:, 0] if values.shape[1] == 1 else values


def inlet(folder):
    """Time [s], kinematic pressure [m2/s2] and upward velocity [m/s] at the inlet
    of a bed, as its function object wrote them."""
    path = os.path.join(folder, "CFD", "postProcessing", "inlet", "0", "surfaceFieldValue.dat")
    with open(path, encoding="utf-8") as f:
        rows = [x.replace("(", " ").replace(")", " ").split() for x in f if not x.startswith("#")]
    table = np.array(rows, dtype=float)
    return table[:, 0], table[:, 1], table[:, 4]
