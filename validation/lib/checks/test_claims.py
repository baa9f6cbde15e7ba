# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""validation/CLAIMS.md: every page, word, test and check that it names is there, and every page has a row."""

import glob
import os
import re

from cases.lib.case.casefile import TOP
from validation.lib.checks import rooms

TABLE = os.path.join(TOP, "validation", "CLAIMS.md")
# pages that say what the project does; READMEs of checks say what they check
PAGES = ("README.md", "exchange/README.md", "foam-coupling/README.md", "liggghts-fix/doc/*.md", "cases/*.md")


def read(*path):
    with open(os.path.join(TOP, *path), encoding="utf-8") as f:
        return f.read()


def cells(line):
    return [c.strip().replace("\\|", "|") for c in re.split(r"(?<!\\)\|", line.strip())[1:-1]]


def table(text):
    """(rows of claims: page, words, tests), (rows without a test: page, words, why)."""
    claims, untested, page = [], [], None
    for line in text.splitlines():
        if line.startswith("## "):
            page = line[3:].strip()
        elif line.startswith("|") and not re.match(r"\|[-|]+$|\| (claim|page) \|", line):
            if page == "Not tested":
                untested.append(tuple(cells(line)))
            else:
                words, tests = cells(line)
                claims.append((page, words, tests.split(", ")))
    return claims, untested


def cpp_tests():
    found = set()
    for root in ("exchange", "liggghts-fix", "foam-coupling"):
        for ending in ("cpp", "C"):
            for path in glob.glob(os.path.join(TOP, root, "**", f"*.{ending}"), recursive=True):
                found |= {".".join(m) for m in re.findall(r"^TEST(?:_P|_F)?\(\s*(\w+),\s*(\w+)", read(path), re.M)}
    return found


def typed_tests():
    """Suites of values or types have their names in TYPED_TEST and the like; a suite's name suffices then."""
    return set(re.findall(r"refused\((\w+)", read("liggghts-fix", "test", "CMakeLists.txt")))


def missing(tests, cpp, refused, checks):
    """Those of a row's tests that are not there."""
    lost = []
    for name in tests:
        kind, _, rest = name.partition(" ")
        if kind == "check":
            there = rest in checks
        elif kind == "ctest":
            there = any(f"add_test(NAME {rest}" in read(p) for p in glob.glob(
                os.path.join(TOP, "*", "**", "*.cmake"), recursive=True))
        elif name.startswith("dem.refused."):
            there = name[len("dem.refused."):] in refused
        elif "::" in name:
            path, _, test = name.partition("::")
            there = os.path.exists(os.path.join(TOP, path)) and f"def {test}(" in read(path)
        else:
            there = name in cpp
        if not there:
            lost.append(name)
    return lost


def words_are_there(page, words):
    return " ".join(words.split()) in " ".join(read(page).split())


def test_every_test_and_check_is_there():
    cpp, refused, checks = cpp_tests(), typed_tests(), rooms.holding("check.py")
    lost = {(p, w): m for p, w, t in table(read(TABLE))[0] if (m := missing(t, cpp, refused, checks))}
    assert not lost


def test_every_word_stands_on_its_page():
    claims, untested = table(read(TABLE))
    lost = [(p, w) for p, w, _ in claims + untested if not words_are_there(p, w)]
    assert not lost


def test_every_page_has_a_row():
    pages = {os.path.relpath(p, TOP) for g in PAGES for p in glob.glob(os.path.join(TOP, g))}
    assert pages == {p for p, _, _ in table(read(TABLE))[0]}


def test_the_reader_sees_what_is_missing():
    claims, untested = table("## a.md\n| claim | x |\n|---|---|\n| b \\| c | check d, E.f |\n"
                             "## Not tested\n| page | words | why |\n|---|---|---|\n| a.md | g | h |\n")
    assert claims == [("a.md", "b | c", ["check d", "E.f"])] and untested == [("a.md", "g", "h")]
    lost = ["check none", "No.test", "dem.refused.none", "cases/none.py::test", "README.md::test_none", "ctest none"]
    assert missing(lost, cpp_tests(), typed_tests(), rooms.holding("check.py")) == lost
    assert not words_are_there("README.md", "words that nobody wrote")
