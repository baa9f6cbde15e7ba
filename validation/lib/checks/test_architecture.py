# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What may import what, read from the sources: packages are the folders that
hold modules, and an import inside a function counts like any other."""

import ast
import collections
import os
import re

import pytest

from cases.lib.case.casefile import TOP
from validation.lib.checks import rooms

_OURS = ("cases", "validation")
_MODULE = re.compile(r"(cases|validation)(\.\w+)+$")  # of a string that names a module


def modules(top=TOP):
    """{dotted name: path} of every module of the project; tests are among them."""
    found = {}
    for first in _OURS:
        for folder, folders, files in os.walk(os.path.join(top, first)):
            folders[:] = [d for d in folders if d != "__pycache__"]
            for f in files:
                if f.endswith(".py"):
                    path = os.path.join(folder, f)
                    found[os.path.relpath(path, top)[:-3].replace(os.sep, ".")] = path
    return found


def package(name):
    return name.rpartition(".")[0]


def imported(name, path, known):
    """The modules and packages of the project that a module imports or names in a string."""
    with open(path, encoding="utf-8") as f:
        tree = ast.parse(f.read(), path)
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            above = name.split(".")[:-node.level] if node.level else []
            base = ".".join([*above, *filter(None, [node.module])])
            found |= {f"{base}.{a.name}" if f"{base}.{a.name}" in known else base for a in node.names}
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and _MODULE.match(node.value):
            found.add(node.value)
    return {m for m in found if m in known or f"{m}.__init__" in known}


def arrows(top=TOP):
    """{package: packages it imports}, with the imports that make each arrow."""
    known = modules(top)
    found = collections.defaultdict(lambda: collections.defaultdict(list))
    for name, path in known.items():
        for other in imported(name, path, known):
            target = package(other) if other in known else other
            if target != package(name):
                found[package(name)][target].append(f"{name} imports {other}")
    return found


def cycle(graph):
    """Packages that import each other in a circle, or none."""
    done = set()

    def look(node, way):
        if node in way:
            return way[way.index(node):] + [node]
        if node in done:
            return None
        for other in graph.get(node, ()):
            circle = look(other, way + [node])
            if circle:
                return circle
        done.add(node)
        return None
    return next(filter(None, (look(node, []) for node in list(graph))), None)


def test_no_circle_of_packages():
    assert cycle(arrows()) is None


@pytest.mark.parametrize("who, never", [
    (r"cases\b", r"validation\b"), (r"cases\.lib\.theory\b", r"(?!cases\.lib\.theory\b)"),
    (r"cases\.lib\.case\b", r"cases\.lib\.(?!case\b|theory\b)"),
    (r"validation\.lib\.checks\b", r"validation\.lib\.(?!checks\b)")])
def test_layers(who, never):
    bad = [line for source, targets in arrows().items() if re.match(who, source)
           for target, lines in targets.items() if re.match(never, target) for line in lines]
    assert not bad


def test_no_two_modules_of_one_name():
    """Every check has its check.py, which is known by its folder."""
    named = collections.defaultdict(list)
    for name in modules():
        if name.rpartition(".")[2] not in ("__init__", "check"):
            named[name.rpartition(".")[2]].append(name)
    assert not {k: v for k, v in named.items() if len(v) > 1}


def test_no_two_folders_of_one_name():
    checks, scenes = rooms.holding("check.py"), rooms.holding("case.json")
    assert checks and scenes
    assert all(scenes[n] == checks[n] for n in set(scenes) & set(checks))


def test_python_finds_modules_by_itself():
    """Nothing changes where Python looks for modules."""
    words = re.compile(r"\bsys\s*\.\s*path\b|\bfrom sys import .*\bpath\b|spec_from_file_location|\bsite\.addsitedir")
    me = os.path.abspath(__file__)
    bad = []
    for path in [*modules().values(), os.path.join(TOP, "__main__.py")]:
        with open(path, encoding="utf-8") as f:
            bad += [f"{path}:{n}" for n, line in enumerate(f, 1) if path != me and words.search(line)]
    assert not bad


def test_the_reader_sees_every_kind_of_import(tmp_path):
    for name, text in {"cases/__init__.py": "", "cases/a/__init__.py": "", "cases/b/__init__.py": "",
                       "cases/c/__init__.py": "",
                       "cases/a/one.py": "def f():\n    from cases.b import two\n    return two\n",
                       "cases/b/two.py": "from ..c.three import X\n",
                       "cases/c/three.py": "X = 'cases.a.one'\n", "cases/c/four.py": "import cases.c.three\n"}.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    found = arrows(tmp_path)
    assert {k: sorted(v) for k, v in found.items()} == {
        "cases.a": ["cases.b"], "cases.b": ["cases.c"], "cases.c": ["cases.a"]}
    circle = cycle(found)
    assert circle[0] == circle[-1] and set(circle) == {"cases.a", "cases.b", "cases.c"}
