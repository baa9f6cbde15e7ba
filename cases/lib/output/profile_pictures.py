# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of a run's profiles: profile_map.png, solid fraction over height
and time, and profile_stress.png, what carries the weight at six times."""

import os

import numpy as np

from cases.lib.case import files
from cases.lib.output import pictures
from cases.lib.output.plotting import plt, wrapped
from cases.lib.theory import carrying

_ISOLINES = (0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5)
_TIMES = 6


def _save(fig, path):
    with files.fresh(path) as part:
        fig.savefig(part, dpi=150)
    plt.close(fig)


def _edges(middles):
    """Borders of cells around middles."""
    if len(middles) < 2:
        return np.array([0.0, 2 * middles[0] if middles[0] > 0 else 1.0])
    inner = 0.5 * (middles[1:] + middles[:-1])
    return np.concatenate([[middles[0] - (inner[0] - middles[0])], inner, [2 * middles[-1] - inner[-1]]])


def space_time(folder, columns, curve, title):
    """Solid fraction over time and height with its isolines, interface, bed and the front of consolidation."""
    t, z, phi = columns["time_s"], 1e3 * columns["height_m"], columns["solid_fraction"]
    fig, ax = plt.subplots(figsize=(7.6, 4.8))
    image = ax.pcolormesh(np.clip(_edges(t), t[0], t[-1]) if len(t) > 1 else _edges(t), _edges(z), phi.T,
                          cmap="cividis_r", vmin=0, vmax=max(0.1, float(phi.max())), rasterized=True)
    if len(t) > 2 and len(z) > 2:
        kernel = np.array([0.25, 0.5, 0.25])
        smooth = np.apply_along_axis(lambda a: np.convolve(np.pad(a, 1, mode="edge"), kernel, mode="valid"), 0,
                                     carrying.smoothed(phi))
        levels = [v for v in _ISOLINES if v < smooth.max()]
        if levels:
            lines = ax.contour(t, z, smooth.T, levels=levels, colors="0.25", linewidths=0.6)
            ax.clabel(lines, fontsize=7, fmt="%g")
    ax.plot(curve["time_s"], 1e3 * curve["interface_m"], color="#D55E00", lw=1.6, label="upper interface")
    ax.plot(curve["time_s"], 1e3 * curve["bed_m"], color="#0072B2", lw=1.4, ls="--", label="top of the bed")
    if len(t) > 2:
        _, fronts, *_ = carrying.of_profile(columns)
        ax.plot(t, 1e3 * fronts, color="white", lw=2.6)
        ax.plot(t, 1e3 * fronts, color="black", lw=1.2, ls="-.", label="stresses carry over half, below")
    ax.set_xlim(t[0], t[-1])
    ax.set_ylim(0, _edges(z)[-1])
    ax.set_xlabel("time simulated [s]")
    ax.set_ylabel("height [mm]")
    fig.colorbar(image, label="solid fraction")
    ax.legend(fontsize=8, loc="upper right")
    # over the whole figure: the scale beside the pane leaves it narrower
    fig.suptitle(wrapped(title, fig.get_size_inches()[0]), fontsize=9)
    fig.tight_layout()
    _save(fig, os.path.join(folder, "profile_map.png"))


def stresses(folder, columns, title):
    """Effective stress, charges' part, excess pore pressure, walls and weight over height, at six times."""
    t, z = columns["time_s"], 1e3 * columns["height_m"]
    inside = np.arange(1, len(t)) if len(t) > 1 else np.arange(1)
    chosen = inside[pictures.telling(folder, t[inside], _TIMES)]
    smooth = {name: carrying.smoothed(columns[name]) for name in
              ("contact_Pa", "coulomb_Pa", "wall_Pa", "excess_pressure_Pa", "weight_Pa")}
    fig, axes = plt.subplots(2, 3, figsize=(9.6, 6.6), sharex=True, sharey=True)
    top = 1.15 * max(1e-9, float(np.max(smooth["weight_Pa"])))
    for ax, k in zip(axes.flat, chosen):
        ax.plot(smooth["weight_Pa"][k], z, color="black", lw=1.2, label="buoyant weight above")
        ax.plot(smooth["contact_Pa"][k] + smooth["coulomb_Pa"][k], z, color="#D55E00", lw=1.8,
                label="effective stress: contacts and charges")
        ax.plot(smooth["coulomb_Pa"][k], z, color="#D55E00", lw=1.0, ls=":", label="charges' part of it")
        ax.plot(smooth["excess_pressure_Pa"][k], z, color="#0072B2", lw=1.8, ls="--", label="excess pore pressure")
        ax.plot(smooth["wall_Pa"][k], z, color="0.5", lw=1.2, ls="-.", label="held by the walls")
        ax.set_title(f"{t[k]:.3g} s", fontsize=9)
        ax.grid(alpha=0.3)
        ax.set_xlim(-0.15 * top, top)
        ax.set_ylim(0, _edges(z)[-1])
    for ax in axes.flat[len(chosen):]:
        ax.set_axis_off()
    for ax in axes[-1]:
        ax.set_xlabel("stress [Pa]")
    for ax in axes[:, 0]:
        ax.set_ylabel("height [mm]")
    handles, labels = axes.flat[0].get_legend_handles_labels()
    fig.legend(handles, labels, fontsize=8, ncol=3, loc="lower center")
    fig.suptitle(wrapped(title, fig.get_size_inches()[0]), fontsize=9)
    fig.tight_layout(rect=(0, 0.075, 1, 1))
    _save(fig, os.path.join(folder, "profile_stress.png"))
