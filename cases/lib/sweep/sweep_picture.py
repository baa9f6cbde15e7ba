# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of a sweep: the curves, and their slopes against the parameter."""

import numpy as np

from cases.lib.output.plotting import plt, wrapped
from cases.lib.run import runs

_LINES = ("-", "--", ":", "-.")
_MARKS = ("o", "s", "^", "D")
_MOST_NAMED = 8


def _number(word):
    try:
        return float(word)
    except ValueError:
        return None


def _axis(key, unit):
    return f"{key} [{unit}]" if unit and unit not in ("1", "name") else key


def draw(path, rows, varied, units, title):
    """rows: points without error; the first key of `varied` is the abscissa,
    the others' combinations have lines and marks of their own."""
    key, others = varied[0], varied[1:]
    raw = list(dict.fromkeys(row["parameters"][key] for row in rows))
    numbers = [_number(v) for v in raw]
    numeric = all(n is not None for n in numbers)
    place = dict(zip(raw, numbers if numeric else range(len(raw))))
    raw = sorted(raw, key=place.get)
    colour = {v: plt.cm.viridis(0.9 * i / max(1, len(raw) - 1)) for i, v in enumerate(raw)}
    series = list(dict.fromkeys(tuple(row["parameters"][k] for k in others) for row in rows))

    fig = plt.figure(figsize=(10.5, 6.4), layout="constrained")
    left, right = fig.subfigures(1, 2, width_ratios=(1.15, 1))
    curves = left.subplots()
    shown = [k for k in range(3) if any(k < row["stages"]["count"] for row in rows)] + [3]
    panes = np.atleast_1d(right.subplots(len(shown), 1, sharex=True))
    named = set()
    for row in rows:
        v, s = row["parameters"][key], tuple(row["parameters"][k] for k in others)
        c = runs.curve(row["folder"])
        show = v not in named and (len(raw) <= _MOST_NAMED or v in (raw[0], raw[len(raw) // 2], raw[-1]))
        named.add(v)
        curves.plot(c["time_s"], 1e3 * c["interface_m"], _LINES[series.index(s) % 4], color=colour[v], lw=1.3)
        if show:
            curves.plot([], [], "-", color=colour[v], label=f"{key} = {v}")
    for s in series if others else ():
        curves.plot([], [], _LINES[series.index(s) % 4], color="0.3",
                    label=", ".join(f"{k} = {x}" for k, x in zip(others, s)))
    curves.set_xlim(left=0)
    curves.set_ylim(bottom=0)
    curves.set_xlabel("time simulated [s]")
    curves.set_ylabel("upper interface [mm]")
    # in the order of the values, whatever the order of the runs
    handles, labels = curves.get_legend_handles_labels()
    order = sorted(range(len(labels)), key=lambda i: next(
        (k for k, v in enumerate(raw) if labels[i] == f"{key} = {v}"), len(raw)))
    curves.legend([handles[i] for i in order], [labels[i] for i in order], fontsize=8)

    step = np.ptp(list(place.values())) or 1.0
    seeds = sorted({str(row["parameters"].get("seed", "")) for row in rows})
    for k, ax in zip(shown, panes):
        for j, s in enumerate(series):
            found = {}
            for row in rows:
                if tuple(row["parameters"][o] for o in others) != s:
                    continue
                v = row["parameters"][key]
                # beside each other, so that every interval is seen
                i = seeds.index(str(row["parameters"].get("seed", "")))
                x = place[v] + 0.008 * step * (i - 0.5 * (len(seeds) - 1))
                if k == 3:
                    y, bounds = row["interface_end_m"], None
                elif k < row["stages"]["count"]:
                    y, bounds = -row["stages"]["slopes_m_per_s"][k], row["stages"]["slopes_ci"][k]
                else:
                    continue
                found.setdefault(v, []).append(1e3 * y)
                if bounds is not None:
                    ax.plot([x, x], [-1e3 * b for b in bounds], color=colour[v], lw=1.2)
                ax.plot(x, 1e3 * y, _MARKS[j % 4], color=colour[v], ms=4.5)
            there = [v for v in raw if v in found]
            ax.plot([place[v] for v in there], [np.mean(found[v]) for v in there],
                    _LINES[j % 4], color="0.55", lw=0.9, zorder=0)
        ax.set_ylabel("end [mm]" if k == 3 else f"slope {k + 1}\n[mm/s]", fontsize=9)
        ax.tick_params(labelsize=8)
        ax.grid(alpha=0.3)
        ax.margins(y=0.15)
    panes[0].set_title("falling speed of each stage, and the interface at the end", fontsize=9)
    panes[-1].set_xlabel(_axis(key, units.get(key, "")))
    if numeric and min(place.values()) > 0 and max(place.values()) > 50 * min(place.values()):
        panes[-1].set_xscale("log")
    if not numeric:
        panes[-1].set_xticks(list(place.values()), list(place))
    curves.grid(alpha=0.3)
    fig.suptitle(wrapped(title, 10.5), fontsize=9)
    fig.savefig(path, dpi=150)
    plt.close(fig)
