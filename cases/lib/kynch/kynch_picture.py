# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of cases/kynch: curves with characteristics, and the flux."""

import numpy as np

from cases.lib.output.plotting import plt

_RUN, _BED, _THEORY = "#0b5fa5", "#b3541e", "black"


def curves(path, column, measured, title):
    """Height over time: theory, its characteristics, and the runs over them."""
    k, rz, lag = column.kynch, column.kynch_rz, column.start.lag
    last = k.t_end if np.isfinite(k.t_end) else 2 * k.t_c
    end = 1.25 * (last + lag)
    fig, ax = plt.subplots(figsize=(7.2, 5.0))
    for line in k.characteristics(uniform=9, fan=6):
        if line.kind != "shock":
            ax.plot(line.t, 1e3 * np.array(line.z), color="0.72", lw=0.7, zorder=1)
    ax.plot([], [], color="0.72", lw=0.7, label="characteristics")
    t = np.linspace(0, end, 800)
    ax.plot(t, 1e3 * k.interface(t), color=_THEORY, lw=1.8, label="Kynch, flux of the drag law", zorder=4)
    ax.plot(t, 1e3 * k.bed(t), color=_THEORY, lw=1.8, zorder=4)
    for wave in k.bottom_waves[:-1]:
        if wave.kind == "shock":
            at = np.array([0.0, k._meets_interface(wave.speed_high)])
            ax.plot(at, 1e3 * wave.speed_high * at, color=_THEORY, lw=1.2, zorder=4)
    if measured:
        ax.plot(t, 1e3 * k.interface(column.late(t)), color=_THEORY, lw=1.3, ls=":", zorder=4,
                label="the same, started from rest")
        ax.plot(t, 1e3 * k.bed(column.late(t)), color=_THEORY, lw=1.3, ls=":", zorder=4)
    ax.plot(t, 1e3 * rz.interface(t), color="#3a7d44", lw=1.3, ls="--", zorder=3,
            label=f"Kynch, Richardson-Zaki n = {column.rz.exponent:.2f}")
    ax.plot(t, 1e3 * rz.bed(t), color="#3a7d44", lw=1.3, ls="--", zorder=3)
    if measured:
        _runs(ax, measured)
    ax.set_xlim(0, end)
    ax.set_ylim(0, 1.03e3 * column.height)
    ax.set_xlabel("time [s]")
    ax.set_ylabel("height [mm]")
    ax.set_title(f"{title}\nsolid fraction {column.phi_0:.4f}, bed {column.phi_m:.3f}, drag {column.law.name}",
                 fontsize=9)
    ax.legend(fontsize=8, framealpha=1, loc="upper right")
    fig.tight_layout()
    fig.savefig(path, dpi=180)
    plt.close(fig)


def _runs(ax, measured):
    """Every seed thin, their mean thick."""
    seeds = f"{len(measured)} seed" + ("s" if len(measured) > 1 else "")
    tops = [(m.record.t, m.record.top) for m in measured]
    shocks = [(m.t, m.interface) for m in measured]
    beds = [(m.t, m.bed) for m in measured]
    for group, colour, style, words in ((tops, "#6aa9dc", "-", "top of the solids"),
                                        (shocks, _RUN, "-", r"interface, $\phi_0/2$"),
                                        (beds, _BED, "-", "bed front")):
        for t, z in group:
            ax.plot(t, 1e3 * z, color=colour, lw=0.5, alpha=0.55, zorder=2)
        t = group[0][0]
        mean = np.mean([np.interp(t, a, z) for a, z in group], axis=0)
        ax.plot(t, 1e3 * mean, color=colour, lw=2.0, ls=style, zorder=5, label=f"{words}, {seeds}")


def flux(path, column, comparisons):
    """f(phi) of the drag law and of Richardson and Zaki, the waves of the
    column's lower hulls, and what runs of several solid fractions gave."""
    law, rz, k = column.law, column.rz, column.kynch
    fig, (ax, zoom) = plt.subplots(1, 2, figsize=(9.6, 4.2), gridspec_kw={"width_ratios": [1.6, 1]})
    phi = np.linspace(0, column.phi_m * (1 - 1e-9), 1500)
    f = 1e3 * law(phi)
    for jump in law.jumps:  # a gap, not a slope
        f = np.where(np.abs(phi - jump) < phi[1], np.nan, f)
    for a in (ax, zoom):
        a.plot(phi, f, color=_THEORY, lw=1.8, label=f"{law.name}: no fitted number")
        a.plot(phi, 1e3 * rz(phi), color="#3a7d44", lw=1.3, ls="--", label=f"Richardson-Zaki, n = {rz.exponent:.2f}")
        for number, wave in enumerate(w for w in k.bottom_waves if w.kind == "shock"):
            ends = np.array([wave.phi_low, wave.phi_high])
            a.plot(ends, 1e3 * np.interp(ends, k.phi, k.f), color=_BED, lw=1.2, marker="o", ms=3,
                   label=None if number else "shocks from the bottom: chords")
        a.plot([0, column.phi_0], [0, 1e3 * np.interp(column.phi_0, k.phi, k.f)], color=_RUN, lw=1.2,
               label="interface: chord from 0")
        for number, c in enumerate(comparisons):
            speed = c.row("interface_speed")
            a.errorbar(c.column.phi_0, 1e3 * c.column.phi_0 * speed["mean"],
                       1e3 * c.column.phi_0 * (speed["spread"] or 0.0), fmt="s", ms=5, mfc="none", color="#7a1fa2",
                       capsize=3, zorder=6, label=None if number else r"runs: $\phi_0$ times interface speed")
        a.set_xlabel(r"solid fraction $\phi$")
        a.grid(alpha=0.25)
    ax.axvline(column.phi_m, color="0.5", lw=0.8, ls=":")
    ax.annotate(r"bed $\phi_m$", (column.phi_m, 0.2 * np.nanmax(f)), xytext=(-4, 0), textcoords="offset points",
                ha="right", fontsize=8)
    ax.set_ylabel(r"flux $f = \phi\,v$ [mm/s]")
    ax.set_xlim(0, 1.05 * column.phi_m)
    ax.set_ylim(0, 1.45 * max(np.nanmax(f), np.max(1e3 * rz(phi))))
    ax.legend(fontsize=8, loc="upper right", framealpha=1)
    most = max([column.phi_0] + [c.column.phi_0 for c in comparisons])
    wide = min(1.8 * most, column.phi_m)
    zoom.set_xlim(0, wide)
    zoom.set_ylim(0, 1.25e3 * float(np.max(law(phi[phi < wide]))))
    zoom.set_title("about the initial solid fraction", fontsize=9)
    fig.tight_layout()
    fig.savefig(path, dpi=180)
    plt.close(fig)
