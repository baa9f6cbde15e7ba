# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/calibrate: finds charge and time scale from a measured curve."""

import argparse
import csv
import json
import os

import numpy as np

from cases.lib.calibration import caldata, calloop
from cases.lib.case import program, settings
from cases.lib.case.casefile import Case, text
from cases.lib.case.errors import CaseError
from cases.lib.case.places import called
from cases.lib.case.program import run as run_program
from cases.lib.run import launch, runs

_ONE_STAGE = "the measured curve shows one stage only; the charge shows in the second"
_DEFAULT = (0.5, 0.85, 1.2)  # of the case's charge: charges to begin with


def parser():
    p = argparse.ArgumentParser(
        prog=called("calibrate"), allow_abbrev=False,
        description="Finds the charge and the time scale with which a case follows a measured settling curve, "
                    "and predicts the end of consolidation. cases/CALIBRATION.md says how.")
    p.add_argument("name", metavar="CASE", help="the case")
    what = p.add_mutually_exclusive_group(required=True)
    what.add_argument("--data", metavar="FILE", help="measured curve: CSV of days, height")
    what.add_argument("--make-data", metavar="FILE", help="write a made-up curve instead, by running the case")
    p.add_argument("--height0", type=float, metavar="H",
                   help="height at the start, that heights are divided by (the first)")
    p.add_argument("--charges", metavar="A,B,C", help="charges to begin with in C (0.5, 0.85, 1.2 of the case's)")
    p.add_argument("--seeds", type=int, default=1, metavar="N", help="runs at each of them (1)")
    p.add_argument("--most", type=int, default=10, metavar="N", help="runs at most (10)")
    p.add_argument("--within", type=float, default=10.0, metavar="P",
                   help="stop when the charge is known within so many percent (10)")
    p.add_argument("--end", metavar="T", help="simulated time in s, short for --set end=T")
    p.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="change a value")
    p.add_argument("--jobs", type=int, metavar="N", help="runs at once (half the cores), at most the cores")
    p.add_argument("--store", metavar="DIR", help="where the runs are kept (results/runs)")
    p.add_argument("--out", metavar="DIR", help="where the results go (results/calibration/CASE-DATA)")
    p.add_argument("--true", nargs="+", default=[], metavar="KEY=VALUE", help="--make-data: charge and time_scale")
    p.add_argument("--seed", type=int, default=1001, metavar="N", help="--make-data: packing and noise (1001)")
    p.add_argument("--noise", type=float, default=5e-4, metavar="M", help="--make-data: noise in m (5e-4)")
    p.add_argument("--rows", type=int, default=80, metavar="N", help="--make-data: rows (80)")
    return p


def changes_of(args):
    """What --set and --end change, checked."""
    case = Case(args.name)
    found = settings.read(args.set + ([f"end={args.end}"] if args.end is not None else []))
    for key in ("charge", "seed", "time_scale"):
        if key in found:
            raise CaseError(f"--set {key}={found[key]}: the calibration chooses the {key} itself")
    found = settings.apply(case, found, print)
    for key in ("charge", "time_scale"):
        if key not in case.values:
            raise CaseError(f"case {args.name} has no {key}: nothing to calibrate")
    return case, found


def charges_of(args, case):
    if args.charges is None:
        return [float(f"{f * case.values['charge']:.4g}") for f in _DEFAULT]
    try:
        found = [float(q) for q in args.charges.split(",")]
    except ValueError:
        raise CaseError(f"--charges {args.charges}: must be numbers with commas between") from None
    if len(set(found)) < 3 or min(found) <= 0:
        raise CaseError(f"--charges {args.charges}: must be three different ones or more, above 0")
    return sorted(found)


def fill(case):
    """The suspension's height at the start [m], what a run's heights are divided by."""
    values = {**case.values, **case.derive(1, 1)}
    return values.get("fill_height", values.get("tube_height"))


def make_data(args, case, changes, store):
    for key, value in settings.read(args.true, "--true").items():
        if key not in ("charge", "time_scale"):
            raise CaseError(f"--true {key}={value}: must be charge=VALUE or time_scale=VALUE")
        case.set(key, value)
    if not 0 <= args.noise < np.inf or args.rows < caldata.LEAST_ROWS:
        raise CaseError(f"--noise {args.noise} --rows {args.rows}: must be 0 or more, and "
                        f"at least {caldata.LEAST_ROWS}")
    caldata.check_new(args.make_data)
    true = {**changes, "charge": case.values["charge"], "seed": args.seed}
    folder = store.run(args.name, true)
    caldata.make(args.make_data, args.name, true, runs.curve(folder), fill(case),
                 case.values["time_scale"], args.noise, args.seed, args.rows)
    print(f"made-up curve in {args.make_data}")
    return 0


def _word(low, value, high):
    half = 0.5 * (high - low) / value
    return f"{'well' if half < 0.1 else 'fairly' if half < 0.3 else 'poorly'} determined, +- {100 * half:.0f} %"


def report(name, data, changes, made, folders):
    """All that the calibration found, in plain numbers."""
    f, e = made.fit, made.problem.e
    scale = f.s_interval if f.known else (None, None)
    charge = f.q_interval if f.known else (None, None)
    notes = []
    if not f.known:
        said = "not determined: too few runs for an interval"
    elif all(f.q_edges):
        said = "not determined: all charges tried fit as well"
    elif f.q_edges[0]:
        said = "only bounded from above"
    elif f.q_edges[1]:
        said = "only bounded from below"
    else:
        said = _word(charge[0], f.q, charge[1])
    if len(data.slopes) < 2:
        notes.append(_ONE_STAGE)
    need = data.days[data.used][-1] * caldata.DAY / f.s
    if need > 1.1 * e.end:
        notes.append(f"stages 1 and 2 of the measured curve last {need:.3g} s of the model's time, the runs "
                     f"{e.end:.3g} s: what is beyond is extrapolated; take --end {need:.3g}")
    if f.known and f.factor > 1.5:
        notes.append(f"the best curve is {f.factor:.1f} times as far off as noise and spread of packings explain: "
                     "the intervals are that much wider, but know of no other error of the model")
    scale_known = calloop.scale_determined(made)
    if not f.known:
        scale_says = "not determined: too few runs"
    elif not scale_known:
        scale_says = "not determined: goes with the charge, which only those tried bound"
    else:
        scale_says = _word(scale[0], f.s, scale[1])
    last = calloop.end_of_consolidation(made)
    why = calloop.unpredictable(made)
    if why:
        notes.append(f"{why}: nothing is predicted")
    elif f.known and not f.determined:
        notes.append("the end of consolidation is that of the charges tried, which do not bound the charge")
    if not why and not last["reached"]:
        notes.append("the runs are not at rest at their end: the end of consolidation is only bounded from below")
    return {
        "case": name, "changes": changes, "data": os.path.abspath(data.path), "height0": data.height0,
        "level": f.level,
        "charge": {"value": f.q, "low": charge[0], "high": charge[1], "unit": "C", "determined": f.determined,
                   "says": said, "tried": [e.low, e.high]},
        "time_scale": {"value": f.s, "low": scale[0], "high": scale[1], "unit": "1", "determined": scale_known,
                       "says": scale_says},
        "correlation": f.correlation if f.known else None,
        "rms_misfit": f.rms, "rms_expected": f.expected if f.known else None, "noise_of_data": data.noise,
        "stages_of_data": {"count": len(data.slopes), "breaks_days": data.breaks.tolist(),
                           "slopes_per_day": data.slopes.tolist()},
        "end_of_consolidation": {**last, "is": why and "not predicted" or "1 % of the whole fall is left"},
        "stopped": made.why, "notes": notes,
        "runs": [{"charge": q, "seed": s, "folder": d} for q, s, d in zip(made.charges, made.seeds, folders)],
    }


def _between(low, high, form="{:.4g}"):
    return "" if low is None or high is None else f"{form.format(low)} to {form.format(high)}"


def table(r):
    q, s, last = r["charge"], r["time_scale"], r["end_of_consolidation"]
    end = (f"{last['days']:.4g} days" if last["days"] else
           f"later than {last['low']:.4g} days" if last["low"] else "not determined")
    lines = [("charge", f"{q['value']:.4g} C", _between(q["low"], q["high"]), q["says"]),
             ("time scale", f"{s['value']:.4g}", _between(s["low"], s["high"]), s["says"]),
             ("consolidated", end, _between(last["low"], last["high"]), last["is"])]
    head = f"{'':<14}{'value':<22}{str(round(100 * r['level'])) + ' % interval':<28}"
    found = [head.rstrip()] + [f"{a:<14}{b:<22}{c:<28}{d}".rstrip() for a, b, c, d in lines]
    found.append(f"misfit {100 * r['rms_misfit']:.2g} % of the height at the start" + (
        f", {100 * r['rms_expected']:.2g} % expected; correlation of charge and log time scale "
        f"{r['correlation']:.2f}" if r["correlation"] is not None else ""))
    found.append(f"{len(r['runs'])} runs: {r['stopped']}")
    return "\n".join(found + [f"note: {n}" for n in r["notes"]])


def write(out, r, data, made):
    """calibration.json, .csv and .png."""
    from cases.lib.calibration import calibrate_picture
    program.result(os.path.join(out, "calibration.json"))
    with open(os.path.join(out, "calibration.json"), "w", encoding="utf-8") as f:
        json.dump(r, f, indent=2)
        f.write("\n")
    last = data.days[-1]
    if not calloop.unpredictable(made):
        last = max(last, made.problem.e.end * made.fit.s / caldata.DAY)
    more = np.linspace(0.0, last, 201)
    days = np.concatenate([data.days, more])
    measured = [text(h) for h in data.height] + [""] * len(more)
    columns = [data.height0 * c for c in calloop.band(made, days)]
    with open(os.path.join(out, "calibration.csv"), "w", encoding="utf-8", newline="") as f:
        lines = csv.writer(f, lineterminator="\n")
        lines.writerow(["days", "measured", "fitted", "low", "high"])
        for i in np.argsort(days, kind="stable"):
            lines.writerow([text(days[i]), measured[i], *("" if np.isnan(c[i]) else text(c[i]) for c in columns)])
    calibrate_picture.draw(os.path.join(out, "calibration.png"), r, data, made)


def main():
    args = parser().parse_args()
    case, changes = changes_of(args)
    for option, value, most in (("--jobs", args.jobs, launch.cores()), ("--seeds", args.seeds, 100),
                                ("--most", args.most, 1000)):
        if value is not None and not 1 <= value <= most:
            raise CaseError(f"{option} {value}: must be a whole number from 1 to {most}")
    store = runs.Store(args.store)
    if not args.within >= 0:
        raise CaseError(f"--within {args.within}: must be 0 or more")
    if args.make_data:
        return make_data(args, case, changes, store)
    data = caldata.read(args.data, args.height0)
    jobs = args.jobs or runs.default_jobs()
    folders, height = [], fill(case)

    def curves_of(pairs):
        wanted = [(args.name, {**changes, "charge": text(q), "seed": s}) for q, s in pairs]
        found = []
        for result in store.run_many(wanted, jobs):
            if result.error:
                raise CaseError(result.error)
            folders.append(result.folder)
            c = runs.curve(result.folder)
            found.append((c["time_s"], c["interface_m"] / height))
        return found

    charges = charges_of(args, case)
    stem = os.path.splitext(os.path.basename(args.data))[0]
    out = settings.folder(args.out, "calibration", f"{args.name}-{stem}")
    print(f"{data.path}: {len(data.days)} rows, {len(data.slopes)} stages; "
          f"fitted up to day {data.days[data.used][-1]:.4g}")
    if len(data.slopes) < 2:
        print(f"note: {_ONE_STAGE}")
    made = calloop.search(data, curves_of, charges, args.seeds, jobs,
                          max(args.most, len(charges) * args.seeds), 0.01 * args.within)
    r = report(args.name, data, changes, made, folders)
    print(table(r))
    write(out, r, data, made)
    print(f"results in {out}")
    return 0


if __name__ == "__main__":
    run_program(main, called("calibrate"))
