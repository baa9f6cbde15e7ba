# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What the linters look at, and what is told when one is missing or complains."""

import os
import sys

from cases.lib.case.casefile import TOP
from validation.lib.checks import linters


def test_the_projects_files_are_found_and_nothing_else():
    found = linters.files(".cpp", ".h", ".C", ".H", ".py")
    for path in ("exchange/world.cpp", "liggghts-fix/driver/main.cpp", "foam-coupling/clayFoam/clayFoam.C",
                 "validation/lib/checks/linters.py"):
        assert path in found
    assert not [f for f in found if f.startswith(("build", "results")) or "__pycache__" in f]
    assert linters.files(".cpp", under="exchange/") == [f for f in linters.files(".cpp") if f.startswith("exchange/")]
    assert {"cases/run", "validation/run", "cmake/setup.sh", ".ci/run"} <= set(linters.scripts())


def test_a_linter_that_cannot_run_is_named():
    assert linters.missing(["no-such-linter", "--version"]) == "no-such-linter is not installed"
    assert linters.missing([sys.executable, "-m", "no_such_module"]) == f"{sys.executable} -m is not installed"
    assert linters.missing([sys.executable, "-c", "print('version 15.0')"], 14).endswith("is not of version 14")
    assert linters.missing([sys.executable, "-c", "print('version 14.0')"], 14) is None


def test_complaints_name_a_place():
    says = [sys.executable, "-c", "import sys; print('some words'); print('a.cpp:1:2: error: b'); sys.exit(1)"]
    assert linters.complaints(says, ["a.cpp"]) == ["a.cpp:1:2: error: b"]
    assert linters.complaints([sys.executable, "-c", "pass"], ["a.cpp"]) == []
    assert linters.complaints([sys.executable, "-c", "import sys; sys.exit('no place')"], ["a.cpp"]) == ["no place"]
    assert linters.complaints([sys.executable, "-c", "pass"], []) == ["there are no files to look at"]
    assert linters.told(["a", "b", "c"]) == "a and 2 more" and linters.told([]) == ""


def test_clangs_own_errors_are_left_out():
    mine = os.path.join(TOP, "exchange", "a.cpp")
    said = [f"{mine}:1:2: error: bad [bugprone-x]", f"{mine}:3:4: error: odd [clang-diagnostic-error]",
            f"{TOP}/build/openfoam/b.H:1:1: error: bad [bugprone-x]"]
    assert linters.in_project(said) == ["exchange/a.cpp:1:2: error: bad [bugprone-x]"]


def test_host_style():
    good = "void f()\n{\n    if (a)\n    {\n        // else {\n    }\n    g\n    ({\n    });\n}\n"
    assert linters.host_style(good, 80, braces_apart=True) == []
    for text, what in (("x" * 81 + "\n", "81 columns"), ("a\tb\n", "a tab"), ("a \n", "blanks"),
                       ("if (a) {\n", "a brace"), ("else {\n", "a brace"), ("a", "no end of the last line")):
        (number, said), = linters.host_style(text, 80, braces_apart=True)
        assert number == 1 and what in said
    assert linters.host_style("if (a) {\n", 80) == []
