# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Terminal velocity of one sphere, whatever the cells: the self-disturbance."""

import os

from cases.lib.theory import drag
from validation.lib.checks import plots, single_sphere
from validation.lib.checks.coupled import RUNS, summary

TITLE = "terminal velocity of one sphere in cells of 2 to 10 diameters"

CELL, CELLS, NU, RHO, SOLID = 2e-3, 16, 5e-4, 1000.0, 2600.0


def _run(where, ratio, place=0.5 + 0.5 / CELLS, model="latticeMemory", **more):
    """Velocity over the law's at the end, and the run's folder; cells of `ratio` diameters."""
    d = CELL / ratio
    side = CELL * CELLS
    folder = single_sphere.run(f"single-sphere/{where}", size_x=side, size_y=side, size_z=side, cells_x=CELLS,
                               cells_y=CELLS, cells_z=CELLS, sides="slip", bottom="slip", top="slip",
                               sphere_radius=0.5 * d, viscosity=NU * RHO, end=0.02, dem_step=2e-5, coupling_steps=10,
                               at_x=place, at_y=place, at_z=place, self_disturbance=model, frames=2, curve_rows=200,
                               **more)
    law = drag.terminal_velocity(d, SOLID, RHO, NU * RHO, drag_law=more.get("drag", "SchillerNaumann"))
    return -single_sphere.path(folder)[2][-1] / law, folder


def run(checks):
    found, plain = {}, {}
    for ratio in (2, 3, 5, 10):
        found[ratio], folder = _run(f"{ratio}d", ratio)
        checks.close(f"cells of {ratio} d: velocity over the law's", found[ratio], 1.0, 0.01)
        plain[ratio], _ = _run(f"{ratio}d-none", ratio, model="none")
    checks.at_most("momentum residual with the correction", summary(folder)["max_momentum_residual"], 1e-10)

    for ratio in (2, 3, 5):
        for solid in (2600.0, 1050.0, 500.0):
            bare, with_it = (_run(f"{ratio}d-{solid:g}-{forces}", ratio, density=solid,
                                  forces=f"pressureGradient+buoyancy{forces}")[0] for forces in ("", "+addedMass"))
            checks.at_most(f"cells of {ratio} d, {solid:g} kg/m3: change of the velocity by added mass",
                           abs(with_it / bare - 1), 1e-3)

    corner, _ = _run("2d-corner", 2, place=0.5)
    checks.close("cells of 2 d, on the corner of eight: velocity over the law's", corner, 1.0, 0.01)
    for b in (2, 4, 8):
        value, _ = _run(f"2d-b{b}", 2, smoothing="diffusion", bandwidth=b * 0.5 * CELL)
        checks.close(f"cells of 2 d, bandwidth of {b} d: velocity over the law's", value, 1.0, 0.01)

    checks.at_least("without the correction, cells of 2 d: excess of velocity", plain[2] - 1, 0.2)
    checks.at_least("without the correction, cells of 10 d: excess of velocity", plain[10] - 1, 0.03)
    checks.picture(plots.compare(
        os.path.join(RUNS, "single-sphere", "terminal-velocity.png"),
        [("selfDisturbance none", list(plain), list(plain.values()), "dots"),
         ("latticeMemory", list(found), list(found.values()), "line"),
         ("drag law", [2, 10], [1, 1], "dashed")],
        "cell size / diameter", "terminal velocity / that of the drag law", "one sphere, Re < 0.01"))
