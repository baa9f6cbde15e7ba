# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Matplotlib as this project uses it: it draws into files, and its cache belongs
to the project, not into the user's home. Import it from here only."""

import os
import textwrap

from cases.lib.case import cache

os.environ.setdefault("MPLCONFIGDIR", cache.place("matplotlib"))

import matplotlib as mpl  # noqa: E402  (reads the folder of its cache when it is loaded)

mpl.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

__all__ = ["mpl", "plt", "titled", "wrapped"]


def wrapped(title, inches, points=9):
    """A title in lines that fit a figure so wide, in letters of so many points."""
    return "\n".join(line for part in title.split("\n")
                     for line in textwrap.wrap(part, max(20, int(inches * 72 / (0.56 * points)))) or [""])


def titled(ax, title, points=9, **more):
    """Gives a pane its title, in lines that fit the figure."""
    return ax.set_title(wrapped(title, ax.figure.get_size_inches()[0], points), fontsize=points, **more)
