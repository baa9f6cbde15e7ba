# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of cases/consolidation: both laws with their points, computed settlement over the simulated one."""

import numpy as np

from cases.lib.case import files
from cases.lib.output.plotting import mpl, plt, wrapped

_COLOURS = ("#D55E00", "#0072B2")


def _law(ax, points, x, y, law, labels):
    """Points and law on logarithmic axes."""
    if points is not None:
        ax.plot(*points, ".", ms=2, color="0.6", alpha=0.5, rasterized=True, label="profile.csv")
    ax.plot(x, y, color="#D55E00", lw=1.8, label=law)
    ax.set(xscale="log", yscale="log")
    for axis, values in ((ax.xaxis, x), (ax.yaxis, y)):
        if np.max(values) < 500 * np.min(values) and np.min(values) > 0.01:  # else powers of ten suffice
            axis.set_major_locator(mpl.ticker.LogLocator(subs=(1, 2, 5)))
            axis.set_major_formatter(mpl.ticker.FormatStrFormatter("%g"))
        axis.set_minor_formatter(mpl.ticker.NullFormatter())
    ax.set_xlabel(labels[0])
    ax.set_ylabel(labels[1])
    ax.grid(alpha=0.3, which="both", lw=0.4)
    ax.legend(fontsize=8)


def draw(path, run, laws, fit, made):
    """Left the laws, right the curves."""
    fig = plt.figure(figsize=(10.4, 5.6))
    grid = fig.add_gridspec(2, 2, width_ratios=(1, 1.5))
    e, s = (fit.compression.e, fit.compression.value) if fit else (None, None)
    weight = float(np.max(run.columns["weight_Pa"]))
    stress = np.geomspace(*((np.min(s), np.max(s)) if fit else (0.02 * weight, weight)), 100)
    _law(fig.add_subplot(grid[0, 0]), (s, e) if fit else None, stress, laws.void_ratio(stress),
         f"{laws.a:.3g} (s + {laws.z:.2g} Pa)$^{{-{laws.b:.3g}}}$", ("effective stress s [Pa]", "void ratio e"))
    e, kappa = (fit.flow.e, fit.flow.value) if fit else (None, None)
    ratios = np.geomspace(*((np.min(e), np.max(e)) if fit else (1.0, 20.0)), 100)
    _law(fig.add_subplot(grid[1, 0]), (e, kappa) if fit else None, ratios, laws.permeability(ratios),
         f"{laws.c:.3g} m$^2$ e$^{{{laws.d:.3g}}}$", ("void ratio e", "permeability [m$^2$]"))
    ax = fig.add_subplot(grid[:, 1])
    ax.plot(run.curve["time_s"], 1e3 * run.curve["interface_m"], color="black", lw=2.4, label="simulated")
    for (name, curve), colour, line in zip(made.items(), _COLOURS, ("-", "--")):
        ax.plot(curve.times, 1e3 * curve.interface, color=colour, lw=1.6, ls=line, label=f"computed {name}")
        ax.axhline(1e3 * curve.final, color=colour, lw=0.7, ls=":")
        if curve.time_90 is not None and curve.time_90 <= run.curve["time_s"][-1]:
            at = np.interp(curve.time_90, curve.times, curve.interface)
            ax.plot(curve.time_90, 1e3 * at, "o", ms=5, mfc="white", color=colour)
    ax.axvline(run.stage, color="0.5", lw=0.8)
    ax.annotate("first stage ends", (run.stage, 0), xycoords=("data", "axes fraction"), xytext=(3, 6),
                textcoords="offset points", fontsize=8, color="0.3")
    ax.plot([], [], "o", ms=5, mfc="white", color="0.3", label="90 % of the fall")
    ax.plot([], [], color="0.3", lw=0.7, ls=":", label="at rest")
    ax.set_xlim(0, run.curve["time_s"][-1])
    ax.set_ylim(bottom=0)
    ax.set_xlabel("time simulated [s]")
    ax.set_ylabel("upper interface [mm]")
    ax.grid(alpha=0.3)
    ax.legend(fontsize=8)
    fig.suptitle(wrapped(run.title, fig.get_size_inches()[0]), fontsize=9)
    fig.tight_layout()
    with files.fresh(path) as part:
        fig.savefig(part, dpi=150, format="png")
    plt.close(fig)
