# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/kynch: runs of a column of spheres against Kynch's theory."""

import argparse
import csv
import json
import math
import os
import sys

from cases.lib.case import program, settings
from cases.lib.case.casefile import Case, text
from cases.lib.case.errors import CaseError
from cases.lib.case.places import called
from cases.lib.case.program import run as run_program
from cases.lib.run import launch, runs

#: What is compared: key of kynch_measure.Measured.numbers, words, factor and
#: unit for the table, and what the theory has for it.
ROWS = (
    ("interface_speed", "interface speed, phi_0/2", 1e3, "mm/s", lambda c: c.kynch.interface_speed),
    ("interface_speed_early", "  first half of the window", 1e3, "mm/s", lambda c: c.kynch.interface_speed),
    ("interface_speed_late", "  second half", 1e3, "mm/s", lambda c: c.kynch.interface_speed),
    ("top_speed", "speed of the solids' top", 1e3, "mm/s", lambda c: c.kynch.interface_speed),
    ("top_speed_early", "  first half of the window", 1e3, "mm/s", lambda c: c.kynch.interface_speed),
    ("top_speed_late", "  second half", 1e3, "mm/s", lambda c: c.kynch.interface_speed),
    ("bed_speed", "bed front speed", 1e3, "mm/s", lambda c: c.kynch.bottom_waves[-1].speed_low),
    ("lag", "lag of the fitted line", 1, "s", lambda c: c.start.lag),
    ("meeting_time", "meeting, time", 1, "s", lambda c: meeting(c)[0]),
    ("meeting_height", "meeting, height", 1e3, "mm", lambda c: meeting(c)[1]),
    ("rms_over_height", "rms of top - Kynch, over H", 100, "%", None),
    ("rms_over_height_late", "  Kynch started from rest", 100, "%", None),
    ("mean_height_rms_late", "rms of mean height, likewise", 100, "%", None),
)


def meeting(column):
    """Time [s], with the start from rest, and height [m] at which the interface's
    first straight line meets the packed bed's front: in a run both are lines."""
    k = column.kynch
    bed = k.bottom_waves[-1].speed_low
    t = k.height / (k.interface_speed + bed)
    return t + column.start.lag, bed * t


def parser():
    p = argparse.ArgumentParser(
        prog=called("kynch"), allow_abbrev=False,
        description="Compares a column of equal spheres with Kynch's theory: flux of the running drag law, no fitted "
                    "number, and Richardson and Zaki's.",
        epilog=f"{called('run')} NAME --keys lists a case's keys.")
    p.add_argument("name", nargs="?", metavar="CASE", default="sphere-half", help="the case (sphere-half)")
    p.add_argument("--seeds", type=int, default=5, metavar="N", help="runs with the packings 1 to N (5)")
    p.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="change a value of the case")
    p.add_argument("--phi0", metavar="A,B,C", help="initial solid fractions, one comparison each (the case's)")
    p.add_argument("--runs", nargs="+", metavar="DIR", help="compare these finished runs, alike but for the seed")
    p.add_argument("--jobs", type=int, metavar="N", help="runs at once (half the cores)")
    p.add_argument("--store", metavar="DIR", help="where the runs are kept (results/runs)")
    p.add_argument("--out", metavar="DIR", help="where tables and pictures go (results/kynch/CASE)")
    p.add_argument("--solve", action="store_true", help="the theory alone: waves and pictures, no runs")
    p.add_argument("--height", type=float, metavar="M", help="height of the suspension, with --solve (the case's)")
    p.add_argument("--phi-m", type=float, metavar="P",
                   help="solid fraction of the bed (with runs: theirs; with --solve: 0.525, of a bed poured in a run)")
    return p


def values_of(case):
    """A case's values, words resolved to numbers, as a run's summary has them."""
    return {**case.values, **case.derive(1, 1)}


def changed(name, words, phi_0):
    """The case with its settings and, if given, the initial solid fraction."""
    case, given = Case(name), settings.read(words)
    if phi_0 is not None:
        for key in ("solid_fraction", "spheres"):
            if key in given:
                raise CaseError(f"--phi0: {key} is set, too; take one of them")
        given["solid_fraction"] = phi_0
    return case, settings.apply(case, given, print)


def fractions(words):
    """The values of --phi0 as text, checked; [None] without it."""
    if words is None:
        return [None]
    found = [w.strip() for w in words.split(",")]
    for w in found:
        try:
            good = 0 < float(w) < 1
        except ValueError:
            good = False
        if not good:
            raise CaseError(f"--phi0 {words}: must be numbers between 0 and 1")
    return found


def statistics(values):
    """Mean, standard deviation of one value and standard error of the mean."""
    mean = math.fsum(values) / len(values)
    if len(values) < 2:
        return mean, None, None
    spread = math.sqrt(math.fsum((x - mean)**2 for x in values) / (len(values) - 1))
    return mean, spread, spread / math.sqrt(len(values))


class Comparison:
    """Runs of one column, alike but for their seeds, with the theory."""

    def __init__(self, folders, phi_m=None):
        from cases.lib.kynch import kynch_column
        from cases.lib.kynch import kynch_measure
        records = [kynch_measure.Record(f) for f in folders]
        first = records[0]
        kynch_column.refuse(first.case, first.values)
        for r in records[1:]:
            other = [k for k, v in first.values.items()
                     if k not in ("seed", "prime_seed", "dem", "cfd") and r.values.get(k) != v]
            if r.case != first.case or other:
                raise CaseError(f"{r.folder}: {other[0] if other else 'case'} is not that of {first.folder}; "
                                "runs must differ by their seeds alone")
        self.phi_m = phi_m or statistics([r.packed for r in records])[0]
        self.values = first.values
        self.column = kynch_column.Column(first.values, self.phi_m)
        self.runs = [kynch_measure.Measured(r, self.column) for r in records]
        self.rows = [self._row(*row) for row in ROWS]

    def _row(self, key, words, factor, unit, exact):
        each = [m.numbers[key] for m in self.runs]
        mean, spread, error = statistics(each)
        theory = exact(self.column) if exact else None
        return {"quantity": key, "words": words, "theory": theory, "mean": mean, "spread": spread,
                "standard_error": error, "error": mean / theory - 1 if theory else None,
                "runs": each, "factor": factor, "unit": unit}

    def row(self, key):
        """The row of a quantity."""
        return next(r for r in self.rows if r["quantity"] == key)

    def table(self):
        """What was found, as text."""
        c, v = self.column, self.values
        windows = [m.window for m in self.runs]
        rz = c.kynch_rz

        def cell(x, r):
            return "" if x is None else f"{r['factor'] * x:.4g}"

        lines = [f"{v['spheres']:.0f} spheres, solid fraction {c.phi_0:.4f}, drag {v['drag']}, {len(self.runs)} seed"
                 + ("s" if len(self.runs) > 1 else "")
                 + f"; Re {float(c.law.reynolds(c.phi_0)):.0f}, single sphere {c.re_t:.0f}",
                 f"bed's solid fraction {self.phi_m:.4f}, within the settled beds: measured, but not from how they "
                 "settle",
                 f"Kynch, flux of the drag law: {c.kynch.wave_type} from the bottom", c.waves(),
                 f"Richardson-Zaki, n = {c.rz.exponent:.3g}, v_t = {1e3 * c.v_t:.4g} mm/s: interface "
                 f"{1e3 * rz.interface_speed:.4g} mm/s, meeting at {rz.t_c:.4g} s",
                 f"start from rest by the same drag law: lag {c.start.lag:.4f} s, within 1 % after "
                 f"{c.start.settled:.3f} s",
                 f"window of the fits: {min(a for a, _ in windows):.3f} s (start-up over) to "
                 f"{min(b for _, b in windows):.3f} ... {max(b for _, b in windows):.3f} s (80 % of the way)", "",
                 f"  {'':<30}{'unit':<6}{'theory':>9}{'runs':>9}{'spread':>9}{'error':>9}"]
        for r in self.rows:
            off = "" if r["error"] is None else f"{100 * r['error']:+.1f} %"
            lines.append(f"  {r['words']:<30}{r['unit']:<6}{cell(r['theory'], r):>9}{cell(r['mean'], r):>9}"
                         f"{cell(r['spread'], r):>9}{off:>9}".rstrip())
        speed = self.row("interface_speed")
        if speed["standard_error"]:
            lines.append(f"spread: standard deviation from seed to seed; interface speed {100 * speed['error']:+.1f} % "
                         f"+- {100 * speed['standard_error'] / speed['theory']:.1f} % (standard error of the mean)")
        return "\n".join(lines)

    def as_json(self):
        c = self.column
        return {"solid_fraction": c.phi_0, "packed": self.phi_m, "drag": self.values["drag"],
                "height_m": c.height, "wave": c.kynch.wave_type, "terminal_velocity": c.v_t, "reynolds": c.re_t,
                "richardson_zaki": {"exponent": c.rz.exponent, "interface_speed": c.kynch_rz.interface_speed,
                                    "bed_speed": c.kynch_rz.bottom_waves[-1].speed_low,
                                    "meeting_time": c.kynch_rz.t_c, "meeting_height": c.kynch_rz.y_meet},
                "start": {"lag_s": c.start.lag, "settled_s": c.start.settled},
                "seeds": [m.record.seed for m in self.runs], "windows_s": [list(m.window) for m in self.runs],
                "folders": [m.record.folder for m in self.runs],
                "quantities": {r["quantity"]: {k: r[k] for k in ("theory", "mean", "spread", "standard_error", "error",
                                                                 "runs")} for r in self.rows}}


def write(out, name, comparisons):
    """kynch.csv and kynch.json, SI units."""
    with open(os.path.join(out, "kynch.csv"), "w", encoding="utf-8", newline="") as f:
        table = csv.writer(f, lineterminator="\n")
        table.writerow(["solid_fraction", "quantity", "theory", "mean", "spread", "standard_error", "error", "seeds"])
        for c in comparisons:
            for r in c.rows:
                table.writerow([text(c.column.phi_0), r["quantity"],
                                *("" if r[k] is None else text(r[k]) for k in
                                  ("theory", "mean", "spread", "standard_error", "error")), len(c.runs)])
    program.result(os.path.join(out, "kynch.json"))
    with open(os.path.join(out, "kynch.json"), "w", encoding="utf-8") as f:
        json.dump({"case": name, "comparisons": [c.as_json() for c in comparisons]}, f, indent=2)
        f.write("\n")


def solve(args):
    """The theory alone; the folder of its pictures."""
    from cases.lib.kynch import kynch_column
    from cases.lib.kynch import kynch_picture
    words = args.set + ([f"tube_height={args.height:.12g}"] if args.height is not None else [])
    for number, phi_0 in enumerate(fractions(args.phi0)):
        case, _ = changed(args.name, words, phi_0)
        if args.height is not None and "fill_height" in case.values:
            case.set("fill_height", "tube_height")
        v = values_of(case)
        kynch_column.refuse(args.name, v)
        # the number of spheres is whole; here the solid fraction is what was asked for
        if phi_0 is not None:
            v["solid_fraction"] = float(phi_0)
        column = kynch_column.Column(v, args.phi_m or kynch_column.POURED)
        print(f"{v['drag']}, solid fraction {column.phi_0:.4g}, bed {column.phi_m:.4g}, H = {column.height:.4g} m: "
              f"interface {1e3 * column.kynch.interface_speed:.4g} mm/s, {column.kynch.wave_type} from the bottom")
        print(column.waves())
        print(f"  start from rest: lag {column.start.lag:.4f} s; Richardson-Zaki: n = {column.rz.exponent:.3g}, "
              f"interface {1e3 * column.kynch_rz.interface_speed:.4g} mm/s, meeting at {column.kynch_rz.t_c:.4g} s")
        out = settings.folder(args.out, "kynch", Case(args.name).name)
        suffix = f"-{phi_0}" if phi_0 else ""
        kynch_picture.curves(os.path.join(out, f"theory{suffix}.png"), column, [], case.title)
        if number == 0:
            kynch_picture.flux(os.path.join(out, "flux.png"), column, [])
    return out


def make(args):
    """The runs of every solid fraction; a list of lists of folders."""
    from cases.lib.kynch import kynch_column
    if args.seeds < 1:
        raise CaseError(f"--seeds {args.seeds}: must be at least 1")
    wanted = []
    for phi_0 in fractions(args.phi0):
        case, changes = changed(args.name, args.set, phi_0)
        if "seed" in changes:
            raise CaseError(f"--set seed: {called('kynch')} takes the seeds 1 to N; use --seeds N")
        values = values_of(case)
        kynch_column.refuse(args.name, values)
        changes.setdefault("end", kynch_column.enough(values))
        changes.setdefault("frames", 80)
        wanted.append([(args.name, {**changes, "seed": k + 1}) for k in range(args.seeds)])
    settings.folder(args.out, "kynch", Case(args.name).name)  # refuses before the runs
    flat = iter(runs.Store(args.store).run_many([w for group in wanted for w in group], args.jobs))
    groups, failed = [], []
    for group in wanted:
        results = [next(flat) for _ in group]
        failed += [r.error for r in results if r.error]
        groups.append([r.folder for r in results if not r.error])
    for error in failed:
        print(f"{called('kynch')}: {error}", file=sys.stderr)
    return [g for g in groups if g], bool(failed)


def main():
    args = parser().parse_args()
    if args.jobs is not None and not 1 <= args.jobs <= launch.cores():
        raise CaseError(f"--jobs {args.jobs}: must be from 1 to {launch.cores()}, the number of cores")
    if args.phi_m is not None and not 0 < args.phi_m < 1:
        raise CaseError(f"--phi-m {args.phi_m:g}: must be a solid fraction between 0 and 1")
    if args.height is not None and not args.solve:
        raise CaseError("--height: goes with --solve; runs take --set tube_height=...")
    if args.solve and args.runs:
        raise CaseError("--solve: the theory alone; without --runs")
    if args.runs and (args.set or args.phi0):
        raise CaseError("--runs: finished runs have their values; without --set and --phi0")
    if args.solve:
        print(f"pictures in {solve(args)}")
        return 0
    groups, failed = ([args.runs], False) if args.runs else make(args)
    comparisons = []
    for g in groups:
        try:
            comparisons.append(Comparison(g, args.phi_m))
        except CaseError as e:
            if args.runs:
                raise
            # the other groups may be good
            print(f"{called('kynch')}: {e}", file=sys.stderr)
            failed = True
    if not comparisons:
        return 1
    out = settings.folder(args.out, "kynch", Case(args.name).name)
    from cases.lib.kynch import kynch_picture
    for k, c in enumerate(comparisons):
        print(("\n" if k else "") + c.table())
        suffix = f"-{c.column.phi_0:.4f}" if len(comparisons) > 1 else ""
        kynch_picture.curves(os.path.join(out, f"kynch{suffix}.png"), c.column, c.runs,
                             c.runs[0].record.title)
    kynch_picture.flux(os.path.join(out, "flux.png"), comparisons[0].column, comparisons)
    write(out, args.name if not args.runs else comparisons[0].runs[0].record.case, comparisons)
    print(f"results in {out}")
    return 1 if failed else 0


if __name__ == "__main__":
    run_program(main, called("kynch"))
