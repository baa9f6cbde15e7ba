# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Tutorials of the manual as steps: files to write, commands to run, what is to be said."""

import re

_BLOCK = re.compile(r"^```(shell|\{code-block\} \w+)\n(?::caption: (\S+)\n)?(.*?)^```$", re.M | re.S)


def steps(text):
    """[(kind, name, content)] of a page: ("file", path, text), ("run", "", lines), ("expected", "", lines)."""
    found = []
    for kind, caption, content in _BLOCK.findall(text):
        if kind == "shell":
            found.append(("run", "", content))
        elif caption == "expected":
            found.append(("expected", "", content))
        elif caption:
            found.append(("file", caption, content))
    return found
