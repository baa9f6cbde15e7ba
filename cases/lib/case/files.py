# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are whole or not there, errors that name their place, locks."""

import contextlib
import errno
import fcntl
import hashlib
import json
import os
import shutil


@contextlib.contextmanager
def naming(place):
    """Gives an error of the system that names no file this place."""
    try:
        yield
    except shutil.Error as e:
        raise _plain(e) from None
    except OSError as e:
        if e.filename or not e.errno:
            raise
        raise type(e)(e.errno, e.strerror or os.strerror(e.errno), place) from None


def _plain(e):
    """shutil's list of (source, target, why) as an error that names the first place."""
    first = e.args[0]
    if isinstance(first, list) and first and isinstance(first[0], tuple) and len(first[0]) == 3:
        _, target, why = first[0]
        number = next((n for n in (errno.ENOSPC, errno.EDQUOT, errno.EROFS, errno.EACCES) if os.strerror(n) in why),
                      errno.EIO)
        return OSError(number, os.strerror(number) if os.strerror(number) in why else why, target)
    return e


@contextlib.contextmanager
def fresh(path):
    """Gives a path beside this one to write to; what stands there at the end takes
    its place at once, and nothing of it is left when the writing fails."""
    folder, name = os.path.split(path)
    stem, ending = os.path.splitext(name)
    part = os.path.join(folder, f".{stem}.{os.getpid()}{ending}")
    try:
        with naming(path):
            yield part
            os.replace(part, path)
    finally:
        with contextlib.suppress(OSError):
            os.remove(part)


@contextlib.contextmanager
def writing(path, newline=None):
    """A text file that takes its place when it is whole."""
    with fresh(path) as part:
        with open(part, "w", encoding="utf-8", newline=newline) as f:
            yield f
            f.flush()
            os.fsync(f.fileno())


def write_json(path, value):
    """Writes a value as JSON, whole or not at all."""
    with writing(path) as f:
        json.dump(value, f, indent=2)
        f.write("\n")


def sha256(path):
    """A hash of a file's bytes, None of one that cannot be read."""
    try:
        with open(path, "rb") as f:
            return hashlib.sha256(f.read()).hexdigest()
    except OSError:
        return None


class Taken(Exception):
    """Another process holds the lock."""


class Lock:
    """A file that one process at a time can hold; it is let go when the process
    ends, however that is."""

    def __init__(self, path, wait=False):
        """Takes the lock, at once or not at all (Taken), unless it may wait."""
        self.path = path
        while True:
            self.number = os.open(path, os.O_CREAT | os.O_RDWR | os.O_NOFOLLOW, 0o644)
            try:
                fcntl.flock(self.number, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
            except BlockingIOError:
                os.close(self.number)
                raise Taken(path) from None
            if self._there():
                return
            os.close(self.number)  # its folder was moved aside a moment ago

    def _there(self):
        """Whether the path still names the file that is held."""
        try:
            return os.path.samestat(os.stat(self.path, follow_symlinks=False), os.fstat(self.number))
        except FileNotFoundError:
            return False

    def close(self):
        if self.number >= 0:
            os.close(self.number)
            self.number = -1

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()
