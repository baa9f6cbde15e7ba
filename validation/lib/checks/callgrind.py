# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Runs programs under valgrind's callgrind and reads what it has counted."""

import glob
import re

_NAME = re.compile(r"^(\w+)=\((\d+)\)(?: (.*))?$")
_COST = re.compile(r"^[+\-*\d]\S* (\d+)$")


def words(out, before):
    """What stands before a program: counts are written to out.1, out.2 ... and
    begin anew each time a function of that name is entered."""
    return ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", f"--dump-before={before}"]


class Counts:
    """Instructions of each function itself, and its calls, of one part."""

    def __init__(self, path):
        self.own, self.calls, self.objects = {}, {}, {}
        names = {"fn": {}, "ob": {}}
        function = library = None
        skip = False
        with open(path, encoding="utf-8", errors="replace") as f:
            for line in f:
                line = line.rstrip("\n")
                if skip:  # what a call costs in all belongs to the function that is called
                    skip = False
                    continue
                found = _NAME.match(line)
                if found:
                    kind, number, name = found.groups()
                    known = names.get(kind[-2:] if kind in ("cfn", "cob") else kind)
                    if known is None:
                        continue
                    if name is not None:
                        known[number] = name
                    if kind == "fn":
                        function = known[number]
                        self.objects[function] = library
                    elif kind == "ob":
                        library = known[number]
                    elif kind == "cfn":
                        called = known[number]
                elif line.startswith("calls="):
                    self.calls[called] = self.calls.get(called, 0) + int(line[6:].split()[0])
                    skip = True
                else:
                    cost = _COST.match(line)
                    if cost and function is not None:
                        self.own[function] = self.own.get(function, 0) + int(cost.group(1))

    def total(self, without=()):
        """All instructions, but of libraries with one of these words in their name."""
        return sum(n for f, n in self.own.items() if not any(w in (self.objects[f] or "") for w in without))

    def within(self, pattern):
        """(instructions, calls) of the functions whose names begin so."""
        name = re.compile(pattern)
        return (sum(n for f, n in self.own.items() if name.match(f)),
                sum(n for f, n in self.calls.items() if name.match(f)))


def parts(out):
    """The parts of a run in order, of which the first is what came before the
    first entry; that after the last one is not among them."""
    found = [p for p in glob.glob(glob.escape(out) + ".*") if p.rsplit(".", 1)[1].isdigit()]
    return [Counts(p) for p in sorted(found, key=lambda p: int(p.rsplit(".", 1)[1]))]
