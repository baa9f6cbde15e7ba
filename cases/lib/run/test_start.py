# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The programs of cases/ and validation/ start whatever the user's Python settings and current folder are."""

import os
import subprocess

import pytest

from cases.lib.case.casefile import TOP


def launchers():
    """The scripts that start a program by cmake/start.sh."""
    found = []
    for place in ("cases", "validation"):
        for name in sorted(os.listdir(os.path.join(TOP, place))):
            path = os.path.join(TOP, place, name)
            if os.path.isfile(path) and os.access(path, os.X_OK):
                found.append(f"{place}/{name}")
    return found


@pytest.mark.parametrize("name", launchers())
def test_starts_among_strangers(name, tmp_path):
    for stranger in ("json.py", "numpy.py", "cases/__init__.py", "validation/__init__.py", "sitecustomize.py"):
        path = tmp_path / stranger
        path.parent.mkdir(exist_ok=True)
        path.write_text("raise SystemExit('a stranger was loaded')\n")
    strange = {**os.environ, "PYTHONPATH": str(tmp_path), "PYTHONHOME": str(tmp_path), "PYTHONSTARTUP": str(tmp_path / "json.py")}
    done = subprocess.run([os.path.join(TOP, name), "--no-setup", "--help"], cwd=tmp_path, env=strange, text=True,
                          capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert f"usage: {name}" in done.stdout


def test_all_launchers_are_known():
    assert {"cases/run", "cases/pack", "validation/run", "validation/bench"} <= set(launchers())
