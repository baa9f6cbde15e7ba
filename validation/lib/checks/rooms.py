# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Where the folders of the checks and scenes are: validation/ROOM/NAME."""

import ast
import importlib
import os

from cases.lib.case.casefile import TOP

HERE = os.path.join(TOP, "validation")


def holding(file):
    """The folders of all rooms that hold this file, {name: path}, by name."""
    found = {}
    for room in sorted(os.listdir(HERE)):
        place = os.path.join(HERE, room)
        for name in sorted(os.listdir(place)) if os.path.isdir(place) else ():
            if os.path.isfile(os.path.join(place, name, file)):
                if name in found:
                    raise ValueError(f"{found[name]} and {os.path.join(place, name)}: two folders of one name")
                found[name] = os.path.join(place, name)
    return dict(sorted(found.items()))


def headline(name):
    """(TITLE, whether LONG = True) of a check, read without running it."""
    with open(os.path.join(holding("check.py")[name], "check.py"), encoding="utf-8") as f:
        tree = ast.parse(f.read())
    said = {t.id: node.value.value for node in tree.body if isinstance(node, ast.Assign)
            and isinstance(node.value, ast.Constant) for t in node.targets if isinstance(t, ast.Name)}
    return said["TITLE"], said.get("LONG", False)


def load(name):
    """A check's module, which has run(checks)."""
    folder = os.path.relpath(holding("check.py")[name], TOP)
    return importlib.import_module(".".join([*folder.split(os.sep), "check"]))
