# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A figure for print: 170 mm wide, its caption below, as PNG, PDF and text."""

import os

import numpy as np

from cases.lib.output import pictures
from cases.lib.output.plotting import mpl, plt

MM = 1 / 25.4
WIDTH = 170.0  # [mm]
DPI = 300
SMALLEST = 8.0  # [pt]

#: Colours of Okabe and Ito (2008) that the colour-blind tell apart, each with a
#: line of its own, for grey prints.
LINES = ({"color": "#000000", "ls": "-"}, {"color": "#D55E00", "ls": "--"},
         {"color": "#0072B2", "ls": "-."}, {"color": "#009E73", "ls": (0, (1, 1.2))},
         {"color": "#CC79A7", "ls": (0, (5, 1.5, 1, 1.5, 1, 1.5))})
GREY = "0.45"
_STYLE = {"font.size": 8.5, "axes.labelsize": 8.5, "axes.titlesize": 8.5, "legend.fontsize": 8.0,
          "xtick.labelsize": 8.0, "ytick.labelsize": 8.0, "figure.titlesize": 8.5, "lines.linewidth": 1.4,
          "axes.linewidth": 0.6, "xtick.major.width": 0.6, "ytick.major.width": 0.6, "axes.grid": True,
          "grid.alpha": 0.35, "grid.linewidth": 0.4, "pdf.fonttype": 42, "legend.framealpha": 0.9,
          "mathtext.default": "regular"}
_LINE, _SPACING = 3.4, 1.25  # [mm] a line of the caption, and what makes it so


def blank(height):
    """An empty figure of that height [mm] without its caption."""
    mpl.rcParams.update(_STYLE)
    return plt.figure(figsize=(WIDTH * MM, height * MM))


def sheet(height, rows=1, columns=1, **more):
    """A figure of that height [mm] without its caption, and its axes."""
    mpl.rcParams.update(_STYLE)
    return plt.subplots(rows, columns, figsize=(WIDTH * MM, height * MM), layout="constrained", **more)


def days_above(ax, time_scale, label="time in the laboratory [days]"):
    """Days in the laboratory along the top of an axis of seconds simulated."""
    scale = time_scale / pictures.DAY
    days = ax.secondary_xaxis("top", functions=(lambda x: x * scale, lambda x: x / scale))
    days.set_xlabel(label)
    return days


def letter(ax, which, says=""):
    """(a) and what it shows, above an axis at its left."""
    ax.set_title(f"({which}) {says}".rstrip(), loc="left")


def _wrapped(fig, words):
    """The caption's lines, none wider than the page."""
    renderer, font = fig.canvas.get_renderer(), mpl.font_manager.FontProperties(size=SMALLEST)
    room = (WIDTH - 5.0) * MM * fig.dpi
    lines = [""]
    for word in words.split():
        longer = f"{lines[-1]} {word}".lstrip()
        if renderer.get_text_width_height_descent(longer, font, ismath=False)[0] > room:
            lines.append(word)
        else:
            lines[-1] = longer
    return lines


def _with_caption(fig, words):
    """Makes room below for the caption, keeps all else where it is."""
    fig.canvas.draw()
    fig.set_layout_engine("none")
    width, height = fig.get_size_inches()
    lines = _wrapped(fig, words)
    room = (len(lines) * _LINE + 4.0) * MM
    places = [(ax, ax.get_position(original=True)) for ax in fig.axes]
    fig.set_size_inches(width, height + room)
    part = height / (height + room)
    for ax, at in places:
        ax.set_position([at.x0, 1 - part + part * at.y0, at.width, part * at.height])
    fig.text(2.5 / WIDTH, 1.5 * MM / (height + room), "\n".join(lines), fontsize=SMALLEST, parse_math=False,
             va="bottom", ha="left", linespacing=_SPACING)


def save(fig, folder, name, caption):
    """NAME.png, NAME.pdf and NAME.txt; returns the picture's path."""
    os.makedirs(folder, exist_ok=True)
    words = " ".join(caption.split())
    _with_caption(fig, words)
    path = os.path.join(folder, name)
    fig.savefig(path + ".png", dpi=DPI)
    fig.savefig(path + ".pdf", dpi=DPI, metadata={"CreationDate": None})
    plt.close(fig)
    with open(path + ".txt", "w", encoding="utf-8") as f:
        f.write(words + "\n")
    return path + ".png"


def smallest_text(fig):
    """The size [pt] of the smallest text that shows."""
    found = [t.get_fontsize() for t in fig.findobj(mpl.text.Text) if t.get_visible() and t.get_text().strip()]
    return min(found) if found else np.inf
