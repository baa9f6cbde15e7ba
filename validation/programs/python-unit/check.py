# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The unit tests of the Python parts, one row each."""

import os
import sys
import unittest

import coupled

TITLE = "the unit tests of the Python parts"


class _Rows(unittest.TestResult):
    """Every test becomes a row as soon as it has ended."""

    def __init__(self, checks):
        super().__init__()
        self.checks, self.reason = checks, ""
        self.modules = set()

    def _note(self, error):
        self.reason = self.reason or f"{error[0].__name__}: {error[1]}".replace("\n", " ")

    def startTest(self, test):
        super().startTest(test)
        self.reason = ""
        self.modules.add(type(test).__module__.rpartition(".")[2])

    def addError(self, test, err):
        super().addError(test, err)
        self._note(err)
        # the set-up of a whole class or module has no test of its own
        if not isinstance(test, unittest.TestCase):
            self.checks.true(str(test), False, self.reason)

    def addFailure(self, test, err):
        super().addFailure(test, err)
        self._note(err)

    def addSubTest(self, test, subtest, err):
        super().addSubTest(test, subtest, err)
        if err:
            self._note(err)

    def addSkip(self, test, reason):
        super().addSkip(test, reason)
        self.reason = "skipped: " + reason

    def stopTest(self, test):
        super().stopTest(test)
        name = test.id().removeprefix("theory.").removeprefix("unittest.loader.")
        self.checks.true(name, not self.reason, self.reason)


def run(checks):
    for folder, top in (("validation/theory", "validation"), ("cases/lib", "cases/lib"),
                        ("validation/lib", "validation/lib")):
        folder, top = os.path.join(coupled.TOP, folder), os.path.join(coupled.TOP, top)
        # to the end: the names that both libraries have stay this one's
        sys.path.append(top)
        suite = unittest.TestLoader().discover(folder, "test_*.py", top)
        result = _Rows(checks)
        suite.run(result)
        files = {f[:-3] for f in os.listdir(folder) if f.startswith("test_") and f.endswith(".py")}
        idle = sorted(files - result.modules)
        checks.true(f"a test ran of every file of tests in {os.path.relpath(folder, coupled.TOP)}",
                    bool(files) and not idle, f"none of {', '.join(idle)}" if idle else "")
