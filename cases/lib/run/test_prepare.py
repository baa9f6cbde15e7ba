# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh of a run: made anew when anything that decides it is another."""

import os

import pytest

from cases.lib.case import cache, meshes, openfoam
from cases.lib.case.casefile import Case
from cases.lib.run import prepare


class Meshes:
    """A small CFD folder, and how often its mesh was made."""

    def __init__(self, top, monkeypatch):
        self.top, self.count = top, 0
        monkeypatch.setattr(cache, "TOP", str(top / "project"))
        monkeypatch.setattr(openfoam, "run", self.run)
        self.put("system/blockMeshDict", '#include "parameters"\n#include "../row"\nx $parameters.seed;\n')
        self.put("system/parameters", "")
        self.put("row", '#includeIfPresent "rows"\n')
        self.put("rows", "1")

    def put(self, name, text):
        path = self.top / "CFD" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def run(self, program, cfd, *_):
        self.count += program == "blockMesh"
        os.makedirs(os.path.join(cfd, "constant", "polyMesh"), exist_ok=True)
        with open(os.path.join(cfd, "constant", "polyMesh", "owner"), "w", encoding="utf-8") as f:
            f.write("0")

    def made(self, **values):
        """How many meshes were made so far, this one among them if need be."""
        case = Case("clump-half")
        case.values.update(values)
        prepare._mesh(str(self.top / "CFD"), case, {"cfd_ranks": 1})
        assert (self.top / "CFD" / "constant" / "polyMesh" / "owner").read_text() == "0"
        return self.count


@pytest.fixture
def mesh(tmp_path, monkeypatch):
    return Meshes(tmp_path, monkeypatch)


def test_made_once(mesh):
    assert [mesh.made(), mesh.made(), mesh.made(end=3)] == [1, 1, 1]


def test_its_values(mesh):
    assert [mesh.made(), mesh.made(seed=2)] == [1, 2]


@pytest.mark.parametrize("name", ["row", "rows", "system/blockMeshDict"])
def test_files_it_includes(mesh, name):
    assert mesh.made() == 1
    mesh.put("system/parameters", "y 3;")  # counts by its values
    assert mesh.made() == 1
    mesh.put(name, "2")
    assert mesh.made() == 2


def test_the_code_that_changes_it(mesh, tmp_path, monkeypatch):
    monkeypatch.setattr(meshes, "change", lambda *_: None)
    assert [mesh.made(mesh="warped"), mesh.made(mesh="warped"), mesh.made(mesh="poly")] == [1, 1, 2]
    (tmp_path / "other.py").write_text("another way")
    monkeypatch.setattr(meshes, "__file__", str(tmp_path / "other.py"))
    assert [mesh.made(mesh="warped"), mesh.made(mesh="warped"), mesh.made()] == [3, 3, 4]
