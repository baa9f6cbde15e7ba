# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of a calibration: the measured curve, the fitted one, its band."""

import numpy as np

from cases.lib.calibration import calloop
from cases.lib.calibration.caldata import DAY
from cases.lib.output.plotting import plt


def draw(path, r, data, made):
    """r: the report; left the curves, right the charge's and the scale's region."""
    f, e = made.fit, made.problem.e
    fig, (ax, plane) = plt.subplots(1, 2, figsize=(10.5, 4.8), width_ratios=(1.7, 1), layout="constrained")
    last = r["end_of_consolidation"]
    why = calloop.unpredictable(made)
    far = data.days[-1] if why else max(data.days[-1], e.end * f.s / DAY)
    days = np.linspace(0.0, far, 500)
    middle, low, high = (100 * c for c in calloop.band(made, days))
    end = data.days[data.used][-1]
    shown = days <= end if why else days < np.inf
    ax.fill_between(days[shown], low[shown], high[shown], color="tab:blue", alpha=0.18, lw=0,
                    label=f"{100 * f.level:.0f} % band")
    fitted = days <= end
    ax.plot(days[fitted], middle[fitted], color="tab:blue", lw=1.6, label="fitted")
    if np.any(~fitted) and not why:
        ax.plot(days[~fitted], middle[~fitted], "--", color="tab:blue", lw=1.6, label="predicted")
    ax.plot(data.days, 100 * data.y, "o", ms=3, color="black", mfc="none", label="measured")
    for b in data.breaks[:2]:
        ax.axvline(b, color="0.7", lw=0.8, ls=":")
    if last["days"]:
        ax.axvline(last["days"], color="tab:red", lw=1.1,
                   label=f"end of consolidation, day {last['days']:.3g}")
        if last["low"] is not None:
            ax.axvspan(last["low"], last["high"], color="tab:red", alpha=0.1, lw=0)
    ax.set_xlim(0, max(far, min(1.1 * (last["high"] or 0), 3 * far)))
    ax.set_ylim(0, None)
    ax.set_xlabel("time in the laboratory [days]")
    ax.set_ylabel("height over that at the start [%]")
    ax.grid(alpha=0.3)
    ax.legend(fontsize=8)

    if f.known:
        q, logs, half = f.region.T
        plane.fill_between(q, np.exp(logs - half), np.exp(logs + half), color="tab:blue", alpha=0.25, lw=0,
                           label=f"{100 * f.level:.0f} % region")
        plane.plot(q, np.exp(logs), "-", color="tab:blue", lw=0.8)
    plane.plot(f.q, f.s, "o", color="tab:blue", label="estimate")
    tried = np.array(made.charges)
    lower = f.s_interval[0] if f.known else 0.9 * f.s
    plane.plot(tried, np.full(len(tried), lower - 0.06 * ((f.s_interval[1] if f.known else 1.1 * f.s) - lower)),
               "|", color="0.3", ms=9, label="charges run")
    plane.set_xlabel("charge [C]")
    plane.set_ylabel("time scale")
    plane.grid(alpha=0.3)
    plane.legend(fontsize=8)
    fig.suptitle(f"{r['case']}: charge {f.q:.3g} C, {r['charge']['says']}; time scale {f.s:.3g}, "
                 f"{r['time_scale']['says']}", fontsize=9)
    fig.savefig(path, dpi=150)
    plt.close(fig)
