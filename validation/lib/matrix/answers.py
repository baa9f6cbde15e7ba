# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What a run of the matrix came to, and how far two of them are apart."""

import json
import os
import re

import numpy as np

from cases.lib.case import openfoam
from cases.lib.output import spheres
from validation.lib.checks.verdicts import Broken
from validation.lib.matrix import scene

_PERIOD = 8e-3  # of x [m]
# what fix couple/foam shows of a sphere, and its columns
_SHOWN = (("fluid's force", 1, 3), ("drag", 4, 6), ("fluid's velocity", 7, 9), ("void fraction shown", 10, 10))


def read(folder, row):
    """The end of a run: arrays by name, and its counts."""
    dumps = [spheres.read(path) for _, path in spheres.dumps(folder)]
    found = _grains(dumps[-1])
    case = os.path.join(folder, "CFD")
    if row["cfd"] == 1:
        parts = [(case, None)]
    else:
        parts = [(os.path.join(case, f"processor{n}"), n) for n in range(row["cfd"])]
    cells = scene.CELLS[0]*scene.CELLS[1]*scene.CELLS[2]
    for name, width in (("U", 3), ("p", 1), ("voidfraction", 1), ("couplingImpulse", 3)):
        whole = np.full((cells, width), np.nan)
        for place, rank in parts:
            where = np.arange(cells)
            if rank is not None:
                where = _labels(os.path.join(place, "constant", "polyMesh", "cellProcAddressing"))
            last = openfoam.times(place)[-1][1]
            whole[where] = openfoam.internal_field(os.path.join(last, name), len(where))
        found[name] = whole
    with open(os.path.join(folder, "DEM", "dem.json"), encoding="utf-8") as f:
        dem = json.load(f)
    with open(os.path.join(case, "cfd.json"), encoding="utf-8") as f:
        cfd = json.load(f)
    counts = {"overlap": max(dem["max_overlap_over_d"], dem["max_wall_overlap_over_d"]),
              "lost": dem["particles_lost"],
              "exchanges": dem["exchanges"] - 1, "particles": dem["particles"],
              "residual": cfd["max_momentum_residual"],
              "elsewhere": _elsewhere(dumps[0], dumps[-1]),
              "fluid steps": cfd["cfd_steps"], "mapped": cfd["particles_mapped"]}
    return found, counts


def _elsewhere(start, end):
    """Spheres that are not where the cuts of scene.py want them: layers above their
    level at the start, below it at the end, and never above that of the empty rank."""
    level = {cut: scene.SIDE*k for cut, (k, _) in scene.CUTS.items()}
    upper = dict(zip(start["id"], start["z"] > level["spread"]))
    count = 0
    for dump, side in ((start, 1), (end, -1)):
        for tag, z, r in zip(dump["id"], dump["z"], dump["radius"]):
            border = level["emptying" if upper[tag] else "filling"]
            count += side*(z - border) < r or z + r > level["empty"]
    return int(count)


def _grains(dump):
    """Motion of each sphere; the force on each grain, since a body's is what counts."""
    order = np.argsort(dump["id"])
    dump = {k: v[order] for k, v in dump.items()}
    body = dump.get("mol", np.full(len(order), -1.0))
    grain = np.where(body < 0, -dump["id"], body)
    _, index = np.unique(grain, return_inverse=True)

    def vectors(*names):
        return np.column_stack([dump[n] for n in names])
    force = np.zeros((index.max() + 1, 3))
    np.add.at(force, index, vectors("fx", "fy", "fz"))
    found = {"position": vectors("x", "y", "z"), "velocity": vectors("vx", "vy", "vz"),
             "spin": vectors("omegax", "omegay", "omegaz"), "force": force}
    if "f_fluid[1]" in dump:
        for name, first, last in _SHOWN:
            found[name] = vectors(*(f"f_fluid[{k}]" for k in range(first, last + 1)))
    return found


def _labels(path):
    with open(path, encoding="utf-8") as f:
        text = f.read()
    return np.array(re.search(r"\n\d+\s*\(([\d\s]*)\)", text).group(1).split(), dtype=int)


def apart(one, other):
    """The largest difference of each quantity over its largest value; inf where it is no number."""
    found = {}
    for name, reference in one.items():
        if other[name].shape != reference.shape:
            raise Broken(f"{name}: {other[name].shape} in place of {reference.shape} values")
        difference = other[name] - reference
        if name == "position":
            difference[:, 0] -= _PERIOD*np.round(difference[:, 0]/_PERIOD)
        scale = np.max(np.abs(reference))
        worst = np.max(np.abs(difference))
        found[name] = float(worst/scale if scale > 0 else (0.0 if worst == 0 else np.inf))
        if not np.isfinite(found[name]):
            found[name] = float("inf")
    return found
