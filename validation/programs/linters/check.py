# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The linters that take seconds, a row for each and each part of the project."""

import os

from validation.lib.checks import linters
from validation.lib.checks.coupled import TOP

TITLE = "the linters: clang-format, the hosts' styles, shellcheck, ruff, flake8"
_FORMATTED = ("exchange", "liggghts-fix", "foam-coupling/tests/coupled")
_STYLED = {"exchange": ((".cpp", ".h"), 100, False), "liggghts-fix": ((".cpp", ".h"), 120, False),
           "foam-coupling": ((".C", ".H"), 80, True)}  # endings, columns, whether braces stand on lines of their own
_PYTHON = ["/usr/bin/python3", "-E", "-s", "-m"]


def run(checks):
    def ask(quantity, version, words, paths, of=None):
        why = linters.missing(version, of)
        if why:
            checks.skipped(quantity, why)
        else:
            found = linters.complaints(words, paths)
            checks.true(quantity, not found, linters.told(found))

    for part in _FORMATTED:
        ask(f"clang-format: {part}", ["clang-format", "--version"], ["clang-format", "--dry-run", "--Werror"],
            linters.files(".cpp", ".h", under=part + "/"), linters.CLANG)
    for part, (suffixes, columns, braces_apart) in _STYLED.items():
        _styles(checks, f"lines: {part}", linters.files(*suffixes, under=part + "/"), columns, braces_apart)
    ask("shellcheck", ["shellcheck", "--version"], ["shellcheck", "-x", "-f", "gcc"], linters.scripts())
    python = ["__main__.py", *linters.files(".py")]
    ask("ruff", ["ruff", "--version"], ["ruff", "check", "--no-cache", "--output-format", "concise"], python)
    ask("flake8", [*_PYTHON, "flake8", "--version"], [*_PYTHON, "flake8", "--max-line-length", "120"], python)


def _styles(checks, quantity, paths, columns, braces_apart):
    found = [] if paths else ["there are no files to look at"]
    for path in paths:
        with open(os.path.join(TOP, path), encoding="utf-8") as f:
            text = f.read()
        found += [f"{path}:{n}: {what}" for n, what in linters.host_style(text, columns, braces_apart)]
    checks.true(quantity, not found, linters.told(found))
