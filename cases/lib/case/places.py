# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Where the project's programs are, its version, where results go, what one calls its programs:
of a project folder with its build/, or of what `cmake --install` has put in place."""

import json
import os
import re

from cases.lib.case.casefile import TOP

_NOTE = "installed.json"
_called = {"by": None}


def installed():
    """What the installation says of itself: version, bin, lib (paths from here); None in a project folder."""
    try:
        with open(os.path.join(TOP, _NOTE), encoding="utf-8") as f:
            return json.load(f)
    except FileNotFoundError:
        return None


def programs():
    """(the folder of liggghts-clay and clayFoam, that of their library)."""
    note = installed()
    if note:
        return tuple(os.path.normpath(os.path.join(TOP, note[k])) for k in ("bin", "lib"))
    return os.path.join(TOP, "build", "bin"), os.path.join(TOP, "build", "lib")


def version():
    """The project's version, from where CMake has it."""
    note = installed()
    if note:
        return note["version"]
    with open(os.path.join(TOP, "CMakeLists.txt"), encoding="utf-8") as f:
        return re.search(r"project\(\w+ VERSION ([\d.]+)", f.read()).group(1)


def call_by(name):
    """From now on the programs are called by this one: `clay run`, with results where one stands."""
    _called["by"] = name


def called(program):
    """What one types for a program: cases/run, or clay run."""
    by = _called["by"] or ("clay" if installed() else None)
    return f"{by} {program}" if by else f"cases/{program}"


def base():
    """The folder that `results` is in: the project's, or the one where one stands."""
    return os.getcwd() if _called["by"] or installed() else TOP


def cure():
    """What helps when a program or a package is not there."""
    return "install the package again" if installed() else "cmake/setup.sh installs and builds all"
