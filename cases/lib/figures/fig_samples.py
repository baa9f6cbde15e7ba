# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Figures 10 and 11: the four samples in one picture, and against data."""

import numpy as np

from cases.lib.calibration import stagefit
from cases.lib.figures import fig_snapshots, labcurve, print_figure

_DAYS = 130.0  # how far the paper's curves go
_END, _LONG, _QUICK = 11.84, 64.0, fig_snapshots._QUICK  # [s]; 130 and 703 days
_MADE_END = 11.84


def wanted(number, options):
    found = {}
    for sample in labcurve.SAMPLES:
        if options.quick:  # figure 6's run of RP-07A serves as well
            found[sample] = fig_snapshots.run_of(sample, options)
        else:
            end = _LONG if options.long else _END
            found[sample] = (sample, {"end": end, "curve_rows": max(200, round(end / 0.01))})
        if number == 11 and sample not in (options.data or {}):
            end = _QUICK if options.quick else _MADE_END
            found[sample + " made up"] = (sample, {"end": end, "seed": labcurve.MADE_SEED,
                                                   "curve_rows": max(200, round(end / 0.01))})
    return found


def _look(sample):
    return print_figure.LINES[labcurve.SAMPLES.index(sample)]


def _name(run):
    return run.summary["case"].upper()


def _shared(runs):
    """What all runs of a figure have in common."""
    v = runs[0].values
    reynolds = max(r.summary["reynolds_max"] for r in runs)
    overlap = max(r.summary["max_overlap_over_d"] for r in runs)
    return (f"half size column, each sample at its own solids, height, temperature and charge "
            f"(Tables 3 and 5), cut-off {1e3 * v['cutoff']:.3g} mm, packing {v['packing']} {v['seed']}, k = "
            f"{v['stiffness']:.4g} N/m, drag {v['drag']}; {v['end']:.4g} s simulated; Re up to {reynolds:.0f}, overlap "
            f"up to {100 * overlap:.2g} % of d")


def _ten(made):
    """All four in one picture; beside it the slow stage enlarged."""
    fig, (whole, slow) = print_figure.sheet(92, 1, 2, width_ratios=(1.25, 1))
    last, ends, slopes = 0.0, [], []
    for sample in labcurve.SAMPLES:
        run = made[sample]
        shown = run.curve["time_s"] * run.days <= _DAYS + 1e-6
        days = run.curve["time_s"][shown] * run.days
        y = 100 * run.curve["interface_m"][shown] / run.values["fill_height"]
        last = max(last, days[-1])
        for ax in (whole, slow):
            ax.plot(days, y, **_look(sample), label=f"{_name(run)}: {run.values['solids']:g} %, "
                    f"{1e10 * run.values['charge']:.3f}e-10 C")
        found = stagefit.of(days, y, samples=0)
        begin = min(1.3 * found.breaks[0], 0.6 * days[-1]) if found.count > 1 else 0.5 * days[-1]
        ends.append((begin, y[days >= begin]))
        slopes.append((sample, found))
    begin = max(b for b, _ in ends)
    lowest, highest = min(np.min(y) for _, y in ends), max(np.max(y) for _, y in ends)
    margin = 0.08 * (highest - lowest)
    whole.set_ylim(0, 102)
    whole.set_ylabel("upper interface over its height at the start [%]")
    slow.set_ylim(lowest - margin, highest + margin)
    whole.set_xlim(0, last)
    slow.set_xlim(begin, last)
    for ax, which, says in ((whole, "a", "the whole curves"), (slow, "b", "after the first stage, enlarged")):
        print_figure.letter(ax, which, says)
        ax.set_xlabel("time in the laboratory [days]")
    whole.legend(loc="upper right", handlelength=2.8, title="solids by mass, charge of a sphere", alignment="left")
    words = "; ".join(
        f"{sample.upper()} ({made[sample].values['clumps']:.0f} clumps, {made[sample].values['temperature']:g} C) "
        + ", ".join(f"{-s:.3g}" for s in found.slopes) + " %/d"
        + (f", first stage to day {found.breaks[0]:.2g}" if found.count > 1 else "") for sample, found in slopes)
    return fig, (f"Settling curves of the four samples, computed: {_shared([made[s] for s in labcurve.SAMPLES])}. "
                 f"Falling speed of the stages found: {words}.")


def _eleven(made, data):
    """A pane a sample: the run, its time stretched to come nearest to the data."""
    fig, axes = print_figure.sheet(135, 2, 2, sharey=True)
    said, invented = [], False
    runs = [made[s] for s in labcurve.SAMPLES]
    for k, (ax, sample) in enumerate(zip(axes.flat, labcurve.SAMPLES)):
        run = made[sample]
        curve = data.get(sample) or labcurve.made_up(made[sample + " made up"], _DAYS)
        invented |= curve.made_up
        scale, off = labcurve.time_scale(run, curve)
        days = run.curve["time_s"] * scale / 86400
        ax.plot(days, 100 * run.curve["interface_m"] / run.values["fill_height"], color="#0072B2", ls="-", zorder=2,
                label=f"run, q = {1e10 * run.values['charge']:.3f}e-10 C,\ntime scale {scale:.3g}")
        ax.plot(curve.days, 100 * curve.y, ls="", marker="^" if curve.made_up else "o", ms=3.2, mfc="white",
                mec="#D55E00" if curve.made_up else "black", mew=0.8, zorder=3, label=curve.says)
        ax.set_xlim(0, max(days[-1], curve.days[-1]))
        ax.set_ylim(0, 1.03 * max(100.0, 100 * float(np.max(curve.y))))
        print_figure.letter(ax, "abcd"[k], sample.upper())
        ax.legend(loc="upper right")
        if curve.made_up:
            ax.text(0.5, 0.04, "MADE-UP DATA", transform=ax.transAxes, ha="center", va="bottom", color="#D55E00",
                    fontweight="bold", fontsize=9)
        said.append(f"{sample.upper()} {scale:.3g}, rms {100 * off:.2g} %")
    for ax in axes[:, 0]:
        ax.set_ylabel("upper interface over its\nheight at the start [%]")
    for ax in axes[1]:
        ax.set_xlabel("time in the laboratory [days]")
    against = "made-up data"
    if data:
        against = "curves from the laboratory" + (", where there are," if invented else "")
    caption = (f"The four samples' runs against {against} with the charges of Table 5 and the time scale that "
               f"brings each run nearest to its data ({'; '.join(said)}; the paper's is 9.49e5): {_shared(runs)}. ")
    if invented:
        caption += ("Triangles: MADE-UP data, not measured. This project made them by a run of the same sample with "
                    f"another packing (seed {labcurve.MADE_SEED}), time scale {runs[0].values['time_scale']:.3g}, and "
                    f"noise of {1e3 * labcurve.MADE_NOISE:g} mm: they show how such a comparison looks, and how far "
                    "packings differ. The paper's own data are not published; nothing here is compared with them.")
    return fig, caption


def draw(number, made, options):
    return _ten(made) if number == 10 else _eleven(made, options.data or {})
