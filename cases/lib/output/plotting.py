# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Matplotlib as this project uses it: it draws into files, and its cache belongs
to the project, not into the user's home. Import it from here only."""

import os

from cases.lib.case import cache

os.environ.setdefault("MPLCONFIGDIR", cache.place("matplotlib"))

import matplotlib as mpl  # noqa: E402  (reads the folder of its cache when it is loaded)

mpl.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

__all__ = ["mpl", "plt"]
