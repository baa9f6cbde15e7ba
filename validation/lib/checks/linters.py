# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Linters: which files they look at, whether they are installed, what they complain of."""

import os
import re
import shutil
import subprocess

from cases.lib.case.casefile import TOP

CLANG = 14  # clang-format of another version breaks lines elsewhere
_FOLDERS = ("exchange", "liggghts-fix", "foam-coupling", "cases", "validation", "cmake", ".ci")
_OPENING = re.compile(r"[\w)]\s*\{$")  # OpenFOAM's braces stand on lines of their own
_COMPLAINT = re.compile(r"(error|warning): |^In .* line \d+:|^[^ ]+:\d+:\d+: ")


def files(*suffixes, under=""):
    """The project's files with these endings, as paths from its top, below a folder of it."""
    found = []
    for first in _FOLDERS:
        for folder, folders, names in os.walk(os.path.join(TOP, first)):
            folders[:] = sorted(d for d in folders if d != "__pycache__")
            found += [os.path.relpath(os.path.join(folder, n), TOP) for n in sorted(names)]
    return [f for f in found if f.endswith(suffixes) and f.startswith(under)]


def scripts():
    """The shell scripts, known by their first lines."""
    found = []
    for path in files(""):
        with open(os.path.join(TOP, path), "rb") as f:
            if re.match(rb"#!.*\b(ba)?sh\n", f.readline()):
                found.append(path)
    return found


def missing(words, version=None):
    """Why a linter cannot run here, or None. words: the call that tells its version."""
    if not shutil.which(words[0]):
        return f"{words[0]} is not installed"
    said = subprocess.run(words, capture_output=True, text=True, check=False)
    if said.returncode:
        return f"{' '.join(words[:-1])} is not installed"
    if version and not re.search(rf"version {version}\.", said.stdout):
        return f"{words[0]} is not of version {version}"
    return None


def complaints(words, paths):
    """What a linter says of the files: the lines that name a place, or its last line when it fails without."""
    if not paths:
        return ["there are no files to look at"]
    said = subprocess.run([*words, *paths], cwd=TOP, capture_output=True, text=True, check=False)
    found = [line for line in (said.stdout + said.stderr).splitlines() if _COMPLAINT.search(line)]
    if said.returncode and not found:
        return (said.stdout + said.stderr).strip().splitlines()[-1:] or [f"exit code {said.returncode}"]
    return found


def in_project(lines):
    """Of clang's complaints those of the project's own lines, without what is an error to clang alone."""
    ours = tuple(os.path.join(TOP, f, "") for f in _FOLDERS)
    return [line[len(TOP) + 1:] for line in lines if line.startswith(ours) and "[clang-diagnostic-error" not in line]


def host_style(text, columns, braces_apart=False):
    """What is against a half's style in a source's text, [(line number, what)]."""
    found = []
    for number, line in enumerate(text.split("\n"), 1):
        if len(line) > columns:
            found.append((number, f"{len(line)} columns, {columns} at most"))
        if "\t" in line or line != line.rstrip():
            found.append((number, "a tab, or blanks at the end"))
        if braces_apart and not line.lstrip().startswith("//") and _OPENING.search(line):
            found.append((number, "a brace that opens behind a statement"))
    if not text.endswith("\n"):
        found.append((text.count("\n") + 1, "no end of the last line"))
    return found


def told(found):
    """Complaints for a row of the table: the first, and how many more there are."""
    return (found[0] + (f" and {len(found) - 1} more" if len(found) > 1 else "")) if found else ""
