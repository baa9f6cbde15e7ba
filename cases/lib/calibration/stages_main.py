# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/stages: the near-linear stages of a run's or a measured settling curve."""

import argparse
import json
import os

import numpy as np

from cases.lib.calibration import curvefile, stagefit
from cases.lib.case import program, settings
from cases.lib.case.errors import CaseError, nearest
from cases.lib.case.places import called
from cases.lib.case.program import run as run_program

_TIMES = {"s": "s", "d": "d", "days": "d", "day": "d", "h": "h", "min": "min"}
_LEAST_ROWS = 12


def parser():
    p = argparse.ArgumentParser(
        prog=called("stages"), allow_abbrev=False,
        description="Finds the near-linear stages of a settling curve: breaks and slopes with confidence intervals.",
        epilog="A continuous line of 1 to 4 straight segments is fitted; how many there are is what the data can tell "
               "(BIC, with the noise's correlation), the intervals are a bootstrap's. The method is described in "
               "cases/lib/theory/stages.py.")
    p.add_argument("curve", metavar="FILE|DIR", help="a CSV of times and heights, or a run folder")
    p.add_argument("--data", metavar="TIME,HEIGHT", help="names of the columns (a run: time_s,interface_m; "
                                                         "a CSV of two columns: these)")
    p.add_argument("--most", type=int, default=4, metavar="N", help="greatest number of segments, 1 to 4 (4)")
    p.add_argument("--level", type=float, default=95.0, metavar="P", help="of the intervals, percent (95)")
    p.add_argument("--samples", type=int, default=400, metavar="N", help="of the bootstrap (400)")
    p.add_argument("--from", type=float, dest="begin", metavar="T",
                   help="leave out what is earlier, in the file's unit")
    p.add_argument("--to", type=float, dest="end", metavar="T", help="leave out what is later")
    p.add_argument("--out", metavar="DIR", help="where stages.json and stages.png go (beside the curve)")
    return p


def read(path, wanted=None):
    """(names, times, heights) of the two columns of a CSV; # starts a comment,
    the first other line may name the columns."""
    names, rows = curvefile.rows(path)
    if not rows:
        raise CaseError(f"{path}: holds names of columns, but no rows")
    if names is None:
        names = [str(k + 1) for k in range(len(rows[0][1]))]
    if wanted:
        chosen = [w.strip() for w in wanted.split(",")]
        if len(chosen) != 2:
            raise CaseError(f"--data {wanted}: must be two columns, TIME,HEIGHT")
    elif {"time_s", "interface_m"} <= set(names):
        chosen = ["time_s", "interface_m"]
    elif len(names) == 2:
        chosen = list(names)
    else:
        raise CaseError(f"{path}: has the columns {', '.join(names)}; --data TIME,HEIGHT says which two")
    for word in chosen:
        if word not in names:
            raise CaseError(f"{path}: {nearest(word, names, 'column')}")
    places, found = [names.index(w) for w in chosen], []
    for number, cells in rows:
        where = f"{path}, line {number}"
        pair = [_number(cells[k]) if k < len(cells) else None for k in places]
        if None in pair:
            raise CaseError(f"{where}: '{','.join(cells)}': must be numbers in {chosen[0]} and {chosen[1]}")
        if found and pair[0] <= found[-1][0]:
            raise CaseError(f"{where}: time {pair[0]:g} does not come after {found[-1][0]:g}")
        found.append(pair)
    return chosen, *np.array(found).reshape(-1, 2).T


def _number(word):
    """The finite number a word stands for, or None."""
    try:
        value = float(word)
    except ValueError:
        return None
    return value if np.isfinite(value) else None


def unit(name, known=None):
    """The unit that a column's name ends in, "" if none."""
    last = name.rpartition("_")[2].lower()
    return (known or {"m": "m", "mm": "mm", "cm": "cm"}).get(last, "")


def find(t, z, args):
    """(StageFit of all segments, stages numbered alike for all curves)."""
    from cases.lib.theory.stages import detect
    try:
        fit = detect(t, z, most=args.most, level=0.01 * args.level, samples=args.samples)
    except ValueError as e:  # what theory asks of its arguments
        raise CaseError(str(e)) from None
    return fit, stagefit.of(t, z, samples=0)


def table(fit, stages, names, scale):
    """The segments and what they mean, as text."""
    time, height = unit(names[0], _TIMES), unit(names[1])
    per = f"{height or names[1]}/{time or names[0]}"
    level = f"{100 * fit.level:g} % interval"
    head = f"  {'segment':<9}{'from':>9}{'to':>9}  {'[' + (time or names[0]) + ']':<6}{'slope':>11}  {level:<24}[{per}]"
    lines = [head]
    for k, slope in enumerate(fit.slopes):
        low, high = fit.slopes_ci[k]
        lines.append(f"  {k + 1:<9}{fit.knots[k]:>9.4g}{fit.knots[k + 1]:>9.4g}  {'':<6}{slope:>11.4g}  "
                     + f"{low:.4g} to {high:.4g}".ljust(24) + ("" if fit.linear[k] else "  bends")
                     + ("  at rest" if low <= 0 <= high else ""))
    for k, at in enumerate(fit.breaks):
        low, high = fit.breaks_ci[k]
        days = f" = {at * scale / 86400:.3g} d in the laboratory" if scale and time == "s" else ""
        lines.append(f"  break {k + 1} at {at:.4g} {time}, {100 * fit.level:g} % interval {low:.4g} to "
                     f"{high:.4g}{days}")
    lines.append(f"  {fit.message}")
    lines.append(f"  misfit {fit.rms:.3g} {height} rms; {fit.independent:.0f} independent points")
    words = (f"  settling stages: {stages.count}"
             + (f", after a slow start until {stages.start:.4g} {time}" if stages.start > fit.knots[0] else ""))
    if stages.count < 3:
        words += "; fewer than the three of the complete settling curve"
    return "\n".join(lines + [words + " (a stage falls at most half as fast as the one before, and is no mere knee)"])


def carried(folder):
    """{"begin", "full": times [s]} from which on stresses carry over half of the buoyant weight, at the bottom and up
    to the top of the solids, None where they never do; nothing without a profile."""
    from cases.lib.output import profile
    from cases.lib.theory import carrying
    try:
        columns = profile.read(folder)
    except OSError:
        return {}
    if len(columns["time_s"]) < _LEAST_ROWS:
        return {}
    *_, begin, full = carrying.of_profile(columns)
    return {"begin": begin, "full": full, "interval": float(np.max(np.diff(columns["time_s"])))}


def by_stress(found, fit):
    """Lines on stages by stress, and whether they are those of the curve."""
    if not found:
        return ""
    if found["begin"] is None:
        return "\n  by stress: contacts and charges carry less than half of the buoyant weight at the bottom to the end"
    lines = [f"  by stress: consolidation begins at {found['begin']:.4g} s, from the bottom up"
             + (f"; contacts and charges carry over half of the weight at all heights from {found['full']:.4g} s on"
                if found["full"] is not None else "; it does not come to the top")]
    for what, at in (("its begin", found["begin"]), ("its coming to the top", found["full"])):
        if at is None or not len(fit.breaks):
            continue
        k = int(np.argmin(np.abs(fit.breaks - at)))
        low, high = fit.breaks_ci[k]
        near = low - found["interval"] <= at <= high + found["interval"]
        lines.append(f"  {what} and break {k + 1} of the curve, {fit.breaks[k]:.4g} s, "
                     + ("agree within the interval" if near else f"differ by {abs(at - fit.breaks[k]):.3g} s"))
    return "\n".join([""] + lines)


def as_json(path, fit, stages, names, found):
    """All of it, in the file's own units."""
    return {**({"by_stress": found} if found else {}), "curve": path, "columns": names, "segments": [
        {"from": a, "to": b, "slope": s, "slope_interval": list(ci), "near_linear": bool(ok)}
        for a, b, s, ci, ok in zip(fit.knots[:-1].tolist(), fit.knots[1:].tolist(), fit.slopes.tolist(),
                                   fit.slopes_ci.tolist(), fit.linear)],
        "breaks": fit.breaks.tolist(), "break_intervals": fit.breaks_ci.tolist(), "level": fit.level,
        "rms": fit.rms, "independent_points": fit.independent, "bic": {str(k): v for k, v in fit.bic.items()},
        "says": fit.message, "three_stages": stages.count >= 3 and fit.ordered,
        "stages": {"count": stages.count, "start": stages.start, "slopes": stages.slopes.tolist(),
                   "breaks": stages.breaks.tolist()}}


def draw(path, t, z, fit, names, title):
    """The curve, the line fitted to it, its breaks with their intervals."""
    from cases.lib.output.plotting import plt, titled
    height, knots, slopes = unit(names[1]), fit.heights, fit.slopes
    if height == "m":  # pictures have millimetres
        height, z, knots, slopes = "mm", 1e3 * z, 1e3 * knots, 1e3 * slopes
    fig, ax = plt.subplots(figsize=(7, 4.6))
    ax.plot(t, z, "." if t.size < 60 else "-", color="#6aa9dc", ms=4, lw=2.6, label="settling curve")
    ax.plot(fit.knots, knots, "-", color="black", lw=1.1, label=f"{fit.count} segments"
            if fit.count > 1 else "1 segment")
    for k, (at, (low, high)) in enumerate(zip(fit.breaks, fit.breaks_ci)):
        ax.axvspan(low, high, color="#b3541e", alpha=0.22, lw=0,
                   label=None if k else f"breaks, {100 * fit.level:g} % interval")
        ax.axvline(at, color="#b3541e", lw=0.8)
    per = f"{height or names[1]}/{unit(names[0], _TIMES) or names[0]}"
    for k, slope in enumerate(slopes):
        if fit.knots[k + 1] - fit.knots[k] < 0.02 * (t[-1] - t[0]):
            continue
        ax.annotate(f"{slope:.3g} {per}" + ("" if fit.linear[k] else ", bends")
                    + (", at rest" if fit.slopes_ci[k][0] <= 0 <= fit.slopes_ci[k][1] else ""),
                    (0.5 * (fit.knots[k] + fit.knots[k + 1]), 0.5 * (knots[k] + knots[k + 1])),
                    xytext=(7, 9), textcoords="offset points", fontsize=8,
                    bbox={"fc": "white", "ec": "none", "alpha": 0.8, "pad": 1})
    ax.set_xlabel(names[0].replace("_", " ") if not unit(names[0], _TIMES) else f"time [{unit(names[0], _TIMES)}]")
    ax.set_ylabel(f"{names[1].rpartition('_')[0].replace('_', ' ') or names[1]} [{height}]"
                  if height else names[1].replace("_", " "))
    ax.set_xlim(t[0], t[-1])
    ax.set_ylim(bottom=min(0.0, float(np.min(z))))
    ax.grid(alpha=0.3)
    ax.legend(fontsize=8)
    titled(ax, title)
    fig.tight_layout()
    fig.savefig(path, dpi=170)
    plt.close(fig)


def main():
    args = parser().parse_args()
    if not 0 < args.level < 100:
        raise CaseError(f"--level {args.level:g}: must be a percentage between 0 and 100")
    if args.samples < 20:
        raise CaseError(f"--samples {args.samples}: must be at least 20")
    path, scale, title = args.curve, None, os.path.basename(args.curve)
    if os.path.isdir(path):
        folder, path = path, os.path.join(path, "settling.csv")
        if not os.path.isfile(path):
            raise CaseError(f"{folder}: holds no settling.csv; name a run folder or a CSV")
        try:
            with open(os.path.join(folder, "summary.json"), encoding="utf-8") as f:
                summary = json.load(f)
            if summary.get("complete") is False:
                raise CaseError(f"{folder}: is not complete: {summary.get('reason', 'it was stopped')}; its "
                                "settling.csv can be named all the same")
            scale, title = float(summary["settings"]["time_scale"]), str(summary.get("title", summary["case"]))
        except (OSError, ValueError, KeyError, TypeError, AttributeError):  # the curve is all that is needed
            scale, title = None, os.path.basename(os.path.abspath(folder))
    elif not os.path.isfile(path):
        raise CaseError(f"{path}: does not exist; name a run folder or a CSV")
    names, t, z = read(path, args.data)
    keep = ((t >= (t[0] if args.begin is None else args.begin)) & (t <= (t[-1] if args.end is None else args.end)))
    t, z = t[keep], z[keep]
    if t.size < _LEAST_ROWS:
        raise CaseError(f"{path}: {t.size} rows; must be at least {_LEAST_ROWS}")
    out = settings.folder(os.path.dirname(os.path.abspath(path)) if args.out is None else args.out)
    fit, stages = find(t, z, args)
    # of a run's own curve, whole and in seconds
    found = carried(args.curve) if os.path.isdir(args.curve) and not args.data else {}
    print(table(fit, stages, names, scale) + by_stress(found, fit))
    program.result(os.path.join(out, "stages.json"))
    with open(os.path.join(out, "stages.json"), "w", encoding="utf-8") as f:
        json.dump(as_json(path, fit, stages, names, found), f, indent=2)
        f.write("\n")
    draw(os.path.join(out, "stages.png"), t, z, fit, names, title)
    print(f"stages.json and stages.png in {out}")
    return 0


if __name__ == "__main__":
    run_program(main, called("stages"))
