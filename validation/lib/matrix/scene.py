# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The coupled case of a row, in a folder of its own.

A box of 4 x 4 x 12 cells of 2 mm, two layers of 16 grains in it, one just above
z = 18 mm and one just above 6 mm. Each falls through that level within the
run, so that where the cells are cut between ranks says what happens on one of them:

    spread     the rank of the upper half has grains all the time
    empty      the rank above 22 mm has none all the time
    emptying   the rank above 18 mm has those of the upper layer, then none
    filling    the rank below 6 mm has none, then those of the lower layer
"""

import math
import os
import shutil

from cases.lib.case import openfoam
from cases.lib.case.casefile import TOP
from validation.lib.matrix import axes

SOURCE = os.path.join(TOP, "validation", "programs", "parallel-matrix")
CELLS = (4, 4, 12)
SIDE = 2e-3             # of a cell [m]
EXCHANGES = 20
# the planes' heights in cells, and whether the rank of its own is above or below
CUTS = {"spread": (6, "above"), "empty": (11, "above"), "emptying": (9, "above"), "filling": (3, "below")}
_LAYERS = (18.6e-3, 6.6e-3)


def rank_of_cell(row):
    """The CFD rank of each cell, in the mesh's order, x first."""
    level, own = CUTS[row["cut"]]
    ranks = []
    for k in range(CELLS[2]):
        for j in range(CELLS[1]):
            for i in range(CELLS[0]):
                here = (k >= level) == (own == "above")
                # the two sides of a cyclic pair of patches stay together but where they are to part
                half = (j if row["sides"] == "cyclic" else i) >= 2
                if row["cfd"] == 4:
                    ranks.append(2*here + half)
                elif row["sides"] == "processorCyclic":
                    ranks.append(int(half and (here or row["cut"] == "spread")))
                else:
                    ranks.append(int(here) if row["cfd"] == 2 else 0)
    return ranks


def grains(row):
    """Template, centre [m] and rotation of each grain; no two touch."""
    kinds = {"spheres": ("grain",), "clumps": ("rod", "knot"), "resistance": ("rod", "knot"),
             "both": ("grain", "rod", "grain", "knot")}[row["bodies"]]
    found = []
    for height in _LAYERS:
        for n in range(16):
            i, j = n % 4, n//4
            kind = kinds[(n + j) % len(kinds)]
            x = (0.8 + 1.95*i)*1e-3
            if kinds == ("grain",) and i < 2 and j % 2 == 0:  # near enough for a film
                x = (1.45, 2.39)[i]*1e-3
            elif i == 0 and j == 3 and kind == "grain":
                x = 0.5e-3  # near enough to the wall for a film
            y = (0.75 + 2.05*j)*1e-3
            z = height + 0.06e-3*math.sin(2.3*n)
            angle = 0.3 + 0.7*n
            found.append((kind, (x, y, z), (math.cos(angle), math.sin(angle)*0.6, math.sin(angle)*0.8, 0.0)))
    return found


def _flow():
    """A vortex in x and z at the start, weak and of one sign in y, for each cell."""
    rows = []
    for k in range(CELLS[2]):
        for j in range(CELLS[1]):
            for i in range(CELLS[0]):
                x, y, z = ((n + 0.5)/m for n, m in zip((i, j, k), CELLS))
                shape = math.sin(math.pi*y)
                rows.append("(%.17g 0 %.17g)" % (0.005*shape*math.sin(math.pi*x)*math.cos(math.pi*z),
                                                 -0.015*shape*math.cos(math.pi*x)*math.sin(math.pi*z)))
    return f"{len(rows)} ({' '.join(rows)})"


def _foam(row):
    """What the files of CFD/ take from their row."""
    wall, open_top = row["sides"] == "wall", row["ends"] == "outlet"
    coupling = {key: row[key] for key in
                ("dragModel", "voidFractionModel", "smoothingModel", "selfDisturbance", "model", "ddtVoidFraction",
                 "interpolation", "overlap", "frozenFluid", "keepMapping", "quietFluid")}
    coupling |= {"forceModels": f"({' '.join(axes.forces(row))})", "allowNoBuoyancy": "yes"}
    if row["smoothingModel"] == "diffusion":
        coupling["diffusionCoeffs"] = "{ bandwidth 4e-3; }"
    solver = {"GAMG": "solver GAMG; smoother GaussSeidel; directSolveCoarsest yes;"}.get(
        row["pressureSolver"], f"solver PCG; preconditioner {row['pressureSolver']};")
    tilt = 0.7e-3 if row["mesh"] == "skew" else 0.0
    return {"coupling": coupling, "row": {
        "sidesType": "wall" if wall else "cyclic", "sidesU": "noSlip" if wall else "cyclic",
        "sidesP": "zeroGradient" if wall else "cyclic",
        "topType": "patch" if open_top else "wall", "topU": "zeroGradient" if open_top else "noSlip",
        "topP": "fixedValue" if open_top else "zeroGradient",
        "front": f"{12e-3 - tilt:.6g}", "back": f"{12e-3 + tilt:.6g}", "cfd": str(row["cfd"]),
        "deltaT": f"{2.5e-3/row['steps']:.17g}", "adjustTimeStep": "yes" if row["steps"] == 1 else "no",
        "gradient": row["gradient"], "laplacian": row["laplacian"], "outer": str(row["outer"]),
        "momentumPredictor": row["momentumPredictor"], "pressureSolver": "{ " + solver + " }"}}


def _dem(row):
    """What in.liggghts takes from its row."""
    grid = {"z": {1: "1 1 1", 2: "1 1 2", 4: "1 1 4"}, "low": {1: "1 1 1", 2: "1 1 2", 4: "1 1 4"},
            "x": {1: "1 1 1", 2: "2 1 1", 4: "2 2 1"}}[row["demCut"]][row["dem"]]
    wall = row["sides"] == "wall"
    return {"along_x": "f" if wall else "p", "grid": grid, "size_x": "8e-3", "size_y": "8e-3", "size_z": "24e-3",
            "bottom": "-12e-3" if row["demCut"] == "low" else "0.", "tilt": "0.15" if wall else "-0.45",
            "templates": {"spheres": "grain", "both": "grain rod knot"}.get(row["bodies"], "rod knot"),
            "body_type": 2 if row["bodies"] == "both" else 1, "body": "id" if row["bodies"] == "spheres" else "mol",
            "spheres": int(row["bodies"] in ("spheres", "both")), "clumps": int(row["bodies"] != "spheres"),
            "walls": int(wall), "clump_drag": "resistance" if row["bodies"] in ("resistance", "both") else "sphereSum",
            **{key: int(row[key] == "yes") for key in ("charges", "films", "thermal", "shown")}, "lag": row["lag"]}


def write(folder, row, substitutes=None):
    """Makes a row's case, mesh and all; substitutes: other entries of couplingProperties."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(os.path.join(SOURCE, "CFD"), os.path.join(folder, "CFD"))
    shutil.copy(os.path.join(SOURCE, "in.liggghts"), folder)
    os.makedirs(os.path.join(folder, "DEM"))
    foam = _foam(row)
    foam["coupling"].update(substitutes or {})
    for name in ("row", "coupling"):
        with open(os.path.join(folder, "CFD", name), "w", encoding="utf-8") as f:
            for key, value in foam[name].items():
                f.write(f"{key} {value}\n" if value.startswith("{") else f"{key} {value};\n")
    start = os.path.join(folder, "CFD", "0", "U")
    with open(start, encoding="utf-8") as f:
        text = f.read()
    with open(start, "w", encoding="utf-8") as f:
        f.write(text.replace("$flow", _flow()))
    with open(os.path.join(folder, "row.liggghts"), "w", encoding="utf-8") as f:
        f.writelines(f'variable {k} string "{v}"\n' for k, v in _dem(row).items())
    with open(os.path.join(folder, "grains.places"), "w", encoding="utf-8") as f:
        for kind, place, turn in grains(row):
            f.write(" ".join([kind, *(f"{x:.17g}" for x in (place if kind == "grain" else (*place, *turn)))]) + "\n")
    mesh(os.path.join(folder, "CFD"), row)


def mesh(case, row):
    """The mesh, cut into the ranks' parts."""
    openfoam.run("blockMesh", case)
    if row["cfd"] == 1:
        return
    ranks = rank_of_cell(row)
    with open(os.path.join(case, "constant", "cellDecomposition"), "w", encoding="utf-8") as f:
        f.write("FoamFile { version 2.0; format ascii; class labelList; object cellDecomposition; }\n"
                f"{len(ranks)}\n(\n" + "\n".join(map(str, ranks)) + "\n)\n")
    openfoam.run("decomposePar", case)
