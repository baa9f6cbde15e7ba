# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of a run: settling.png and columns.png."""

import math
import os
from dataclasses import dataclass

import numpy as np

from cases.lib.case import files, openfoam
from cases.lib.case.errors import CaseError
from cases.lib.output import spheres
from cases.lib.output.plotting import mpl, plt, titled, wrapped

DAY = 86400.0


def settling(folder, curve, time_scale, title):
    """The settling curve over seconds simulated and, with a time_scale, days in the laboratory."""
    fig, ax = plt.subplots(figsize=(7, 4.6))
    t = curve["time_s"]
    for key, label, style in (("interface_m", "upper interface", "-"),
                              ("mean_height_m", "mean height", "--"),
                              ("bed_m", "top of the bed (solid fraction of 0.2)", ":")):
        if key in curve:
            ax.plot(t, 1e3 * curve[key], style, label=label, lw=1.6)
    ax.set_xlabel("time simulated [s]")
    ax.set_ylabel("height [mm]")
    ax.set_xlim(0, t[-1])
    ax.set_ylim(bottom=0)
    if time_scale:
        scale = time_scale / DAY
        days = ax.secondary_xaxis("top", functions=(lambda x: x * scale, lambda x: x / scale))
        days.set_xlabel(f"time in the laboratory [days], scaled by {time_scale:.3g}")
    ax.grid(alpha=0.3)
    ax.legend()
    titled(ax, title, pad=10)
    fig.tight_layout()
    with files.fresh(os.path.join(folder, "settling.png")) as part:
        fig.savefig(part, dpi=150)
    plt.close(fig)


def _cut(case, folder, radius, height, centres):
    """Velocity in the plane y = 0: speed as an image, arrows at every layer."""
    from scipy.spatial import cKDTree
    velocity = openfoam.internal_field(os.path.join(folder, "U"), len(centres))
    tree = cKDTree(centres)
    x = (np.arange(60) + 0.5) / 60 * 2 * radius - radius
    z = (np.arange(240) + 0.5) / 240 * height
    grid = np.array([[a, 0.0, b] for b in z for a in x])
    cell = tree.query(grid)[1]
    speed = np.linalg.norm(velocity, axis=1)[cell].reshape(len(z), len(x))
    ax, az = np.meshgrid(np.linspace(-0.8, 0.8, 5) * radius, (np.arange(18) + 0.5) / 18 * height)
    near = tree.query(np.column_stack([ax.ravel(), 0 * ax.ravel(), az.ravel()]))[1]
    arrows = velocity[near]
    return speed, ax, az, arrows[:, 0].reshape(ax.shape), arrows[:, 2].reshape(ax.shape)


def telling(folder, times, count):
    """Indices of `count` of the times [s] at equal distances along the curve of
    mean height over time, both in parts of the whole: many while the clay
    falls, few while it rests. The first and the last time are among them."""
    rows = np.genfromtxt(os.path.join(folder, "settling.csv"), delimiter=",", names=True)
    if len(times) <= count or rows.size < 2:
        return np.arange(len(times))
    height = np.interp(times, rows["time_s"], rows["mean_height_m"])
    way = np.diff(times) / np.ptp(times) + np.abs(np.diff(height)) / max(np.ptp(height), 1e-12)
    way = np.concatenate([[0.0], np.cumsum(way)])
    return np.unique([np.abs(way - s).argmin() for s in np.linspace(0, way[-1], count)])


@dataclass(frozen=True)
class Moment:
    """The column at one time [s]: its spheres, and a cut of the flow."""

    time: float
    spheres: dict
    flow: tuple

    @property
    def top_speed(self):
        return float(self.flow[0].max())


def moments(folder, values, count, torn=False):
    """The Moments of a run that tell most, the first and the last among them; torn: without those
    whose files are not whole."""
    step, cfd = values["dem_step"], os.path.join(folder, "CFD")
    dumps, flows = spheres.dumps(folder), openfoam.times(cfd)
    if not flows:
        raise CaseError(f"{cfd} holds no output times of the CFD half")
    centres = openfoam.cell_centres(os.path.join(cfd, "constant", "polyMesh"))
    found = []
    for i in telling(folder, [n * step for n, _ in dumps], count):
        number, path = dumps[i]
        nearest = min(flows, key=lambda f: abs(f[0] - number * step))
        try:
            found.append(Moment(number * step, spheres.read(path),
                                _cut(cfd, nearest[1], values["tube_radius"], values["tube_height"], centres)))
        except (CaseError, OSError):
            if not torn:
                raise
    if not found:
        raise CaseError(f"{folder}: holds no moment of both halves that is whole")
    return found


def pair(left, right, moment, values, top, colours=None, pixels=8000.0):
    """Draws a Moment into two axes, spheres and flow, colours up to the speed
    `top` [m/s]; returns the image of the flow."""
    radius, height = values["tube_radius"], values["tube_height"]
    image, extent = spheres.picture(moment.spheres, radius, height, pixels, colours=colours)
    left.imshow(image, origin="lower", extent=extent, interpolation="antialiased")
    left.plot([-radius, -radius, radius, radius], [height, 0, 0, height], color="0.4", lw=0.7)
    speed, x, z, u, w = moment.flow
    shown = right.imshow(1e3 * speed, origin="lower", extent=(-radius, radius, 0, height),
                         cmap="viridis", vmin=0, vmax=1e3 * top, interpolation="nearest")
    right.quiver(x, z, u, w, color="white", scale=5 * top, width=0.03, pivot="middle")
    for a in (left, right):
        a.set_xlim(-1.05 * radius, 1.05 * radius)
        a.set_ylim(-0.02 * height, 1.02 * height)
        a.set_aspect("equal")
        a.axis("off")
    return shown


def _scales(left, right, height, top):
    """Millimetres beside the first pane, the length of an arrow of half the speed `top` [m/s] above the last."""
    left.axis("on")
    left.spines[["top", "right", "bottom"]].set_visible(False)
    left.spines["left"].set_bounds(0, height)
    left.set_xticks([])
    left.yaxis.set_major_locator(mpl.ticker.MultipleLocator(0.1 * 10**math.floor(math.log10(2 * height))))
    left.yaxis.set_major_formatter(lambda z, _: f"{1e3 * z:.4g}")
    left.set_ylabel("height [mm]")
    arrows = next(c for c in right.collections if isinstance(c, mpl.quiver.Quiver))
    speed = float(f"{0.5 * top:.1g}")
    right.quiverkey(arrows, 0.5, 1.03, speed, f"{1e3 * speed:.3g} mm/s", color="black", labelpos="N",
                    fontproperties={"size": 7})


def columns(folder, values, title, time_scale=None, count=6, torn=False):
    """The column at six times, with a time_scale in days, too: clumps, and beside them a cut of the flow."""
    chosen = moments(folder, values, count, torn)
    top = max(m.top_speed for m in chosen) or 1e-12

    # panes as wide as the tube drawn to scale, room above for the times
    wide = 0.95
    tall = 0.92 * wide * values["tube_height"] / (2 * values["tube_radius"]) + 0.75
    fig, axes = plt.subplots(1, 2 * len(chosen), figsize=(2.1 * wide * len(chosen), tall),
                             gridspec_kw={"wspace": 0.08, "left": 0, "right": 0.94, "bottom": 0,
                                          "top": 1 - 0.7 / tall})
    for k, moment in enumerate(chosen):
        shown = pair(axes[2 * k], axes[2 * k + 1], moment, values, top)
        days = f"\n{moment.time * time_scale / DAY:.3g} d" if time_scale else ""
        axes[2 * k].set_title(f"{moment.time:.3g} s{days}", fontsize=9, loc="left")
    _scales(axes[0], axes[-1], values["tube_height"], top)
    bar = fig.colorbar(shown, cax=fig.add_axes([0.95, 0.02, 0.009, 0.9 - 0.7 / tall]))
    bar.set_label("fluid speed in the plane y = 0 [mm/s]")
    fig.suptitle(wrapped(title, fig.get_size_inches()[0]), fontsize=9, y=0.995)
    with files.fresh(os.path.join(folder, "columns.png")) as part:
        fig.savefig(part, dpi=170, bbox_inches="tight")
    plt.close(fig)
