# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Every test that ctest knows, one row each."""

import os
import re
import xml.etree.ElementTree as ElementTree

from validation.lib.checks import coupled
from validation.lib.checks.verdicts import Broken

TITLE = "the unit tests (ctest)"


def run(checks):
    report = os.path.join(coupled.RUNS, "ctest.xml")
    if os.path.exists(report):
        os.remove(report)
    outcome = coupled.execute(["ctest", "--test-dir", os.path.join(coupled.TOP, "build"),
                               "--output-junit", report, "--timeout", "120"], 600)
    if not os.path.exists(report):
        raise Broken(f"ctest wrote no report: {outcome.output.strip().splitlines()[-1:]}")
    tests = list(ElementTree.parse(report).getroot().iter("testcase"))
    for test in tests:
        reason = test.find("failure")
        found = "" if reason is None else reason.get("message", "")
        checks.true(test.get("name"), test.get("status") == "run", found)
    listed = coupled.execute(["ctest", "--test-dir", os.path.join(coupled.TOP, "build"), "-N"], 60)
    total = re.search(r"Total Tests: (\d+)", listed.output)
    checks.at_least("tests run, and tests ctest lists", float(len(tests)),
                    float(total.group(1)) if total else float("nan"))
    checks.at_least("number of tests", float(len(tests)), 101.0)
