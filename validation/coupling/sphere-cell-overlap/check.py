# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Volume of spheres in cells: exact overlaps, and sums that miss nothing with any scheme."""

import os

import numpy as np

from validation.lib.checks import coupled, plots, reference

TITLE = "overlap of sphere and cell; volume kept by every scheme"


def void_fraction(folder, time):
    """The field voidfraction as an array, in the order of the cells."""
    with open(os.path.join(folder, "CFD", time, "voidfraction"), encoding="utf-8") as f:
        text = f.read()
    text = text[text.index("List<scalar>"):]
    return np.array(text[text.index("(") + 1:text.index(")")].split(), dtype=float)


def run(checks):
    r = reference.table("sphere_hex_overlap_exact")
    tall = np.flatnonzero(r["z1_m"] == 1)
    solid = 1 - void_fraction(coupled.finished("overlap-scene", "sphere-cell-overlap/cells", "--no-pictures"),
                              "0.002").reshape(5, 5, 60)
    flat = 1 - void_fraction(coupled.finished("overlap-scene", "sphere-cell-overlap/flat", "--no-pictures", "--set",
                                              "height=0.05", "--set", "size_z=0.85", "--set", "cells_z=17", "--set",
                                              "size_x=5", "--set", "cells_x=5"), "0.002").reshape(17, 5, 5)
    found = np.zeros(len(r["case"]))
    for k, row in enumerate(tall):
        found[row] = solid[2, 2, 4 * k + 2]
    for row in np.flatnonzero(r["z1_m"] != 1):
        found[row] = flat[8, 2, 2] * 0.05
    for name, value, exact in zip(r["case"], found, r["overlap_m3"]):
        if name == "engulf":
            # a full cell keeps the least void fraction there is, and hands on the rest
            checks.close("engulf: solid in the cell, less voidFractionMin [m3]", value, 1 - 1e-6, 1e-9)
        else:
            checks.close(f"{name}: overlap [m3]", value, exact, 1e-9)

    spheres = 4 / 3 * np.pi * np.sum(r["r_m"][tall] ** 3)
    checks.close("cells: sum of the field over all cells [m3]", np.sum(solid), spheres, 1e-9)

    # the tube's mesh is a polygon in which the DEM's cylinder does not quite fit
    tube = ("--end", "0.005", "--set", "frames=1", "--set", "smoothing=none")
    for case, scheme, ranks, more in (
            ("overlap-scene", "exactOverlap", "2", ()), ("overlap-scene", "divided", "2", ()),
            ("sphere-half", "exactOverlap", "1", tube), ("sphere-half", "exactOverlap", "2", tube),
            ("sphere-half", "divided", "2", tube), ("sphere-half", "centre", "2", tube),
            ("sphere-half", "exactOverlap", "2", (*tube[:-1], "smoothing=diffusion"))):
        where = "cells" if case == "overlap-scene" else "tube, smoothed" if "smoothing=diffusion" in more else "tube"
        folder = coupled.finished(case, f"sphere-cell-overlap/{where.replace(', ', '-')}-{scheme}-{ranks}",
                                  "--no-pictures", "--cfd", ranks, "--set", f"void_fraction={scheme}", *more)
        row = f"{scheme}, {where}, 1 + {ranks} ranks: "
        cfd = coupled.cfd(folder)
        checks.at_most(row + "sum of the cells over that of the spheres, less 1", cfd["max_void_fraction_volume_error"],
                       1e-12)
        if scheme != "exactOverlap":
            continue
        # before they are divided by their sum: what is counted twice shows here alone, and what is left out where the
        # mesh has no wall in the way
        checks.at_most(row + "most of a sphere in cells, less 1", cfd["sphere_weight_sum_max"] - 1, 1e-12)
        if case == "overlap-scene":
            checks.at_most(row + "1, less the least of a sphere in cells", 1 - cfd["sphere_weight_sum_min"], 1e-12)
    # a lattice of spheres, eight a cell, of which one layer stands across the periodic faces of bottom and top
    around = ("--set", "bottom=cyclic", "--set", "top=cyclic", "--set", "gravity=0", "--set", "origin_z=0.0006",
              "--end", "0.001")
    uniform = 8 * 4 / 3 * np.pi * 1e-9 / 4.8e-3**3
    folder = coupled.finished("lattice-scene", "sphere-cell-overlap/periodic", "--no-pictures", *around)
    found_there = 1 - void_fraction(folder, "0.001")
    checks.at_most("exactOverlap across periodic faces: largest difference from the exact solid fraction, over it",
                   np.max(np.abs(found_there / uniform - 1)), 1e-9)
    shown = (r["overlap_m3"] > 0) & (r["case"] != "engulf")
    checks.picture(plots.compare(
        os.path.join(coupled.RUNS, "sphere-cell-overlap", "overlap.png"),
        [("exactOverlap", np.flatnonzero(shown), np.abs(found / np.where(shown, r["overlap_m3"], 1) - 1)[shown] + 1e-17,
          "dots"),
         ("gate", [0, len(found)], [1e-9, 1e-9], "dashed")],
        "row of the table", "relative error of the overlap", "sphere and cell", logy=True))
