# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What ctest lists and what it says while it runs, test by test."""

import json
import os
import re

_RESULT = re.compile(r"\s*\d+/\d+ Test\s+#\d+: (\S+) [. ]*(.*?)\s+(?:[\d.]+ sec)?\s*$")
_START = re.compile(r"\s*Start\s+\d+: (\S+)$")
_SUMMARY = re.compile(r"\d+% tests passed")
_TELLS = re.compile(r"error|fail|abort|signal|exception|not found", re.I)
# what a program of GoogleTest says of tests that it leaves out, though it passes
_LEFT_OUT = re.compile(r"YOU HAVE \d+ DISABLED TESTS?|\[  SKIPPED \] [1-9]\d* tests?|Running 0 tests")
_TEST = re.compile(r"^(TYPED_)?TEST(_F|_P)?\(", re.M)
_TARGET = re.compile(r"CMakeFiles/([^/ ]+)\.dir/")
#: written like tests, but for counting, by validation/cost/instructions
_MEASURES = ("mappingCost",)


class Listed:
    """The tests of ctest --show-only=json-v1: names, commands, those disabled."""

    def __init__(self, text):
        tests = json.loads(text)["tests"]
        self.names = [t["name"] for t in tests]
        self.words = {os.path.basename(w) for t in tests for w in t.get("command", ())}
        self.disabled = [t["name"] for t in tests for p in t.get("properties", ())
                         if p["name"] == "DISABLED" and p["value"]]

    def idle_programs(self, files, compiled):
        """Programs, of those that the build makes of these files, that no test runs."""
        made = {target for path, target in compiled if path in files}
        return sorted(made - self.words - set(_MEASURES))


def holds_tests(text):
    """Whether a C++ file has tests of GoogleTest."""
    return _TEST.search(text) is not None


def compiled(commands):
    """(file, target) of each entry of compile_commands.json."""
    found = set()
    for entry in commands:
        target = _TARGET.search(entry.get("output") or entry["command"])
        path = os.path.normpath(os.path.join(entry["directory"], entry["file"]))
        found.add((path, target.group(1) if target else ""))
    return found


class Ended:
    """Takes ctest's output line by line, as --output-on-failure gives it; tell(name,
    reason) is called once a test, as soon as all is known of it. The reason says
    why it has not passed, "" if it has."""

    def __init__(self, tell):
        self.tell, self.names, self.running = tell, set(), set()
        self._failed, self._output = None, []

    def take(self, line):
        line = line.rstrip("\n")
        start, result = _START.match(line), _RESULT.match(line)
        if start or result or _SUMMARY.match(line):
            self.close()
        if start:
            self.running.add(start.group(1))
        elif result:
            name, status = result.groups()
            if status == "Passed":
                self._end(name, "")
            else:
                self._failed, self._output = (name, status.lstrip("*")), []
        elif self._failed:
            self._output.append(line.strip())

    def close(self):
        """No more is said of the last test that failed."""
        if self._failed:
            name, status = self._failed
            told = next((x for x in self._output if _TELLS.search(x)), "")
            self._failed = None
            self._end(name, f"{status}: {told}" if told else status)

    def _end(self, name, reason):
        self.names.add(name)
        self.running.discard(name)
        self.tell(name, reason)


def left_out(log):
    """What the programs say of tests that they left out, by ctest's own log."""
    return sorted(set(_LEFT_OUT.findall(log)))
