# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""How a program of cases/ speaks, and how it ends."""

import contextlib
import json
import os
import sys

from cases.lib.case import files, stops
from cases.lib.case.errors import CaseError


_wish = {"result": None, "stream": None}


def speak(as_json=False, quiet=False):
    """Leaves the standard output to the result as JSON, or to nothing: what is said besides goes to
    the standard error, or nowhere. Of this process and of those it starts."""
    sys.stdout.flush()
    if as_json:
        _wish["stream"] = os.fdopen(os.dup(1), "w", encoding="utf-8")
    if quiet:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, 1)
        os.close(nowhere)
    elif as_json:
        os.dup2(2, 1)


def result(found):
    """Notes a program's result for --json: the path of its JSON file, or a value."""
    _wish["result"] = found


def _told():
    """Writes the result as JSON, where that is wished for."""
    stream, found = _wish["stream"], _wish["result"]
    if stream is None or found is None:
        return
    if isinstance(found, str):
        if not os.path.isfile(found):
            return
        with open(found, encoding="utf-8") as f:
            found = json.load(f)
    json.dump(found, stream, indent=2)
    stream.write("\n")
    stream.flush()


def guarded(work, program):
    """A program's exit code; bad input is said in one line."""
    try:
        status = work()
        with files.naming("standard output"):
            sys.stdout.flush()
            _told()
        return status
    except CaseError as e:
        return _said(program, e, 2)
    except stops.Stopped as e:
        return _said(program, f"ended by {e}; what was finished is kept", 128 + e.signal)
    except KeyboardInterrupt:
        return _said(program, "interrupted; what was finished is kept", 130)
    except BrokenPipeError:
        os._exit(1)
    except OSError as e:
        return _said(program, said(e), 2)
    except RecursionError:
        return _said(program, "an input is nested too deep", 2)
    except MemoryError:
        return _said(program, "the memory does not suffice; take fewer particles or cells", 2)


def said(error):
    """An error in one line; one of the system with the place it is about."""
    if isinstance(error, OSError) and error.strerror:
        return f"{error.filename}: {error.strerror}" if error.filename else error.strerror
    return " ".join(str(error).split())


def _said(program, what, status):
    """Says why a program ends, in one line, if there is somebody to hear it."""
    with contextlib.suppress(OSError, ValueError, AttributeError):
        print(f"{program}: {what}", file=sys.stderr)
    return status


def run(work, program):
    """Runs a program to its end: what python3 is started for."""
    for stream, name in ((sys.stdout, "stdout"), (sys.stderr, "stderr")):
        if stream is None:  # closed by who called it
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))
    stops.heed()
    status = guarded(work, program)
    try:
        sys.stdout.flush()
    except OSError:  # nobody listens, or the disk is full
        os._exit(status or 1)
    sys.exit(status)
