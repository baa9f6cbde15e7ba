# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The programs of cases/ and validation/ start whatever the user's Python settings and current folder are."""

import os
import shutil
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
    strange = {**os.environ, "PYTHONPATH": str(tmp_path), "PYTHONHOME": str(tmp_path),
               "PYTHONSTARTUP": str(tmp_path / "json.py")}
    done = subprocess.run([os.path.join(TOP, name), "--no-setup", "--help"], cwd=tmp_path, env=strange, text=True,
                          capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert f"usage: {name}" in done.stdout


def test_all_launchers_are_known():
    assert {"cases/run", "cases/pack", "validation/run", "validation/bench"} <= set(launchers())


@pytest.mark.parametrize("words, setup", [
    (["cases.one", "NAME"], "set-up --programs"), (["validation.two", "NAME"], "set-up"),
    (["cases.lib.page.three", "DIR"], "set-up --programs --reports"),
    (["cases.lib.clay.four", "--quiet", "report", "DIR"], "set-up --programs --reports"),
    (["cases.lib.clay.four", "run", "NAME"], "set-up --programs"),
    (["cases.one", "--no-setup", "NAME"], None), (["cases.one", "--list"], None),
    (["cases.one", "NAME", "--keys"], None), (["validation.two", "--help"], None), (["cases.one", "NAME", "-h"], None),
    (["cases.one", "--yes", "NAME"], "set-up --programs --yes"), (["validation.two", "NAME", "--yes"], "set-up --yes"),
    (["cases.one", "--yes", "--list"], None), (["cases.one", "--no-setup", "--yes", "NAME"], None)])
def test_what_is_set_up(words, setup, tmp_path):
    for name, text in {"cmake/setup.sh": '#!/bin/sh\necho set-up "$@"\n',
                       "cases/one.py": "import sys\nprint(sys.argv[1:])\n",
                       "cases/lib/page/three.py": "import sys\nprint(sys.argv[1:])\n",
                       "cases/lib/clay/four.py": "import sys\nprint(sys.argv[1:])\n",
                       "validation/two.py": "import sys\nprint(sys.argv[1:])\n"}.items():
        (tmp_path / name).parent.mkdir(exist_ok=True, parents=True)
        (tmp_path / name).write_text(text)
        (tmp_path / name).chmod(0o755)
    for name in ("cmake/start.sh", "__main__.py"):
        shutil.copy(os.path.join(TOP, name), tmp_path / name)
    done = subprocess.run([tmp_path / "cmake" / "start.sh", *words], text=True, capture_output=True, check=True)
    *first, last = done.stdout.splitlines()
    assert first == ([setup] if setup else [])
    assert last == str([w for w in words[1:] if w not in ("--no-setup", "--yes")])


@pytest.mark.parametrize("module, words", [
    ("cases.lib.run.run_main", ["--list"]), ("cases.lib.run.run_main", ["clump-half", "--keys"]),
    ("validation.lib.checks.validation_main", ["--list"])])
def test_lists_need_nothing_but_python(module, words):
    """-S hides the packages that the set-up installs."""
    done = subprocess.run(["/usr/bin/python3", "-E", "-s", "-S", "-B", TOP, module, *words], text=True,
                          capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert len(done.stdout.splitlines()) > 10


def test_a_missing_package_is_named_in_one_line():
    done = subprocess.run(["/usr/bin/python3", "-E", "-s", "-S", "-B", TOP, "cases.lib.packing.packing"], text=True,
                          capture_output=True, check=False)
    assert done.returncode == 1
    assert done.stderr == "the Python module numpy is not there; cmake/setup.sh installs what this project needs\n"
