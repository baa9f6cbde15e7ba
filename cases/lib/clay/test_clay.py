# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""clay: its commands, JSON and silence, cases of one's own, completion."""

import ast
import glob
import json
import os
import re
import subprocess

import pytest

from cases.lib.case import casefile, places
from cases.lib.case.casefile import TOP
from cases.lib.case.errors import CaseError
from cases.lib.clay import clay_main
from cases.lib.run import folders

_CLAY = os.path.join(TOP, "cases", "clay")


def clay(*words, cwd):
    return subprocess.run([_CLAY, "--no-setup", *words], cwd=cwd, text=True, capture_output=True, check=False)


@pytest.fixture
def own(tmp_path):
    """A folder with two cases of one's own, of which one is like the other."""
    for name, text in (("first", {"title": "a first", "like": "clump-half", "set": {"clumps": 12}}),
                       ("second", {"title": "a second", "like": "first", "set": {"charge": 0}}),
                       ("clump-half", {"like": "clump-half", "set": {"clumps": 9}})):
        (tmp_path / name).mkdir()
        (tmp_path / name / "case.json").write_text(json.dumps(text))
    return tmp_path


@pytest.mark.parametrize("command", clay_main.COMMANDS)
def test_each_command_is_a_program_of_cases(command, tmp_path):
    done = clay(command, "--help", cwd=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert f"usage: cases/clay {command}" in done.stdout
    assert "cases/run" not in done.stdout
    assert os.access(os.path.join(TOP, "cases", command), os.X_OK)


def test_every_program_of_cases_is_a_command():
    there = {n for n in os.listdir(os.path.join(TOP, "cases"))
             if os.path.isfile(os.path.join(TOP, "cases", n)) and os.access(os.path.join(TOP, "cases", n), os.X_OK)}
    assert there - {"clay"} == set(clay_main.COMMANDS)


def test_programs_are_called_as_they_were_started():
    """No words of the library name cases/run or a sister: places.called does."""
    named = re.compile(r"\bcases/(" + "|".join(clay_main.COMMANDS) + r")\b")
    found = []
    for path in glob.glob(os.path.join(TOP, "cases", "lib", "*", "*.py")):
        if os.path.basename(path).startswith("test_"):
            continue
        with open(path, encoding="utf-8") as f:
            tree = ast.parse(f.read())
        docs = {id(n.body[0].value) for n in ast.walk(tree) if isinstance(n, (
            ast.Module, ast.FunctionDef, ast.ClassDef)) and n.body and isinstance(n.body[0], ast.Expr)}
        found += [f"{os.path.basename(path)}: {n.value}" for n in ast.walk(tree) if isinstance(n, ast.Constant)
                  and isinstance(n.value, str) and id(n) not in docs and named.search(n.value)]
    assert not found


def test_unknown_words_and_none(tmp_path):
    done = clay("rnu", cwd=tmp_path)
    assert (done.returncode, done.stderr) == (2, "cases/clay: unknown command 'rnu'; did you mean 'run'?\n")
    done = clay(cwd=tmp_path)
    assert done.returncode == 2 and done.stderr.startswith("cases/clay: which command? one of run, report")
    assert clay("--version", cwd=tmp_path).stdout == f"clayFoam {places.version()}\n"


def test_json_alone_on_the_standard_output(own):
    done = clay("run", "./first", "--keys", "--json", cwd=own)
    assert json.loads(done.stdout)["clumps"]["value"] == 12
    assert "number of clumps" in done.stderr
    done = clay("--json", "run", "--list", cwd=own)
    assert "clump-half" in json.loads(done.stdout)


def test_quiet_says_errors_alone(own):
    done = clay("run", "./first", "--keys", "--quiet", cwd=own)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    done = clay("--quiet", "run", "./first", "--set", "clumps=x", cwd=own)
    assert done.returncode == 2 and done.stderr.startswith("cases/clay run: clumps = x: must be")
    assert json.loads(clay("--quiet", "--json", "run", "./first", "--keys", cwd=own).stdout)


def test_stages_as_json(tmp_path):
    rows = "".join(f"{t},{max(100 - 8 * t, 40 - t)}\n" for t in range(30))
    (tmp_path / "curve.csv").write_text("time_s,height_mm\n" + rows)
    done = clay("stages", "curve.csv", "--json", cwd=tmp_path)
    assert (done.returncode, len(json.loads(done.stdout)["segments"])) == (0, 2)
    assert "break 1 at" in done.stderr


def test_a_case_of_ones_own(own, monkeypatch):
    monkeypatch.chdir(own)
    case = casefile.Case("./second")
    assert (case.name, case.title, case.reference) == ("second", "a second", str(own / "second"))
    assert (case.values["clumps"], case.values["charge"]) == (12, 0)
    # of the name of one of the project's
    case = casefile.Case("./clump-half/")
    assert (case.name, case.values["clumps"], case.title) == ("clump-half", 9, "clump-half")
    assert casefile.Case("clump-half").values["clumps"] == 135
    with pytest.raises(CaseError, match="unknown case 'first'.*; ./first is the one here"):
        casefile.Case("first")
    with pytest.raises(CaseError, match="./none: is no case's folder; it lacks case.json"):
        casefile.Case("./none")


def test_results_where_one_stands(own):
    done = clay("run", "./first", "--dry-run", cwd=own)
    assert done.returncode == 0, done.stderr
    run = own / "results" / "first"
    mark = folders.read_mark(str(run))
    assert (mark["case"], mark["from"], mark["values"]["clumps"]) == ("first", str(own / "first"), 12)
    assert f"cd {run}" in done.stdout
    # and it is known again
    again = folders.of(mark)
    assert casefile.Case(again).folders[-1] == str(own / "first")


def complete(*words):
    """What bash is offered for the last of the words."""
    script = f"""source {TOP}/cmake/clay.bash
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
_clay
printf '%s\\n' "${{COMPREPLY[@]}}" """
    done = subprocess.run(["bash", "-c", script, "bash", "cases/clay", *words], cwd=TOP, text=True, capture_output=True,
                          check=True)
    return done.stdout.split()


def test_completion():
    assert set(clay_main.COMMANDS) <= set(complete(""))
    assert complete("run", "clump-") == ["clump-full", "clump-half"]
    assert complete("run", "clump-half", "--set", "charg") == ["charge="]
    assert complete("sweep", "clump-half", "--dr") == ["--dry-run"]
    assert complete("stages", "--qu") == ["--quiet"]
