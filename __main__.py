# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a program of this project: python3 FOLDER MODULE ARGUMENTS, with FOLDER the
one that this file is in. Python looks for modules there, wherever it is called."""

import runpy
import sys

if __name__ == "__main__":
    del sys.argv[0]
    try:
        runpy.run_module(sys.argv[0], run_name="__main__", alter_sys=True)
    except ModuleNotFoundError as e:
        if e.name.partition(".")[0] in ("cases", "validation"):
            raise
        sys.exit(f"the Python module {e.name} is not there; cmake/setup.sh installs what this project needs")
