# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The manual is made without a warning, and its index reaches every page."""

import glob
import importlib.util
import os
import shutil
import subprocess

import pytest

from cases.lib.case.casefile import TOP


@pytest.mark.long
def test_the_manual_has_every_page_without_warnings(tmp_path):
    if not shutil.which("sphinx-build") or not importlib.util.find_spec("myst_parser"):
        pytest.skip("python3-sphinx and python3-myst-parser are not installed")
    done = subprocess.run(["sphinx-build", "-q", "-W", "--keep-going", "-n", "-b", "html", "-c", "manual", "-d",
                           str(tmp_path / "trees"), ".", str(tmp_path / "html")], cwd=TOP, text=True,
                          capture_output=True, check=False)
    assert (done.returncode, done.stdout + done.stderr) == (0, "")
    for pattern in ("README.md", "manual/*.md", "cases/*.md", "liggghts-fix/doc/*.md", "foam-coupling/README.md"):
        for page in glob.glob(os.path.join(TOP, pattern)):
            name = os.path.relpath(page, TOP)[:-3] + ".html"
            assert os.path.isfile(tmp_path / "html" / name), name
