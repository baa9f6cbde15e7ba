# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/consolidation: Gibson's large-strain consolidation with a run's own compressibility and permeability."""

import argparse
import csv
import json
import os

import numpy as np

from cases.lib.case import files, program, settings
from cases.lib.case.errors import CaseError
from cases.lib.case.places import called
from cases.lib.case.program import run as run_program
from cases.lib.consolidation import lawfit, predict
from cases.lib.run import runs
from cases.lib.theory.gibson import PowerLaws

_FORMAT = "laws"


def parser():
    p = argparse.ArgumentParser(
        prog=called("consolidation"), allow_abbrev=False,
        description="Large-strain self-weight consolidation (Gibson, England and Hussey 1967) with compressibility and "
                    "permeability taken from a run's profiles, beside the run.",
        epilog="e = A (s + Z)^-B and kappa = C e^D are fitted to profile.csv; the settlement is computed from the end "
               "of the first stage, with the run's own void ratios there, and from the even suspension at the start.")
    p.add_argument("run", metavar="CASE|DIR", help="a run folder, or a case, which is run")
    p.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="change a value of the case")
    p.add_argument("--end", metavar="T", help="simulated time in s, short for --set end=T")
    p.add_argument("--store", metavar="DIR", help="where runs are kept (results/runs)")
    p.add_argument("--laws", metavar="FILE", help="take the laws of another run's consolidation.json: a prediction")
    p.add_argument("--samples", type=int, default=100, metavar="N", help="draws for the intervals (100)")
    p.add_argument("--out", metavar="DIR", help="where consolidation.json, .csv and .png go (the run folder)")
    return p


def folder_of(args):
    """The run's folder; of a case it is made, or taken from the store."""
    changes = args.set + ([f"end={args.end}"] if args.end is not None else [])
    if os.path.isdir(args.run) and os.path.isfile(os.path.join(args.run, "settling.csv")):
        if changes or args.store:
            raise CaseError(f"{args.run}: is a run; --set, --end and --store go with a case")
        return args.run
    return runs.Store(args.store).run(args.run, settings.read(changes))


def kept(path, viscosity):
    """(laws, walls) that another run's consolidation.json holds, with this run's viscosity."""
    try:
        with open(path, encoding="utf-8") as f:
            found = json.load(f)
        a, b, z, c, d = (float(found[_FORMAT][k]) for k in "ABZCD")
        walls = float(found["walls"])
    except (OSError, ValueError, KeyError, TypeError) as e:
        raise CaseError(f"--laws {path}: is no consolidation.json: {program.said(e)}") from None
    return PowerLaws(a, b, z, c, d, viscosity), walls


def _laws(laws):
    return {"A": laws.a, "B": laws.b, "Z": laws.z, "C": laws.c, "D": laws.d}


def table(run, laws, fit, walls, made):
    """The laws, and computed against simulated, as text."""
    units = {"A": "(Pa)^B", "B": "", "Z": "Pa", "C": "m2", "D": ""}
    lines = []
    for name, value in _laws(laws).items():
        low, high = fit.intervals[name] if fit else (None, None)
        interval = f"  95 % interval {low:.4g} to {high:.4g}" if fit else "  of another run"
        lines.append(f"  {name:<3}{value:>11.4g} {units[name]:<7}{interval}")
    head = "  e = A (s + Z)^-B, kappa = C e^D; s effective stress"
    if fit:
        (a, b), (c, d) = fit.range_of("compressibility"), fit.range_of("permeability")
        head += (f"\n  {len(fit.compression.e)} points of e from {a:.3g} to {b:.3g}, misfit a factor of "
                 f"{np.exp(fit.misfit['compressibility']):.3g}; {len(fit.flow.e)} of kappa, e from {c:.3g} to {d:.3g}, "
                 f"{np.exp(fit.misfit['permeability']):.3g}")
    lines = [head, *lines, f"  walls hold {100 * walls:.3g} % of the weight above, which the theory leaves out of it"]
    if fit and laws.b > 0.999 * lawfit.STEEPEST:
        lines.append(f"  B is at its bound: log e falls with s, by one in {laws.z / laws.b:.3g} Pa")
    z = run.curve["interface_m"]
    lines.append(f"  first stage ends at {run.stage:.4g} s; after it the interface falls by {1e3 * run.fallen:.3g} mm, "
                 f"{run.fallen / run.diameter:.3g} sphere diameters")
    lines.append(f"  {'':<34}{'interface':>10}{'at rest':>10}{'90 % at':>10}   off by, rms   at the end, of the fall: "
                 "whole, after the first stage")
    lines.append(f"  {'simulated':<34}{1e3 * z[-1]:>7.1f} mm{'':>10}{_time(predict.simulated_90(run)):>10}")
    for name, curve in made.items():
        rms, last = predict.errors(run, curve)
        lines.append(f"  {name:<34}{1e3 * _at_end(run, curve):>7.1f} mm{1e3 * curve.final:>7.1f} mm"
                     f"{_time(curve.time_90):>10}{1e3 * rms:>11.2f} mm{1e3 * last:>+9.2f} mm"
                     f"{100 * last / run.fall:>+22.1f} %{100 * last / run.fallen:>+16.0f} %")
    part = predict.falling(run)
    if part > 0.02:
        lines.append(f"  the run still falls: {100 * part:.2g} % of its fall after the first stage in the last tenth "
                     "of that time, so that its 90 % is a lower bound")
    return "\n".join(lines)


def _at_end(run, curve):
    """The computed interface [m] when the run ends."""
    return float(np.interp(run.curve["time_s"][-1], curve.times, curve.interface))


def _time(t):
    return "not yet" if t is None else f"{t:.4g} s"


def as_json(run, laws, fit, walls, made):
    """All of it, SI units."""
    return {"run": run.folder, "title": run.title, "stage_end_s": run.stage, "consolidation_begins_s": run.begin,
            "fall_m": run.fall, "fall_after_m": run.fallen, _FORMAT: _laws(laws),
            "intervals": fit.intervals if fit else None,
            "misfit": fit.misfit if fit else None, "walls": walls,
            "points": {"compressibility": len(fit.compression.e), "permeability": len(fit.flow.e)} if fit else None,
            "simulated": {"interface_end_m": float(run.curve["interface_m"][-1]),
                          "time_90_s": predict.simulated_90(run),
                          "still_falling": predict.falling(run)},
            "computed": {name: {"interface_end_m": _at_end(run, c), "interface_at_rest_m": c.final,
                                "time_90_s": c.time_90, "rms_error_m": predict.errors(run, c)[0],
                                "error_at_end_m": predict.errors(run, c)[1]} for name, c in made.items()}}


def write_csv(path, run, made):
    """Simulated and computed curves at the run's times; nothing before a computed one begins."""
    t = run.curve["time_s"]
    names = [x for name in made for x in (f"interface_{name.replace(' ', '_')}_m", f"mean_{name.replace(' ', '_')}_m")]
    rows = [t, run.curve["interface_m"], run.curve["mean_height_m"]]
    for curve in made.values():
        for values in (curve.interface, curve.mean):
            rows.append(np.interp(t, curve.times, values, left=np.nan))
    with files.writing(path, newline="") as f:
        out = csv.writer(f, lineterminator="\n")
        out.writerow(["time_s", "interface_m", "mean_height_m", *names])
        for row in zip(*rows):
            out.writerow(["" if np.isnan(x) else f"{x:.8g}" for x in row])


def main():
    args = parser().parse_args()
    if args.samples < 20:
        raise CaseError(f"--samples {args.samples}: must be at least 20")
    run = predict.read(folder_of(args))
    out = settings.folder(run.folder if args.out is None else args.out)
    fit = None
    if args.laws:
        laws, walls = kept(args.laws, run.settings["viscosity"])
    else:
        fit = lawfit.fit(run.columns, run.settings, run.begin, args.samples)
        laws, walls = fit.laws, fit.walls
    made = {"from the first stage": predict.from_stage(run, laws, walls),
            "from the start": predict.from_start(run, laws, walls)}
    print(table(run, laws, fit, walls, made))
    path = os.path.join(out, "consolidation.json")
    program.result(path)
    files.write_json(path, as_json(run, laws, fit, walls, made))
    write_csv(os.path.join(out, "consolidation.csv"), run, made)
    from cases.lib.consolidation import consolidation_picture
    consolidation_picture.draw(os.path.join(out, "consolidation.png"), run, laws, fit, made)
    print(f"consolidation.json, consolidation.csv and consolidation.png in {out}")
    return 0


if __name__ == "__main__":
    run_program(main, called("consolidation"))
