# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""CONTRIBUTING.md tells the truth: its layout is that of the folders and of what the
sources include and import, the paths it names are there; one version everywhere."""

import os
import re

import pytest

from cases.lib.case.casefile import TOP
from validation.lib.checks.test_architecture import arrows

_DEM, _CFD = "liggghts-fix", "foam-coupling"
_ENTRY = re.compile(r"^(\s+)([\w/.-]+)/\s+(.*)$")
_INCLUDE = re.compile(r'^\s*#\s*include "([^"]+)"', re.M)
_TEST = re.compile(r"^test_|Test\.[CH]$")


def read(*path):
    with open(os.path.join(TOP, *path), encoding="utf-8") as f:
        return f.read()


def layout(text):
    """{part: {room: rooms it stands on}} of the block in CONTRIBUTING.md."""
    block = re.search(r"<!-- layout -->\n(.*?)<!-- end of layout -->", text, re.S).group(1)
    found, part = {}, None
    for line in block.strip("\n").split("\n"):
        indent, name, what = _ENTRY.match(line).groups()
        if len(indent) == 4:
            part = found.setdefault(name, {})
        else:
            part[name] = set(filter(None, what.partition("; on ")[2].split(", ")))
    return found


def rooms(part):
    return {d for d in os.listdir(os.path.join(TOP, part)) if os.path.isdir(os.path.join(TOP, part, d))
            and d != "__pycache__"}


def includes(part, owner):
    """{room: rooms that its sources include}, its tests aside; owner(header) is a header's room."""
    found = {}
    for room in rooms(part):
        files = [os.path.join(folder, f) for folder, _, names in os.walk(os.path.join(TOP, part, room))
                 for f in names if f.endswith((".cpp", ".h", ".C", ".H")) and not _TEST.search(f)]
        found[room] = {owner(h) for path in files for h in _INCLUDE.findall(read(path))} - {room, None}
    return found


def headers(part):
    """{header: room} where headers are named without their room."""
    top = os.path.join(TOP, part)
    return {f: os.path.relpath(folder, top).split(os.sep)[0]
            for folder, _, names in os.walk(top) for f in names if f.endswith((".H", "Templates.C"))}


def real():
    """The layout as it is in the sources."""
    dem, own = rooms(_DEM), headers(_CFD)
    known = dem | {"exchange"}
    python = {}
    for source, targets in arrows().items():
        part, _, room = source.replace(".", "/").rpartition("/")
        if part in ("cases/lib", "validation/lib"):
            here = part.replace("/", ".") + "."
            python.setdefault(part, {})[room] = {
                t.rpartition(".")[2] if t.startswith(here) else t.partition(".")[0] for t in targets}
    found = {"exchange": {},
             _DEM: includes(_DEM, lambda h: h.partition("/")[0] if h.partition("/")[0] in known else None),
             _CFD: includes(_CFD, lambda h: "exchange" if h.startswith("exchange/") else own.get(h))}
    for part, packages in python.items():
        found[part] = {room: packages.get(room, set()) for room in rooms(part)}
    return found


@pytest.mark.parametrize("part", ["exchange", _DEM, _CFD, "cases/lib", "validation/lib"])
def test_the_layout_is_that_of_the_sources(part):
    said, is_so = layout(read("CONTRIBUTING.md"))[part], real()[part]
    assert set(said) == set(is_so)
    tests = {"test", "tests"}
    assert {r: on for r, on in said.items() if r not in tests} == {r: on for r, on in is_so.items() if r not in tests}


def test_the_layout_has_every_part_and_its_arrows_run_down():
    said = layout(read("CONTRIBUTING.md"))
    assert set(said) == {"exchange", _DEM, _CFD, "cases/lib", "validation/lib"}
    for part, on in said.items():
        below = {"exchange", "cases"}
        for room in on:  # dicts keep the order of the page
            assert on[room] <= below, (part, room)
            below.add(room)


def test_cmake_lets_each_room_include_what_it_stands_on():
    said = layout(read("CONTRIBUTING.md"))[_DEM]
    cmake = {}
    for room in set(said) - {"bench", "test", "doc"}:
        rooms_below = re.search(r"^\s*STANDS_ON (.*?)\)?$", read(_DEM, room, "CMakeLists.txt"), re.M)
        cmake[room] = set(rooms_below.group(1).split()) if rooms_below else set()

    def reached(room):
        return cmake[room].union(*map(reached, cmake[room]))
    for room in cmake:
        assert said[room] - {"exchange"} <= reached(room), room


def test_the_wire_knows_neither_host():
    """Everything it includes is its own or the system's."""
    for f in os.listdir(os.path.join(TOP, "exchange")):
        if f.endswith((".cpp", ".h")):
            assert all(h.startswith("exchange/") for h in _INCLUDE.findall(read("exchange", f))), f


def test_every_path_that_is_named_is_there():
    named = re.compile(r"`((?:exchange|liggghts-fix|foam-coupling|cases|validation|cmake)/[\w./-]+)`")
    for page in ("CONTRIBUTING.md", "README.md", "exchange/README.md"):
        for path in named.findall(read(page)):
            assert os.path.exists(os.path.join(TOP, path)), f"{page} names {path}"


def test_one_version():
    version = re.search(r"^project\(clayFoam VERSION ([\d.]+)", read("CMakeLists.txt"), re.M).group(1)
    assert re.search(r"^version: (.*)$", read("CITATION.cff"), re.M).group(1) == version
    assert re.search(r"^## \[(\d[\d.]*)\]", read("CHANGELOG.md"), re.M).group(1) == version


def test_the_readers_see_what_is_there():
    text = "    a/   first\n      b/  x\n      c/  y; on b, exchange\n    d/lib/  z\n"
    page = f"<!-- layout -->\n{text}<!-- end of layout -->\n"
    assert layout(page) == {"a": {"b": set(), "c": {"b", "exchange"}}, "d/lib": {}}
    assert headers(_CFD)["dragModel.H"] == "dragModels"
    assert "exchange" in real()[_DEM]["coupling"] and "coupling" in real()[_CFD]["clayFoam"]
