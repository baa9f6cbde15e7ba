# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Run time against error as a picture."""

from cases.lib.output.plotting import plt

_COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#8C564B", "#7F7F7F", "#BCBD22",
            "#17BECF")
_MARKS = "osD^vPX<>*"


def draw(path, rows):
    """A panel a case: wall time over the baseline's against the curve's error."""
    cases = list(dict.fromkeys(r["case"] for r in rows))
    fig, axes = plt.subplots(1, len(cases), figsize=(6.4 * len(cases), 5.2), squeeze=False, layout="constrained")
    names = list(dict.fromkeys(r["setting"] for r in rows if r["setting"] != "baseline"))
    for ax, case in zip(axes[0], cases):
        mine = [r for r in rows if r["case"] == case and r["error"] is not None and r["wall_ratio"] is not None]
        floor = next((r["seed_spread"] for r in mine if r["seed_spread"]), None)
        for k, name in enumerate(names):
            part = [r for r in mine if r["setting"] == name]
            if part:
                ax.scatter([r["wall_ratio"] for r in part], [100 * r["error"] for r in part], s=42,
                           c=_COLOURS[k % len(_COLOURS)], marker=_MARKS[k % len(_MARKS)], label=name, zorder=3,
                           edgecolors="white", lw=0.5)
            for r in part:
                ax.annotate(_short(r["value"]), (r["wall_ratio"], 100 * r["error"]), fontsize=6.5, color="0.3",
                            xytext=(4, 3), textcoords="offset points")
        for r in mine:
            if r["setting"] == "baseline":
                ax.scatter(r["wall_ratio"], 100 * r["error"], s=120, marker="*", c="black", label="as shipped",
                           zorder=4)
        on = sorted((r["wall_ratio"], 100 * r["error"]) for r in mine if r["on_front"])
        if on:
            ax.step([x for x, _ in on], [y for _, y in on], where="post", color="black", lw=1, label="front", zorder=1)
        if floor:
            ax.axhline(100 * floor, color="0.5", lw=0.8, ls="--", label="spread of the seeds")
        ax.axhline(1, color="#D55E00", lw=0.8, ls=":", label="1 %")
        ax.set_xscale("log")
        if any(r["error"] > 0 for r in mine):
            ax.set_yscale("log")
        for axis in (ax.xaxis, ax.yaxis):
            axis.set_major_formatter("{x:g}")
            axis.set_minor_formatter("{x:g}")
        ax.tick_params(which="minor", labelsize=7)
        ax.set_xlabel("wall time over that of the shipped settings")
        ax.set_ylabel("error of the settling curve [% of what has sunk]")
        ax.set_title(case, fontsize=10)
        ax.grid(alpha=0.3, lw=0.4, which="both")
        ax.legend(fontsize=7)
    fig.savefig(path, dpi=140)
    plt.close(fig)


def draw_skips(path, rows):
    """Bars of what each skip gains, with the error beside."""
    rows = [r for r in rows if r["gain"]][::-1]
    fig, ax = plt.subplots(figsize=(9, 0.42 * len(rows) + 1.4), layout="constrained")
    for k, r in enumerate(rows):
        ax.barh(k, r["gain"] - 1, left=1, color=_COLOURS[0] if r["gain"] >= 1 else _COLOURS[1], height=0.6)
        error = "same to the bit" if r["error"] == 0 else f"error {100 * r['error']:.2g} %"
        if r["error_of"] == "scene" and r["error"] > 0:
            error = f"curve {100 * r['error']:.2g} % off: another scene"
        ax.annotate(f"{r['gain']:.2f}   {error}", (max(r["gain"], 1), k), xytext=(5, 0), textcoords="offset points",
                    va="center", fontsize=8)
    ax.set_yticks(range(len(rows)), [f"{r['feature']}, {r['scene']}" for r in rows], fontsize=8)
    ax.axvline(1, color="black", lw=0.8)
    ax.set_xscale("log")
    ax.set_xlim(min(0.8, *(0.9 * r["gain"] for r in rows)), 3 * max(2, *(r["gain"] for r in rows)))
    ax.xaxis.set_major_formatter("{x:g}")
    ax.xaxis.set_minor_formatter("{x:g}")
    ax.tick_params(axis="x", which="minor", labelsize=7)
    ax.set_xlabel("gain: time with the work done over time with it skipped")
    ax.grid(axis="x", alpha=0.3, lw=0.4, which="both")
    ax.set_axisbelow(True)
    fig.savefig(path, dpi=140)
    plt.close(fig)


def _short(value):
    return value if isinstance(value, str) else f"{value:.3g}"
