# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The column of the case fed-column: what its cells hold, read from the dumps and the fields alone."""

import numpy as np

from cases.lib.output import spheres
from validation.lib.checks import fields

R, AREA, CELL, CELLS = 5e-4, 8.16e-3**2, 4e-3, 30
RHO, RHO_P, G, VISCOSITY = 1000.0, 2600.0, 9.81, 0.02
FEED = 250.0                        # 1/s
DEM_STEP = 1e-4                     # s
RELAXATION = RHO_P * (2 * R)**2 / (18 * VISCOSITY)  # s, of one sphere in Stokes' flow
FLUX = FEED * 4 / 3 * np.pi * R**3 / AREA           # of solids below the feed, and of fluid upwards [m/s]


def cells(z, count):
    """Volume [m3] of each sphere in each cell, round a periodic height."""
    found = np.zeros((len(z), count))
    for image in (-1, 0, 1):
        edges = CELL * (np.arange(count + 1) + image * count)
        s = np.clip(edges[None, :] - z[:, None], -R, R)
        found += np.diff(np.pi * (2 / 3 * R**3 + R**2 * s - s**3 / 3), axis=1)
    return found


def layers(folder):
    """Solid fraction, mean velocity downwards of the solid and of the fluid times n [m/s], a row a frame of
    the last third, a column a cell below the feed; n U [m/s] in the topmost cell."""
    rows = {"phi": [], "v": [], "flow": [], "above": []}
    within = slice(4, 22)
    frames = spheres.dumps(folder)
    for (_, path), (_, at) in list(zip(frames, fields.times(folder)))[2 * len(frames) // 3:]:
        s = spheres.read(path)
        share = cells(s["z"], CELLS)[:, within]
        flow = fields.field(at, "U", CELLS)[:, 2] * fields.field(at, "voidfraction", CELLS)
        rows["phi"].append(share.sum(axis=0) / (AREA * CELL))
        rows["v"].append((share * -s["vz"][:, None]).sum(axis=0) / share.sum(axis=0))
        rows["flow"].append(flow[within])
        rows["above"].append(flow[-1:])
    return {k: np.array(v) for k, v in rows.items()}
