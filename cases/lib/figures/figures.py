# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/figures: this project's counterparts of the paper's figures, from runs."""

import argparse
import importlib
import json
import os
import sys
import time
from dataclasses import dataclass

from cases.lib.case import settings
from cases.lib.case.errors import CaseError, nearest
from cases.lib.case.places import called
from cases.lib.case.program import run as run_program
from cases.lib.run import runs

#: The figures there are: what each shows, and the module that draws it. A module
#: has wanted(number, options), which names runs as {label: (case, changes)}, and
#: draw(number, made, options), which returns a figure and its caption.
FIGURES = {
    2: ("packing of spheres and of clumps in the tube", "cases.lib.figures.fig_packing"),
    4: ("full size and half size column with their clumps", "cases.lib.figures.fig_packing"),
    5: ("the sphere column from 0 to 77 days, with the flow", "cases.lib.figures.fig_snapshots"),
    6: ("the clump column RP-07A from 0 to 77 days, with the flow", "cases.lib.figures.fig_snapshots"),
    7: ("settling curves of spheres and Kynch's theory", "cases.lib.figures.fig_kynch"),
    8: ("the complete settling curve of charged clumps and its stages", "cases.lib.figures.fig_stages"),
    10: ("the settling curves of the four samples", "cases.lib.figures.fig_samples"),
    11: ("the four samples compared with curves from the laboratory", "cases.lib.figures.fig_samples"),
}


@dataclass(frozen=True)
class Made:
    """A run that was made: its folder, what summary.json says, settling.csv."""

    folder: str
    summary: dict
    curve: dict

    @classmethod
    def read(cls, folder):
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as f:
            return cls(folder, json.load(f), runs.curve(folder))

    @property
    def values(self):
        """Every parameter of the run, words resolved to numbers."""
        return self.summary["settings"]

    @property
    def days(self):
        """Days in the laboratory for a second simulated."""
        return self.values["time_scale"] / 86400.0

    def words(self):
        """What was run, for a caption."""
        v, s = self.values, self.summary
        what = (f"{v['clumps']:.0f} clumps, q = {v['charge']:.4g} C, cut-off {1e3 * v['cutoff']:.3g} mm"
                if "clumps" in v else f"{v['spheres']:.0f} spheres")
        return (f"{s['case']} ({what}, solid fraction {v['solid_fraction']:.4f}, packing {v['packing']} "
                f"{v['seed']}, k = {v['stiffness']:.4g} N/m, drag {v['drag']}): {v['end']:.4g} s "
                f"= {v['end'] * self.days:.3g} d, Re up to {s['reynolds_max']:.0f}, "
                f"overlap up to {100 * s['max_overlap_over_d']:.2g} % of d")


def parser():
    p = argparse.ArgumentParser(
        prog=called("figures"), allow_abbrev=False, formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Draws this project's counterparts of the paper's figures from runs.\n"
                    "Runs that are missing are made first; those that are there are used again.",
        epilog="figures:\n" + "\n".join(f"  {n:<4}{says}" for n, (says, _) in FIGURES.items()))
    p.add_argument("numbers", nargs="*", metavar="N", help="only these figures (all)")
    p.add_argument("--data", action="append", metavar="[SAMPLE=]FILE",
                   help="figure 11: a sample's curve from the laboratory, a CSV of days and heights; SAMPLE is rp-04a, "
                        "rp-05a, rp-07a or rp-15a, if the file's name does not tell. Samples without one get made-up "
                        "data")
    p.add_argument("--out", metavar="DIR", help="where the pictures go (results/figures)")
    p.add_argument("--runs", metavar="DIR", help="where the runs are kept (results/runs)")
    p.add_argument("--jobs", type=int, metavar="N", help="runs at once (half the cores)")
    p.add_argument("--long", action="store_true", help="figures 10 and 11: runs to 64 s, 703 days, not to 130 days")
    p.add_argument("--quick", action="store_true", help="make do with shorter runs; the pictures say so")
    p.add_argument("--dry-run", action="store_true", help="list the runs that are wanted, and which are there")
    return p


def chosen(words):
    """The figures asked for, all when none is."""
    found = []
    for word in words:
        number = word.lower().removeprefix("fig").lstrip(".-")
        if number not in map(str, FIGURES):
            raise CaseError(nearest(word, [str(n) for n in FIGURES], "figure")
                            + f"; {called('figures')} --help lists them")
        found.append(int(number))
    return sorted(set(found)) or list(FIGURES)


def draw(number, made, options):
    """Draws one figure and says where it is."""
    from cases.lib.figures import print_figure
    module = importlib.import_module(FIGURES[number][1])
    fig, caption = module.draw(number, made, options)
    if options.quick and number > 4:
        caption += " A quick figure, --quick: the runs are shorter than those the figure is meant to have."
    path = print_figure.save(fig, options.out, f"figure-{number:02d}", f"Figure {number}. {caption}")
    print(f"figure {number}: {os.path.relpath(path)} and .pdf, .txt", flush=True)


def main():
    options = parser().parse_args()
    numbers = chosen(options.numbers)
    options.out = settings.path(options.out, "figures")
    if options.jobs is not None and options.jobs < 1:
        raise CaseError(f"--jobs {options.jobs}: must be at least 1")
    if options.long and options.quick:
        raise CaseError("--long, --quick: use one of them")
    from cases.lib.figures import labcurve
    if options.data and 11 not in numbers:
        raise CaseError("--data: is for figure 11, which is not among those asked for")
    options.data = labcurve.read(options.data)  # refused before hours are spent

    wanted = {n: importlib.import_module(FIGURES[n][1]).wanted(n, options) for n in numbers}
    store = runs.Store(options.runs)
    flat = [run for named in wanted.values() for run in named.values()]
    if options.dry_run:
        for number, named in wanted.items():
            for case, changes in named.values():
                there = store.finished(case, changes)
                print(f"figure {number:<4}{case:<13}{'there' if there else 'to make':<9}{runs.words(changes)}")
        return 0
    settings.folder(options.out)  # refused before the runs
    began = time.monotonic()
    results = dict(zip(range(len(flat)), store.run_many(flat, options.jobs)))
    spent = time.monotonic() - began
    if spent > 5:
        print(f"the runs took {spent:.0f} s", flush=True)

    failed, at = [], 0
    for number, named in wanted.items():
        mine = {label: results[at + i] for i, label in enumerate(named)}
        at += len(named)
        errors = [r.error for r in mine.values() if r.error]
        if errors:
            failed += errors
            print(f"figure {number}: not drawn", flush=True)
            continue
        draw(number, {label: Made.read(r.folder) for label, r in mine.items()}, options)
    for error in dict.fromkeys(failed):
        print(f"{called('figures')}: {error}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    run_program(main, called("figures"))
