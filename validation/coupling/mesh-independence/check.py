# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""One column on four meshes: the settling curve must not hang on the mesh."""

import os

import numpy as np

from validation.lib.checks import coupled, plots

TITLE = "settling curves of one column on four meshes, charged clumps and spheres"
LONG = True

END = 0.5
KERNEL = "smoothing=diffusion"
# cells across the core, rings, layers, None: as the case has them; the mean size of a cell [mm], height of one [mm]
MESHES = {"coarser": (4, 2, 9), "shipped": None, "fine": (6, 3, 32), "finer": (8, 4, 62)}
COLUMNS = {"clump-half": 16.87e-3, "sphere-half": 7e-3}  # 3.5 diameters of the bodies [m]
CURVES = {"mean_height_m": ("mean height", 0.005), "interface_m": ("interface", 0.01)}


def curves(case, mesh, tag, *settings):
    cells = [f"{key}={n}" for key, n in zip(("core_cells", "ring_cells", "layers"), MESHES[mesh] or ())]
    words = [w for s in (*cells, *settings) for w in ("--set", s)]
    folder = coupled.finished(case, f"mesh-independence/{case}-{mesh}-{tag}", "--no-pictures", "--end", str(END),
                              *words, limit=1800)
    return {**coupled.settling(folder), "warned": any("cells are" in w for w in coupled.cfd(folder)["warnings"])}


def apart(mine, other, curve):
    """Root mean square distance of two curves over what has sunk."""
    t, y = np.array(mine["time_s"]), np.array(mine[curve])
    off = y - np.interp(t, other["time_s"], other[curve])
    return float(np.sqrt(np.mean(off**2)) / (y[0] - y.min()))


def run(checks):
    lines = []
    for case, width in COLUMNS.items():
        found = {mesh: curves(case, mesh, "auto", KERNEL) for mesh in MESHES}
        best = found["finer"]
        # of spheres in cells more than twice as high as the kernel is wide, and of nothing else
        checks.equal(f"{case}: meshes whose cells are warned of", [m for m in MESHES if found[m]["warned"]],
                     ["coarser"] if case == "sphere-half" else [])
        # what a run moves by when it is disturbed by next to nothing
        again = curves(case, "finer", "again", KERNEL, "gravity=9.81000001")
        for curve, (name, gate) in CURVES.items():
            scatter = apart(best, again, curve)
            checks.note(f"{case}, {name}: a gravity that differs by 1e-9 moves the curve by {100 * scatter:.2f} %")
            for mesh in MESHES:
                if mesh != "finer":
                    checks.at_most(f"{case}, {name}: {mesh} mesh from the finer one, rms over what has sunk",
                                   apart(best, found[mesh], curve), max(gate, 2 * scatter))
        for factor in (0.5, 2):
            other = curves(case, "shipped", f"b-{factor:g}", KERNEL, f"bandwidth={factor * width:g}")
            for curve, (name, _) in CURVES.items():
                checks.note(f"{case}, {name}: a bandwidth {factor:g} times as wide moves the curve by "
                            f"{100 * apart(found['shipped'], other, curve):.2f} %, shipped mesh")
            if case == "clump-half":
                lines.append((f"{case}, {factor:g} b", other["time_s"][::10],
                              np.array(other["interface_m"])[::10] * 1e3, "dots"))
        bare = {mesh: curves(case, mesh, "none") for mesh in ("shipped", "finer")}
        for curve, (name, gate) in CURVES.items():
            checks.note(f"{case}, {name}: without smoothing the shipped mesh is "
                        f"{100 * apart(bare['finer'], bare['shipped'], curve):.2f} % from the finer one")
        for mesh, one in found.items():
            lines.append((f"{case}, {mesh}", one["time_s"], np.array(one["interface_m"]) * 1e3, "line"))
    checks.picture(plots.compare(
        os.path.join(coupled.RUNS, "mesh-independence", "mesh-independence.png"), lines, "t [s]", "interface [mm]",
        "one column on four meshes"))
