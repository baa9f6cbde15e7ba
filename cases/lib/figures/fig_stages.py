# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Figure 8: the complete settling curve of charged clumps, with its stages."""

import numpy as np

from cases.lib.calibration import stagefit
from cases.lib.case.places import called
from cases.lib.figures import print_figure

_END, _QUICK = 64.0, 2.0  # [s]
_NAMES = ("sedimentation", "transition", "consolidation")


def wanted(number, options):
    end = _QUICK if options.quick else _END
    return {"curve": ("clump-half", {"end": end, "curve_rows": max(200, round(end / 0.01))})}


def _marked(ax, curve, found, times, heights):
    """The curves, the stages' lines and breaks."""
    t = curve["time_s"]
    ax.plot(t, 1e3 * curve["interface_m"], color="#56B4E9", lw=2.6, label="upper interface")
    ax.plot(t, 1e3 * curve["mean_height_m"], **print_figure.LINES[2], label="mean height")
    ax.plot(times, 1e3 * heights, color="black", lw=1.0, label="stages fitted to the interface")
    for k, (at, (low, high)) in enumerate(zip(found.breaks, found.breaks_ci)):
        ax.axvspan(low, high, color="#D55E00", alpha=0.25, lw=0)
        ax.axvline(at, color="#D55E00", lw=0.8, ls="--", label=None if k else "end of a stage, 95 % interval")


def _words(k, found):
    """A stage's slope; its name where there are the paper's three."""
    low, high = sorted(-1e3 * x for x in found.slopes_ci[k])
    name = f"{_NAMES[k]}, " if found.count == len(_NAMES) else ""
    rest = ", at rest as far as can be told" if low <= 0 <= high else ""
    return f"{name}slope {k + 1}: {-1e3 * found.slopes[k]:.3g} mm/s ({low:.3g} to {high:.3g}{rest})"


def draw(number, made, options):
    run = made["curve"]
    c = run.curve
    t, z = c["time_s"], c["interface_m"]
    found = stagefit.of(t, z)
    edges = np.concatenate([[found.start], found.breaks, [t[-1]]])
    # the fitted line goes through the mean of the curve
    heights = np.concatenate([[0.0], np.cumsum(found.slopes * np.diff(edges))])
    inside = t >= found.start
    heights += np.mean(z[inside] - np.interp(t[inside], edges, heights))
    fig, (whole, early) = print_figure.sheet(88, 1, 2, width_ratios=(1.5, 1))
    for ax in (whole, early):
        _marked(ax, c, found, edges, heights)
        ax.set_ylim(0, 1.03e3 * run.values["fill_height"])
        ax.set_xlabel("time simulated [s]")
    whole.set_ylabel("height [mm]")
    whole.set_xlim(0, t[-1])
    first = found.breaks[0] if found.count > 1 else t[-1] / 3
    early.set_xlim(0, min(t[-1], 3 * first))
    print_figure.days_above(whole, run.values["time_scale"])
    print_figure.days_above(early, run.values["time_scale"], "[days]")
    whole.legend(loc="upper right", title="(a) the whole run", alignment="left")
    early.text(0.97, 0.96, "(b) its beginning", transform=early.transAxes, ha="right", va="top",
               bbox={"fc": "white", "ec": "none", "alpha": 0.9, "pad": 2}, zorder=5)
    for k in range(found.count):
        low, high = edges[k], edges[k + 1]
        ax = early if high <= early.get_xlim()[1] else whole
        middle = 0.5 * (low + min(high, ax.get_xlim()[1]))
        y = 1e3 * np.interp(middle, edges, heights)
        ax.annotate(f"{k + 1}", (middle, y), xytext=(7, 9), textcoords="offset points", fontsize=9, fontweight="bold",
                    bbox={"boxstyle": "circle,pad=0.2", "fc": "white", "ec": "black", "lw": 0.6})
    named = [_words(k, found) for k in range(found.count)]
    stages = {1: "one stage", 2: "two stages", 3: "three stages"}[found.count]
    breaks = " and ".join(f"{b:.3g} s = {b * run.days:.3g} d" for b in found.breaks)
    few = "" if found.count >= 3 else " Fewer than the three of the paper's figure."
    slow = f" A slow start until {found.start:.2g} s is left out." if found.start > t[0] else ""
    ends = {1: "", 2: f" The first ends at {breaks}.", 3: f" They end at {breaks}."}[found.count]
    return fig, (
        f"Settling curve of charged clumps to {t[-1]:.3g} s = {t[-1] * run.days:.3g} days, with {stages} found by "
        f"{called('stages')}' method (near-linear, each at most half as fast as the one before): "
        f"{'; '.join(f'({k + 1}) {n}' for k, n in enumerate(named))}; 95 % intervals.{ends}{few}{slow} {run.words()}.")
