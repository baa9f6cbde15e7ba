# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Other meshes of a box than blockMesh's: warped hexahedra, tetrahedra, and the
polyhedra dual to these. From the hexahedra in polyMesh, in ascii."""

import os
import re

import numpy as np

from cases.lib.case import openfoam
from cases.lib.case.errors import CaseError

KINDS = ("hex", "warped", "tet", "poly")
_HEAD = "FoamFile\n{{\n    version     2.0;\n    format      ascii;\n    class       {};\n    object      {};\n}}\n\n"
# the six paths along the edges of a unit cube from (0 0 0) to (1 1 1), each with its orientation
_PATHS = (((0, 1, 2), 1), ((1, 2, 0), 1), ((2, 0, 1), 1), ((0, 2, 1), -1), ((2, 1, 0), -1), ((1, 0, 2), -1))


def change(kind, cfd, v):
    """Turns the hexahedra of a box's polyMesh into cells of the kind wanted."""
    if kind == "hex":
        return
    if "cyclic" in (v["sides"], v["bottom"], v["top"]):
        raise CaseError(f"mesh = {kind}: sides, bottom and top must be wall, slip, inlet or open, not cyclic")
    mesh = os.path.join(cfd, "constant", "polyMesh")
    counts = [int(v["cells_" + a]) for a in "xyz"]
    sizes = [float(v["size_" + a]) for a in "xyz"]
    if kind == "warped":
        _warp(mesh, counts, sizes, int(v["seed"]))
        return
    _tetrahedra(mesh, counts, sizes)
    if kind == "poly":
        openfoam.run("polyDualMesh", cfd, "60", "-concaveMultiCells", "-overwrite")
        for name in os.listdir(cfd):  # what it found, to look at
            if name.endswith(".obj"):
                os.remove(os.path.join(cfd, name))


def _grid(counts, sizes):
    axes = [np.linspace(0.0, s, n + 1) for n, s in zip(counts, sizes)]
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)


def _warp(mesh, counts, sizes, seed):
    """Moves the inner points by up to a fifth of a cell: no face stays plane."""
    path = os.path.join(mesh, "points")
    points = openfoam._list(path).reshape(-1, 3)
    inside = np.all((points > 1e-9) & (points < np.array(sizes) - 1e-9), axis=1)
    cell = np.array(sizes) / counts
    shift = np.random.default_rng(seed).uniform(-0.2, 0.2, points.shape) * cell
    _write(mesh, "points", "vectorField", _vectors(points + shift * inside[:, None]))


def _tetrahedra(mesh, counts, sizes):
    """Six tetrahedra a cell, around its diagonal; neighbours fit."""
    grid = _grid(counts, sizes)
    number = np.arange(grid[..., 0].size).reshape(grid.shape[:3])
    low = [np.arange(n) for n in counts]
    corner = np.stack(np.meshgrid(*low, indexing="ij"), axis=-1).reshape(-1, 3)
    tets = []
    for path, turn in _PATHS:
        at, ends = corner.copy(), [number[tuple(corner.T)]]
        for axis in path:
            at = at.copy()
            at[:, axis] += 1
            ends.append(number[tuple(at.T)])
        if turn < 0:
            ends[1], ends[2] = ends[2], ends[1]
        tets.append(np.column_stack(ends))
    tets = np.stack(tets, axis=1).reshape(-1, 4)
    _polymesh(mesh, grid.reshape(-1, 3), tets, sizes)


def _polymesh(mesh, points, tets, sizes):
    """Writes points, faces, owner, neighbour; the patches keep their names and kinds."""
    faces = {}
    for cell, (a, b, c, d) in enumerate(tets.tolist()):
        for face in ((a, c, b), (a, b, d), (b, c, d), (a, d, c)):
            key = tuple(sorted(face))
            if key in faces:
                faces[key].append(cell)
            else:
                faces[key] = [face, cell]
    inner = sorted((f[1], f[2], f[0]) for f in faces.values() if len(f) == 3)
    with open(os.path.join(mesh, "boundary"), encoding="utf-8") as f:
        old = f.read()
    kinds = re.findall(r"(\w+)\s*\{[^}]*?type\s+(\w+);[^}]*?nFaces", old)
    sides = {"left": (0, 0.0), "right": (0, sizes[0]), "front": (1, 0.0), "back": (1, sizes[1]),
             "bottom": (2, 0.0), "top": (2, sizes[2])}
    outer = [(f[0], f[1]) for f in faces.values() if len(f) == 2]
    spots = points[np.array([f for f, _ in outer])]
    order, patches = [], []
    for name, kind in kinds:
        axis, at = sides[name]
        mine = np.flatnonzero(np.all(np.abs(spots[:, :, axis] - at) < 1e-9 * max(sizes), axis=1))
        patches.append((name, kind, len(mine), len(inner) + len(order)))
        order += [outer[i] for i in mine]
    all_faces = [f for _, _, f in inner] + [f for f, _ in order]
    _write(mesh, "points", "vectorField", _vectors(points))
    _write(mesh, "faces", "faceList", [f"3({a} {b} {c})" for a, b, c in all_faces])
    _write(mesh, "owner", "labelList", [str(o) for o, _, _ in inner] + [str(o) for _, o in order])
    _write(mesh, "neighbour", "labelList", [str(n) for _, n, _ in inner])
    _write(mesh, "boundary", "polyBoundaryMesh",
           [f"{n}\n{{\n    type {k};\n    nFaces {c};\n    startFace {s};\n}}" for n, k, c, s in patches])


def _vectors(values):
    return [f"({x:.15g} {y:.15g} {z:.15g})" for x, y, z in values]


def _write(mesh, name, kind, rows):
    with open(os.path.join(mesh, name), "w", encoding="utf-8") as f:
        f.write(_HEAD.format(kind, name) + f"{len(rows)}\n(\n" + "\n".join(rows) + "\n)\n")
