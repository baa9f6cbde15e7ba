# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/scaling: Eqs 14 to 16, prototype to model and back."""

import sys
from dataclasses import replace

from cases.lib.case.casefile import Case
from cases.lib.case.errors import CaseError
from cases.lib.case.places import called
from cases.lib.case.program import run as run_program
from cases.lib.case.suspension import resolve

PROGRAM = called("scaling")


def defaults(name):
    """The Scaling of a case's own particles, fluid and time scale."""
    from cases.lib.theory.scaling import Scaling
    case = Case(name)
    v = {**case.values, **resolve(case.values)}
    try:
        return replace(Scaling(), d_model=2 * v["sphere_radius"], rho_p=v["density"], rho_f=v["fluid_density"],
                       mu=v["viscosity"], factor=v["time_scale"])
    except ValueError as e:  # what theory asks of its arguments
        raise CaseError(f"case {name}: {e}") from None


def main(words=None):
    """A CASE in the first place gives the defaults, else they are the paper's."""
    words = list(sys.argv[1:] if words is None else words)
    from cases.lib.theory import scaling
    paper, program = scaling.Scaling(), PROGRAM
    if words and not words[0].startswith("-"):
        paper, program = defaults(words[0]), f"{PROGRAM} {words[0]}"
        del words[0]
        # the case's ratio of times is that of its own diameters
        if any(w.partition("=")[0] in ("--ratio", "--d-model", "--d-prototype") for w in words):
            paper = replace(paper, factor=None)
    elif words[:1] in (["-h"], ["--help"]):
        program = f"{PROGRAM} [CASE]"
        print("A CASE takes the place of the paper's numbers: its spheres, fluid and time_scale.\n")
    return scaling.main(words, paper, program)


if __name__ == "__main__":
    run_program(main, PROGRAM)
