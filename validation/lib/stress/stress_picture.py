# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The stability map as a picture."""

from cases.lib.output.plotting import plt

_LOOKS = {"bounded": ("#0072B2", "o", 14), "refused": ("#E69F00", "^", 20), "failed": ("#D55E00", "X", 46)}
_PLANES = (("step_ratio", "DEM step / limit", "interval_reached", "coupling interval / relaxation time"),
           ("density_ratio", "density solid / fluid", "interval_reached", "coupling interval / relaxation time"),
           ("cell", "cell / diameter", "solids_reached", "solid fraction"),
           ("stiffness", "stiffness [N/m]", "charge_factor", "charge / the paper's"),
           ("viscosity", "viscosity [Pa s]", "diameter", "diameter [m]"),
           ("jump", "inlet velocity / terminal", "solids_reached", "solid fraction"))


def draw(path, rows):
    """Planes of two parameters each, a mark a run."""
    fig, axes = plt.subplots(2, 3, figsize=(12, 7.6), layout="constrained")
    for ax, (x, xlabel, y, ylabel) in zip(axes.flat, _PLANES):
        for outcome, (colour, mark, size) in _LOOKS.items():
            part = [r for r in rows if r["outcome"] == outcome and x in r and y in r]
            ax.scatter([r[x] for r in part], [r[y] for r in part], c=colour, marker=mark, s=size, lw=0.4,
                       edgecolors="white", label=outcome, zorder=2 + (outcome != "bounded"))
        for scale, limits, axis, key in ((ax.set_xscale, ax.set_xlim, ax.xaxis, x),
                                         (ax.set_yscale, ax.set_ylim, ax.yaxis, y)):
            if key in ("charge_factor", "jump"):
                scale("symlog", linthresh=0.1)
                limits(-0.03)
            else:
                scale("log")
            if key in ("cell", "density_ratio"):
                axis.set_major_formatter("{x:g}")
                axis.set_minor_formatter("{x:g}")
        ax.set_xlabel(xlabel)
        ax.set_ylabel(ylabel)
        ax.grid(alpha=0.3, lw=0.4)
    counts = ", ".join(f"{sum(r['outcome'] == o for r in rows)} {o}" for o in _LOOKS)
    handles, labels = axes.flat[0].get_legend_handles_labels()
    fig.legend(handles, labels, loc="upper right", ncols=3, fontsize=9)
    fig.suptitle(f"{len(rows)} coupled runs: {counts}", x=0.02, ha="left", fontsize=11)
    fig.savefig(path, dpi=130)
    plt.close(fig)
