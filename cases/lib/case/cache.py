# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What was made once and is used again, by a key of all that decides it. Folders
of build/, or of the user's cache where that cannot be written to."""

import contextlib
import json
import os
import shutil
import tempfile

from cases.lib.case import files, places
from cases.lib.case.casefile import TOP

_SUMS = "sums.json"


def _writable(folder):
    """Whether files can be made in a folder, which is made if need be."""
    try:
        os.makedirs(folder, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return True
    except OSError:
        return False


def _places(kind):
    """Where entries of a kind may be: with the project, and with the user."""
    user = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    own = os.path.join(os.path.abspath(user), "clayfoam", kind)
    # what is installed has no build/
    return (own, own) if places.installed() else (os.path.join(TOP, "build", kind), own)


def place(kind):
    """The first of the two places that can be written to; the first if none can."""
    return next(filter(_writable, _places(kind)), _places(kind)[0])


def _sums(folder):
    """A hash of each file below a folder, {path: hash}."""
    found = {}
    for at, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(at, name)
            if os.path.relpath(path, folder) != _SUMS:
                found[os.path.relpath(path, folder)] = files.sha256(path)
    return found


def whole(folder):
    """Whether an entry is as it was made."""
    try:
        with open(os.path.join(folder, _SUMS), encoding="utf-8") as f:
            return json.load(f) == _sums(folder)
    except (OSError, ValueError, RecursionError):
        return False


def fill(kind, key, target, make, tell=print):
    """Copies an entry into the folder `target`; whether it was there. One that is not is made by
    make(folder) first, by one process at a time; one that is damaged is made anew, which is said.
    Where nothing can be kept it is made all the same."""
    for folder in _places(kind):
        if whole(os.path.join(folder, key)) and _copy(os.path.join(folder, key), target):
            return True
    folder = place(kind)
    if not _writable(folder):
        with tempfile.TemporaryDirectory() as part:
            make(part)
            _copy(part, target)
        return False
    entry = os.path.join(folder, key)
    with files.Lock(entry + ".lock", wait=True):
        there = whole(entry)  # another run was quicker
        if not there:
            if os.path.lexists(entry):
                tell(f"{entry} is damaged: made anew")
                _remove(entry)
            _remove(entry + ".part")  # of a run that was killed
            os.makedirs(entry + ".part")
            try:
                make(entry + ".part")
                files.write_json(os.path.join(entry + ".part", _SUMS), _sums(entry + ".part"))
                os.replace(entry + ".part", entry)
            finally:
                _remove(entry + ".part")
        _copy(entry, target)
        return there


def _copy(entry, target):
    """Copies an entry's files; False when it went away in the meantime."""
    with files.naming(target):
        try:
            shutil.copytree(entry, target, dirs_exist_ok=True, ignore=shutil.ignore_patterns(_SUMS))
        except FileNotFoundError:
            return False
    return True


def _remove(path):
    """Takes away a folder or a file, if it is there."""
    with contextlib.suppress(FileNotFoundError):
        shutil.rmtree(path) if os.path.isdir(path) and not os.path.islink(path) else os.remove(path)
