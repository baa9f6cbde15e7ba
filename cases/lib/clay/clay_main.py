# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""clay: one program for all of cases/, with results where one stands."""

import runpy
import sys

from cases.lib.case import places, program
from cases.lib.case.errors import CaseError, nearest

COMMANDS = {
    "run": ("cases.lib.run.run_main", "run a case, or go on with a run"),
    "report": ("cases.lib.page.report_main", "pictures, series and summary of a run, finished or not"),
    "pack": ("cases.lib.packing.pack_main", "the packing of a case by itself"),
    "stages": ("cases.lib.calibration.stages_main", "the near-linear stages of a settling curve"),
    "consolidation": ("cases.lib.consolidation.consolidation_main", "large-strain consolidation by a run's own laws"),
    "calibrate": ("cases.lib.calibration.calibrate", "charge and time scale that fit a measured curve"),
    "sweep": ("cases.lib.sweep.sweep", "a case over a grid of values"),
    "kynch": ("cases.lib.kynch.kynch_compare", "a column of spheres against Kynch's theory"),
    "figures": ("cases.lib.figures.figures", "counterparts of the paper's figures"),
    "study": ("cases.lib.study.study_main", "what sets the stages of a settling curve"),
    "scaling": ("cases.lib.calibration.scaling_main", "prototype to model and back, Eqs 14 to 16"),
}


def called():
    """What one types for this program."""
    return "clay" if places.installed() else "cases/clay"


def usage():
    """The text of --help."""
    rows = "\n".join(f"  {name:<14}{what}" for name, (_, what) in COMMANDS.items())
    return (f"usage: {called()} COMMAND [ARGUMENT ...]\n\nClay settling in water, by LIGGGHTS and OpenFOAM side by "
            f"side. Results go to `results`\nwhere one stands. {called()} COMMAND --help says more.\n\n{rows}\n\n"
            "  --json        the result as JSON on the standard output, all else on the standard error\n"
            "  --quiet       say nothing but errors\n"
            "  --version     the version\n\n"
            "A case is a name of `run --list`, or a folder of one's own: ./my-case.")


def main():
    words = [w for w in sys.argv[1:] if w not in ("--json", "--quiet")]
    asked = set(sys.argv[1:]) - set(words)
    if words[:1] in (["-h"], ["--help"]):
        print(usage())
        return 0
    if words[:1] == ["--version"]:
        print(f"clayFoam {places.version()}")
        return 0
    if not words:
        raise CaseError(f"which command? one of {', '.join(COMMANDS)}; {called()} --help says more")
    if words[0] not in COMMANDS:
        raise CaseError(nearest(words[0], list(COMMANDS), "command"))
    places.call_by(called())
    program.speak(as_json="--json" in asked, quiet="--quiet" in asked)
    sys.argv = [f"{called()} {words[0]}", *words[1:]]
    runpy.run_module(COMMANDS[words[0]][0], run_name="__main__", alter_sys=True)
    return 0


if __name__ == "__main__":
    program.run(main, called())
