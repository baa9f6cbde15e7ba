# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The caches heal, are made by one process at a time, and stand elsewhere where the project's folder is read-only."""

import os
import subprocess
import sys
import textwrap

import pytest

from cases.lib.case import cache
from cases.lib.case.casefile import TOP


class Made:
    """A cache of the test's own, with what was made and said."""

    def __init__(self, top):
        self.top, self.count, self.said = top, 0, []

    def fill(self, name="out"):
        return cache.fill("things", "key", str(self.top / name), self.make, self.said.append)

    def make(self, folder):
        self.count += 1
        os.makedirs(os.path.join(folder, "deep"))
        for name in ("one", "deep/two"):
            with open(os.path.join(folder, name), "w", encoding="utf-8") as f:
                f.write("right")


@pytest.fixture
def made(tmp_path, monkeypatch):
    monkeypatch.setattr(cache, "TOP", str(tmp_path / "project"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "user"))
    return Made(tmp_path)


def test_made_once_and_copied(made, tmp_path):
    assert [made.fill(), made.fill("again")] == [False, True]
    assert made.count == 1
    for out in ("out", "again"):
        assert (tmp_path / out / "one").read_text() == (tmp_path / out / "deep" / "two").read_text() == "right"
        assert not (tmp_path / out / "sums.json").exists()
    assert not (tmp_path / "user").exists()


@pytest.mark.parametrize("name, damage", [
    ("one", lambda p: p.write_text("wrong")), ("one", lambda p: p.write_text("")), ("one", os.remove),
    ("deep/two", lambda p: p.write_text("righ")), ("sums.json", os.remove), ("sums.json", lambda p: p.write_text("{")),
    ("more", lambda p: p.write_text("?"))])
def test_damage_is_seen_and_healed(made, tmp_path, name, damage):
    made.fill()
    entry = tmp_path / "project" / "build" / "things" / "key"
    damage(entry / name)
    assert made.fill("again") is False
    assert made.count == 2
    assert made.said == [f"{entry} is damaged: made anew"]
    assert (tmp_path / "again" / "one").read_text() == "right"
    assert made.fill("third") is True


def test_a_file_in_the_place_of_an_entry(made, tmp_path):
    (tmp_path / "project" / "build" / "things").mkdir(parents=True)
    (tmp_path / "project" / "build" / "things" / "key").write_text("")
    assert made.fill() is False
    assert made.fill() is True


def test_killed_while_it_is_made(made, tmp_path):
    code = textwrap.dedent(f"""
        import os, signal
        from cases.lib.case import cache
        cache.TOP = {str(tmp_path / "project")!r}
        def make(folder):
            open(os.path.join(folder, "half"), "w").close()
            os.kill(os.getpid(), signal.SIGKILL)
        cache.fill("things", "key", {str(tmp_path / "x")!r}, make)
        """)
    for _ in range(2):
        assert subprocess.run([sys.executable, "-c", code], cwd=TOP, check=False).returncode == -9
    assert made.fill() is False
    assert sorted(os.listdir(tmp_path / "out")) == ["deep", "one"]
    assert sorted(os.listdir(tmp_path / "project" / "build" / "things")) == ["key", "key.lock"]


def test_a_failure_leaves_nothing(made, tmp_path):
    def fail(folder):
        made.make(folder)
        raise ValueError
    with pytest.raises(ValueError):
        cache.fill("things", "key", str(tmp_path / "out"), fail)
    assert os.listdir(tmp_path / "project" / "build" / "things") == ["key.lock"]


def test_two_processes_make_it_once(made, tmp_path):
    code = textwrap.dedent(f"""
        import os, time
        from cases.lib.case import cache
        cache.TOP = {str(tmp_path / "project")!r}
        def make(folder):
            open(os.path.join(folder, "one"), "w").close()
            time.sleep(0.5)
            with open({str(tmp_path / "notes")!r}, "a") as f:
                f.write("made\\n")
        print(cache.fill("things", "key", f"{tmp_path}/{{os.getpid()}}", make))
        """)
    pair = [subprocess.Popen([sys.executable, "-c", code], cwd=TOP, stdout=subprocess.PIPE, text=True)
            for _ in range(2)]
    assert sorted(p.communicate()[0] for p in pair) == ["False\n", "True\n"]
    assert (tmp_path / "notes").read_text() == "made\n"


def test_a_project_that_cannot_be_written_to(made, tmp_path):
    (tmp_path / "project").mkdir()
    (tmp_path / "project" / "build").write_text("no folder")  # root may write anywhere
    assert [made.fill(), made.fill()] == [False, True]
    assert (tmp_path / "user" / "clayfoam" / "things" / "key" / "one").read_text() == "right"
    assert cache.place("more") == str(tmp_path / "user" / "clayfoam" / "more")


def test_nothing_can_be_kept(made, tmp_path):
    for name in ("project", "user"):
        (tmp_path / name).write_text("no folder")
    assert [made.fill(), made.fill()] == [False, False]
    assert (tmp_path / "out" / "one").read_text() == "right"


def test_what_a_shared_installation_has_is_used(made, tmp_path, monkeypatch):
    made.fill()
    monkeypatch.setattr(cache, "_writable", lambda folder: str(folder).startswith(str(tmp_path / "user")))
    assert made.fill("again") is True
    assert not (tmp_path / "user").exists()
