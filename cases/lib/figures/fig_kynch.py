# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Figure 7: settling curves of spheres, full size and half size, and Kynch's."""

import numpy as np

from cases.lib.figures import fig_snapshots, print_figure
from cases.lib.kynch.kynch_column import Column
from cases.lib.kynch.kynch_measure import LAST, Record, line

_END, _QUICK = 2.0, 1.4  # [s] of the full size column


def wanted(number, options):
    return {"full": ("sphere-full", {"end": _QUICK if options.quick else _END, "frames": 2, "curve_rows": 700}),
            "half": fig_snapshots.run_of("sphere-half", options)}


def _speed(run, column):
    """Slope [m/s] of the top of the solids between the start's end and 80 % of
    the way, as cases/kynch takes it."""
    t, z = run.curve["time_s"], run.curve["interface_m"]
    stop = column.height - LAST * (column.height - column.kynch.final_height)
    return -line(t, z, (t > column.start.settled) & (z > stop))[0]


def draw(number, made, options):
    packed = Record(made["half"].folder).packed
    columns = {k: Column(run.values, packed) for k, run in made.items()}
    fig, (left, right) = print_figure.sheet(78, 1, 2)
    last = max(1.15 * (c.kynch.t_end if np.isfinite(c.kynch.t_end) else 2 * c.kynch.t_c) + c.start.lag
               for c in columns.values())
    said = []
    for (label, words), look in zip((("full", "full size"), ("half", "half size")), print_figure.LINES[1:]):
        run, column = made[label], columns[label]
        t, z = run.curve["time_s"], run.curve["interface_m"]
        unit = column.height / column.kynch.interface_speed
        times = np.linspace(0, last, 600)
        fall, risen = column.kynch.interface(times), column.kynch.interface(column.late(times))
        left.plot(times, 1e3 * fall, color=print_figure.GREY, lw=1.0, label="Kynch" if label == "full" else None)
        left.plot(times, 1e3 * risen, color="black", lw=0.9, ls=(0, (1, 1.2)),
                  label="Kynch, started from rest" if label == "full" else None)
        left.plot(t, 1e3 * z, **look, label=f"run, {words}")
        right.plot(t / unit, z / column.height, **look, label=f"run, {words}", zorder=3)
        if label == "half":
            right.plot(times / unit, fall / column.height, color=print_figure.GREY, lw=1.0, label="Kynch", zorder=2)
        v = _speed(run, column)
        said.append(f"{words} {1e3 * v:.1f} mm/s against {1e3 * column.kynch.interface_speed:.1f} mm/s "
                    f"({100 * (v / column.kynch.interface_speed - 1):+.1f} %)")
    left.set_xlim(0, last)
    left.set_ylim(0, 1.03e3 * columns["full"].height)
    left.set_xlabel("time simulated [s]")
    left.set_ylabel("upper interface [mm]")
    right.set_xlim(0, 1.6)
    right.set_ylim(0, 1.03)
    right.set_xlabel("time over (height / Kynch's interface speed)")
    right.set_ylabel("upper interface over its start")
    for ax, which, says in ((left, "a", "as simulated"), (right, "b", "both sizes at one scale")):
        print_figure.letter(ax, which, says)
        ax.legend(loc="upper right")
    c = columns["half"]
    return fig, (
        "Settling curves of uncharged spheres in the full and half size column, and Kynch's theory with the flux of "
        f"the running drag law ({c.law.name}): no number of it is fitted to the curves; the bed's solid fraction, "
        f"{packed:.3f}, is that of the settled half-size run. Dotted: the same with the start from rest by that law "
        f"(lag {c.start.lag:.3f} s). Speed of the top of the solids: {'; '.join(said)}. Runs: {made['full'].words()}; "
        f"{made['half'].words()}.")
