# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Figures 2 and 4: what the tube holds at the start."""

import numpy as np

from cases.lib.figures import print_figure
from cases.lib.output import spheres

_MOMENT = 1e-3  # [s] a run just long enough to write its first state
_SAND = np.array([0.90, 0.78, 0.55])
_IDS = "plasma"
_CLUMPS = 200  # of Figure 2


def wanted(number, options):
    short = {"end": _MOMENT, "frames": 1}
    if number == 2:
        return {"spheres": ("sphere-half", {**short, "packing": "expansion"}),
                "clumps": ("clump-half", {**short, "packing": "packmol", "clumps": _CLUMPS})}
    return {"full": ("clump-full", {**short, "packing": "packmol"}),
            "half": ("clump-half", {**short, "packing": "packmol"})}


def _ids(s):
    """Colours of the spheres by the number of their clump, and the mappable."""
    body = s["mol"]
    norm = print_figure.mpl.colors.Normalize(body.min(), body.max())
    # the map's dark end would swallow the shading
    cmap = print_figure.mpl.colors.LinearSegmentedColormap.from_list(
        "ids", print_figure.mpl.colormaps[_IDS](np.linspace(0.12, 1, 256)))
    return cmap(norm(body))[:, :3], print_figure.mpl.cm.ScalarMappable(norm, cmap)


def _tube(ax, run, colours, s, pixels, top=None):
    """The spheres in their tube, up to the height `top` [m]."""
    radius, height = run.values["tube_radius"], run.values["tube_height"]
    image, extent = spheres.picture(s, radius, height, pixels, colours=colours)
    ax.imshow(image, origin="lower", extent=extent, interpolation="antialiased")
    ax.plot([-radius, -radius, radius, radius], [height, 0, 0, height], color="0.4", lw=0.7)
    ax.set_xlim(-1.05 * radius, 1.05 * radius)
    ax.set_ylim(-0.02 * (top or height), (1.02 if top is None else 1.0) * (top or height))
    ax.set_aspect("equal")
    ax.set_anchor("S")
    ax.axis("off")


def _axes(fig, left, width, height, total):
    """Axes at `left`, of that size [mm], 2 mm above the figure's lower edge."""
    return fig.add_axes([left / print_figure.WIDTH, 2 / total, width / print_figure.WIDTH, height / total])


def _bar(fig, at, which, total, label):
    bar = fig.colorbar(which, cax=_axes(fig, at, 2.5, 70, total))
    bar.set_label(label)
    bar.ax.grid(False)


def _two(made):
    """Figure 2: columns, and beside each its lower part enlarged."""
    total = 105.0
    fig = print_figure.blank(total)
    for k, (label, says) in enumerate((("spheres", "spheres, radial expansion"), ("clumps", "clumps, packmol"))):
        run = made[label]
        s = spheres.read(spheres.dumps(run.folder)[0][1])
        if label == "spheres":
            colours = np.tile(_SAND, (len(s["id"]), 1))
        else:
            colours, which = _ids(s)
        left = 3 + 76 * k
        whole = _axes(fig, left, 22, 95, total)
        _tube(whole, run, colours, s, 9000)
        part = _axes(fig, left + 25, 47, 95, total)
        _tube(part, run, colours, s, 14000, 0.45 * run.values["tube_height"])
        whole.set_title(f"({'ab'[k]}) {says}", loc="left")
    _bar(fig, 154, which, total, "number of the clump")
    a, b = made["spheres"].values, made["clumps"].values
    return fig, (
        f"Packings in the half-size tube ({2e3 * a['tube_radius']:.1f} mm by {1e3 * a['tube_height']:.0f} mm), at the "
        f"right of each its lower 45 % enlarged. (a) {a['spheres']:.0f} spheres of {1e3 * a['sphere_radius']:.0f} mm "
        f"radius, solid fraction {a['solid_fraction']:.4f}, by radial expansion, seed {a['seed']}. (b) "
        f"{b['clumps']:.0f} clumps of 14 spheres, coloured by their number, half illite and half kaolinite, solid "
        f"fraction {b['solid_fraction']:.4f}, by packmol, seed {b['seed']}. The state at the start of the runs "
        f"sphere-half and clump-half (packing=packmol, clumps={b['clumps']:.0f}).")


def _four(made):
    """Figure 4: the two sizes at one scale, and the small one enlarged."""
    total = 134.0
    fig = print_figure.blank(total)
    tall = 120.0  # [mm] the full size column
    full, half = made["full"], made["half"]
    scale = tall / full.values["tube_height"]
    left = 6.0
    for k, (run, says, factor) in enumerate(((full, "full size", 1.0), (half, "half size, same scale", 1.0),
                                             (half, "half size, twice the scale", 2.0))):
        v = run.values
        s = spheres.read(spheres.dumps(run.folder)[0][1])
        colours, which = _ids(s)
        wide = 2.1 * v["tube_radius"] * scale * factor
        ax = _axes(fig, left, wide, 1.04 * v["tube_height"] * scale * factor, total)
        _tube(ax, run, colours, s, 9000 if run is full else 14000)
        ax.set_title(f"({'abc'[k]}) {says}", loc="left")
        left += wide + (3 if k != 1 else 34)
        if k != 1:
            _bar(fig, left, which, total, "number of the clump")
            left += 24
    a, b = full.values, half.values
    return fig, (
        f"Full and half size column with their clumps at the start, coloured by the clump's number. (a) "
        f"{2e3 * a['tube_radius']:.0f} mm by {1e3 * a['tube_height']:.0f} mm, {a['clumps']:.0f} clumps = "
        f"{full.summary['particles']} spheres, solid fraction {a['solid_fraction']:.4f}; (b, c) "
        f"{2e3 * b['tube_radius']:.1f} mm by {1e3 * b['tube_height']:.0f} mm, {b['clumps']:.0f} clumps = "
        f"{half.summary['particles']} spheres, solid fraction {b['solid_fraction']:.4f}. Packed by packmol, seed "
        f"{a['seed']}: the state at the start of the runs clump-full and clump-half with packing=packmol.")


def draw(number, made, options):
    return (_two if number == 2 else _four)(made)
