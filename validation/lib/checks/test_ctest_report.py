# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What is read out of ctest's words, and that a test that says nothing ends."""

import json
import subprocess
import time

from validation.lib.checks import coupled, ctest_report

SAID = """Internal ctest changing into directory: /x/build
Test project /x/build
        Start   1: exchange.Fields.Differ
  1/6 Test   #1: exchange.Fields.Differ ..........................   Passed    0.01 sec
        Start   2: dem.Curve.Falls
  2/6 Test   #2: dem.Curve.Falls .................................***Failed    0.02 sec
Note: Google Test filter = Curve.Falls
test_curve.cpp:12: Failure
Expected equality of these values:
  1

        Start   3: slow
  3/6 Test   #3: slow ............................................***Timeout  10.01 sec

        Start   4: dies
  4/6 Test   #4: dies ............................................***Exception: SegFault  0.15 sec
        Start   5: left
  5/6 Test   #5: left ............................................***Not Run (Disabled)   0.00 sec
        Start   6: refusals
  6/6 Test   #6: refusals .......................***Failed  Required regular expression not found. Regex=[x]  0.30 sec

17% tests passed, 5 tests failed out of 6
The following tests FAILED:
"""


def rows(text):
    found = []
    ended = ctest_report.Ended(lambda name, reason: found.append((name, reason)))
    for line in text.splitlines(True):
        ended.take(line)
    ended.close()
    return dict(found), ended


def test_each_test_with_its_reason():
    found, _ = rows(SAID)
    assert found == {
        "exchange.Fields.Differ": "", "dem.Curve.Falls": "Failed: test_curve.cpp:12: Failure", "slow": "Timeout",
        "dies": "Exception: SegFault", "left": "Not Run (Disabled)",
        "refusals": "Failed  Required regular expression not found. Regex=[x]"}


def test_what_has_ended_is_known_when_the_rest_never_comes():
    found, ended = rows(SAID[:SAID.index("  3/6")])
    assert list(found) == ["exchange.Fields.Differ", "dem.Curve.Falls"]
    assert ended.running == {"slow"}


def test_several_at_once():
    found, ended = rows("""        Start   1: slow
        Start   2: dies
        Start   3: good
  1/3 Test   #3: good ............................................   Passed    0.01 sec
  2/3 Test   #2: dies ............................................***Failed    0.15 sec
test_dies.cpp:12: Failure
Expected equality of these values:

        Start   4: last
  3/3 Test   #1: slow ............................................   Passed    4.15 sec
""")
    assert list(found.items()) == [("good", ""), ("dies", "Failed: test_dies.cpp:12: Failure"), ("slow", "")]
    assert ended.running == {"last"}


def test_disabled_tests_and_idle_programs():
    def test(name, *command, **properties):
        return {"name": name, "command": list(command),
                "properties": [{"name": k, "value": v} for k, v in properties.items()]}
    listed = ctest_report.Listed(json.dumps({"tests": [
        test("a", "/b/bin/test_dem", "--gtest_filter=A.*", TIMEOUT=20.0),
        test("c", "mpiexec", "-n", "2", "/b/bin/meshTest"),
        test("d", "/b/bin/test_dem", DISABLED=True)]}))
    assert listed.names == ["a", "c", "d"]
    assert listed.disabled == ["d"]
    compiled = {("/t/one.cpp", "test_dem"), ("/t/two.cpp", "other"), ("/t/main.cpp", "clayFoam"),
                ("/t/c.C", "mappingCost")}
    assert listed.idle_programs({"/t/one.cpp", "/t/two.cpp", "/t/c.C"}, compiled) == ["other"]


def test_files_and_their_programs():
    assert ctest_report.holds_tests("#include <gtest/gtest.h>\nTEST_F(Curve, falls)\n{}\n")
    assert not ctest_report.holds_tests("// TEST(a, b)\nint main() { return 0; }\n")
    entry = {"directory": "/b/exchange", "file": "/t/exchange/test_terms.cpp",
             "command": "c++ -o CMakeFiles/test_terms.dir/test_terms.cpp.o -c /t/exchange/test_terms.cpp"}
    assert ctest_report.compiled([entry]) == {("/t/exchange/test_terms.cpp", "test_terms")}


def test_tests_left_out_inside_a_program():
    assert ctest_report.left_out("[       OK ] A.b\n[  PASSED  ] 2 tests.\n") == []
    assert ctest_report.left_out("  YOU HAVE 1 DISABLED TEST\n[  SKIPPED ] 2 tests, listed below:\n") == [
        "YOU HAVE 1 DISABLED TEST", "[  SKIPPED ] 2 tests"]
    assert ctest_report.left_out("Running 0 tests from 0 test suites.") == ["Running 0 tests"]


def test_lines_come_until_there_is_silence():
    began = time.monotonic()
    process = subprocess.Popen(["sh", "-c", "echo one; echo two; printf rest; sleep 60"], stdout=subprocess.PIPE,
                               start_new_session=True)
    assert list(coupled.lines(process, process.stdout.fileno(), 0.5)) == [b"one", b"two", b"rest"]
    assert process.wait() != 0
    assert time.monotonic() - began < 30
