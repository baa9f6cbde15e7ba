# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Where programs and results are, in a project folder and where it is installed."""

import json
import os

from cases.lib.case import cache, places


def test_in_a_project_folder():
    assert places.installed() is None
    assert places.programs() == (os.path.join(places.TOP, "build", "bin"), os.path.join(places.TOP, "build", "lib"))
    assert (places.called("run"), places.base()) == ("cases/run", places.TOP)
    assert places.cure().startswith("cmake/setup.sh")


def test_installed(tmp_path, monkeypatch):
    share = tmp_path / "share" / "clayfoam"
    share.mkdir(parents=True)
    (share / "installed.json").write_text(json.dumps({"version": "7.8.9", "bin": "../../bin", "lib": "../../lib/x"}))
    for module in (places, cache):
        monkeypatch.setattr(module, "TOP", str(share))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.chdir(tmp_path)
    assert places.programs() == (str(tmp_path / "bin"), str(tmp_path / "lib" / "x"))
    assert (places.version(), places.called("run"), places.base()) == ("7.8.9", "clay run", str(tmp_path))
    assert cache.place("meshes") == str(tmp_path / "cache" / "clayfoam" / "meshes")
    assert "setup.sh" not in places.cure()


def test_called_by_another_name(tmp_path, monkeypatch):
    monkeypatch.setitem(places._called, "by", "cases/clay")
    monkeypatch.chdir(tmp_path)
    assert (places.called("report"), places.base()) == ("cases/clay report", str(tmp_path))
