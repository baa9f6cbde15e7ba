# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the validation cases, all in one look."""

import os

from cases.lib.output.plotting import plt

STYLES = {"line": {"ls": "-", "lw": 1.6}, "dashed": {"ls": "--", "lw": 1.4, "color": "0.25", "zorder": 3},
          "dots": {"ls": "", "marker": "o", "ms": 4.5, "mfc": "none"}}


def compare(path, series, xlabel, ylabel, title, logx=False, logy=False):
    """Draws series [(label, x, y, style)], style one of STYLES, into path; the
    label may be None. Returns path."""
    fig, ax = plt.subplots(figsize=(6.4, 4.2))
    for label, x, y, style in series:
        ax.plot(x, y, label=label, **STYLES[style])
    if logx:
        ax.set_xscale("log")
    if logy:
        ax.set_yscale("log")
    ax.set_xlabel(xlabel)
    ax.set_ylabel(ylabel)
    ax.set_title(title, fontsize=9)
    ax.grid(alpha=0.3)
    if any(s[0] for s in series):
        ax.legend(fontsize=8)
    return save(fig, path)


def save(fig, path):
    """Writes a figure of one's own making; returns path."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    fig.tight_layout()
    fig.savefig(path, dpi=130)
    plt.close(fig)
    return path
