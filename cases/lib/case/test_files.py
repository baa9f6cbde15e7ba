# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are whole or not there, errors with their place, locks."""

import os
import shutil
import subprocess
import sys

import pytest

from cases.lib.case import files
from cases.lib.case.casefile import TOP


def test_a_file_takes_its_place_when_it_is_whole(tmp_path):
    path = tmp_path / "a.txt"
    path.write_text("old")
    with pytest.raises(ValueError):
        with files.writing(str(path)) as f:
            f.write("half")
            f.flush()
            assert path.read_text() == "old"
            raise ValueError
    assert path.read_text() == "old"
    assert os.listdir(tmp_path) == ["a.txt"]
    with files.writing(str(path)) as f:
        f.write("new")
    assert path.read_text() == "new"
    assert os.listdir(tmp_path) == ["a.txt"]


def test_a_link_is_replaced_and_not_written_through(tmp_path):
    (tmp_path / "other").write_text("precious")
    os.symlink("other", tmp_path / "a.txt")
    with files.writing(str(tmp_path / "a.txt")) as f:
        f.write("new")
    assert (tmp_path / "other").read_text() == "precious"
    assert (tmp_path / "a.txt").read_text() == "new"


def test_a_full_disk_is_named_by_its_place():
    with pytest.raises(OSError) as e:
        with files.naming("/place"), open("/dev/full", "w", encoding="utf-8") as f:
            f.write("x" * 100)
    assert (e.value.filename, e.value.strerror) == ("/place", "No space left on device")


def test_a_copy_that_fails_is_no_list(tmp_path):
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / "one").write_text("1")
    (tmp_path / "b").mkdir()
    os.symlink("/dev/full", tmp_path / "b" / "one")
    with pytest.raises(OSError) as e:
        with files.naming("/place"):
            shutil.copytree(tmp_path / "a", tmp_path / "b", dirs_exist_ok=True)
    assert not isinstance(e.value, shutil.Error)
    assert (e.value.filename, e.value.strerror) == (str(tmp_path / "b" / "one"), "No space left on device")


def test_a_lock_is_one_process_s(tmp_path):
    path = str(tmp_path / "lock")
    code = f"from cases.lib.case import files\nwith files.Lock({path!r}): pass"
    other = [sys.executable, "-c", code]
    with files.Lock(path):
        said = subprocess.run(other, cwd=TOP, capture_output=True, text=True, check=False)
        assert "files.Taken" in said.stderr
    assert subprocess.run(other, cwd=TOP, check=False).returncode == 0


def test_the_lock_of_a_folder_that_was_moved_is_taken_anew(tmp_path, monkeypatch):
    place = tmp_path / "run"
    place.mkdir()
    plain, moved = files.fcntl.flock, []

    def move_first(number, how):
        if not moved:
            moved.append(os.rename(place, tmp_path / "run.1"))
            place.mkdir()
        return plain(number, how)
    monkeypatch.setattr(files.fcntl, "flock", move_first)
    with files.Lock(str(place / ".lock")) as lock:
        assert os.path.samestat(os.stat(place / ".lock"), os.fstat(lock.number))


def test_a_lock_is_no_link(tmp_path):
    (tmp_path / "other").write_text("precious")
    os.symlink("other", tmp_path / "lock")
    with pytest.raises(OSError):
        files.Lock(str(tmp_path / "lock"))
