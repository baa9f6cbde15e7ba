# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Figures 5 and 6: the column from 0 to 77 days, with the flow."""

import numpy as np

from cases.lib.figures import print_figure
from cases.lib.figures.fig_packing import _SAND as SAND
from cases.lib.output import pictures, spheres

_MOMENTS = 6
_END, _QUICK = 7.0, 1.0  # [s]; 7 s are 77 days
_FRAME = 0.02  # [s]


def run_of(case, options):
    """The run of a case whose column is shown; figures 7, 10 use it as well."""
    end = _QUICK if options.quick else _END
    return case, {"end": end, "frames": round(end / _FRAME), "curve_rows": round(end / 0.0025)}


def wanted(number, options):
    return {"column": run_of("sphere-half" if number == 5 else "rp-07a", options)}


def draw(number, made, options):
    run = made["column"]
    v = run.values
    found = pictures.moments(run.folder, v, _MOMENTS)
    top = max(m.top_speed for m in found) or 1e-12
    # panes as wide as six pairs allow, the tube drawn to scale
    gap, room, pane = 1.2, 16.0, 0.0
    pane = (print_figure.WIDTH - room - 4) / (2 * len(found)) - gap
    tall = 1.04 * pane / 2.1 * v["tube_height"] / v["tube_radius"]
    total = tall + 13
    fig = print_figure.blank(total)
    for k, moment in enumerate(found):
        axes = [fig.add_axes([(2 + (2 * k + i) * (pane + gap)) / print_figure.WIDTH, 2 / total,
                              pane / print_figure.WIDTH, tall / total]) for i in (0, 1)]
        n = len(moment.spheres["id"])
        colours = np.tile(SAND, (n, 1)) if number == 5 else spheres.hues(moment.spheres)
        shown = pictures.pair(*axes, moment, v, top, colours, 9000)
        axes[0].set_title(f"{moment.time * run.days:.3g} d\n({moment.time:.3g} s)", loc="left")
    bar = fig.colorbar(shown, cax=fig.add_axes([(print_figure.WIDTH - room + 1) / print_figure.WIDTH, 2 / total,
                                               2.2 / print_figure.WIDTH, tall / total]))
    bar.set_label("fluid speed [mm/s]")
    bar.ax.grid(False)
    last = found[-1]
    what = "sphere column"
    if number != 5:
        what = f"clump column {run.summary['case'].upper()}, clumps in colours of their own,"
    return fig, (
        f"The {what} from 0 to {last.time * run.days:.3g} days in the laboratory ({last.time:.3g} s simulated): "
        "particles, and beside them the fluid's speed in the cells that the plane y = 0 cuts, with arrows of its "
        f"direction. Times at equal distances along the curve of mean height over time. Fastest: {1e3 * top:.0f} mm/s; "
        f"at the end {1e3 * last.top_speed:.1f} mm/s. {run.words()}.")
