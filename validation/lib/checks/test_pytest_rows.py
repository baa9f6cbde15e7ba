# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin that tells of each test: passed, failed, skipped, endless, broken."""

import json
import os
import subprocess
import sys
from concurrent import futures

from cases.lib.case.casefile import TOP

TESTS = """
import time, unittest, pytest
def test_good(): pass
def test_bad(): assert 1 == 2
@pytest.mark.skip(reason="no time")
def test_skipped(): pass
def test_endless(): time.sleep(30)
@pytest.fixture
def broken(): raise ValueError("no such thing")
def test_broken(broken): pass
class Cases(unittest.TestCase):
    def test_parts(self):
        for k in range(3):
            with self.subTest(k):
                self.assertNotEqual(k, 1)
"""


def told(folder, *options):
    """What the plugin writes about tests in a folder, line by line."""
    ours, theirs = os.pipe()
    subprocess.run([sys.executable, "-E", "-s", "-B", TOP, "pytest", "-q", "-c", os.devnull, "--rootdir", str(folder),
                    "-p", "validation.lib.checks.pytest_rows", "-p", "no:cacheprovider",
                    "--rows-to", str(theirs), "--limit", "1", *options, str(folder)],
                   pass_fds=(theirs,), stdout=subprocess.DEVNULL, check=False)
    os.close(theirs)
    with open(ours, encoding="utf-8") as f:
        return [json.loads(line) for line in f]


def test_each_test_is_told_as_it_ends(tmp_path):
    (tmp_path / "test_some.py").write_text(TESTS)
    lines = told(tmp_path)
    names = ["good", "bad", "skipped", "endless", "broken"]
    assert lines[0]["listed"] == [f"test_some.py::test_{n}" for n in names] + ["test_some.py::Cases::test_parts"]
    assert [line["began"] for line in lines if "began" in line] == lines[0]["listed"]
    reasons = {line["ended"].rpartition("::test_")[2]: line["reason"] for line in lines if "ended" in line}
    assert reasons["good"] == ""
    assert reasons["bad"].startswith("assert 1 == 2")
    assert reasons["skipped"] == "skipped: Skipped: no time"
    assert "took longer than 1 s" in reasons["endless"]
    assert "no such thing" in reasons["broken"]
    assert "1 == 1" in reasons["parts"]


def test_a_file_that_cannot_be_read_is_told(tmp_path):
    (tmp_path / "test_bad.py").write_text("import nothing_of_this_name\n")
    ended = [line for line in told(tmp_path) if "ended" in line]
    assert len(ended) == 1 and "nothing_of_this_name" in ended[0]["reason"]


def test_of_several_that_share_each_test_runs_once(tmp_path):
    for name in ("one", "two"):
        (tmp_path / f"test_{name}.py").write_text("import time, pytest\n@pytest.fixture(scope='module')\ndef made(): "
                                                  "yield 1\n" + "".join(
                                                      f"def test_{k}(made): time.sleep(0.1)\n" for k in range(10)))
    (tmp_path / "taken").mkdir()
    with futures.ThreadPoolExecutor(2) as pool:
        both = list(pool.map(lambda _: told(tmp_path, "--share", str(tmp_path / "taken")), range(2)))
    listed = both[0][0]["listed"]
    assert both[1][0]["listed"] == listed and len(listed) == 20
    ended = [[line["ended"] for line in lines if "ended" in line] for lines in both]
    assert sorted(ended[0] + ended[1]) == sorted(listed)
    assert all(ended)
    assert not any(line.get("reason") for lines in both for line in lines)
