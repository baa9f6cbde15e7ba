# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the commands of all pages, in a copy of the project."""

import os
import shlex
import shutil
import tempfile

from cases.lib.case.casefile import TOP
from validation.lib.checks import coupled, page_commands

TITLE = "every command of every page: run, made short, or tried by its words"
LONG = True
MOST_EXCERPTS = 0.1
_LIMIT = 300
_CURVE = "time_s,height_mm\n" + "".join(f"{t},{max(100 - 8 * t, 40 - t)}\n" for t in range(30))
_SCRIPT = "units si\natom_style granular\nregion a block 0 1 0 1 0 1 units box\ncreate_box 1 a\n"


def copy(place):
    """The project with its programs in another place, and in it what commands take: a case, curve, a run."""
    for name in ("cases", "cmake", "validation"):
        shutil.copytree(os.path.join(TOP, name), os.path.join(place, name),
                        ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("__main__.py", "CMakeLists.txt", "CONTRIBUTING.md", "README.md", "CHANGELOG.md"):
        shutil.copy(os.path.join(TOP, name), place)
    for name in ("bin/liggghts-clay", "bin/clayFoam"):
        os.makedirs(os.path.join(place, "build", "bin"), exist_ok=True)
        shutil.copy(os.path.join(TOP, "build", name), os.path.join(place, "build", name))
    shutil.copytree(os.path.join(TOP, "build", "lib"), os.path.join(place, "build", "lib"))
    os.makedirs(os.path.join(place, "my-case"))
    for name, text in (("my-case/case.json", '{"title": "mine", "like": "clump-half", "set": {"clumps": 12}}'),
                       ("curve.csv", _CURVE), ("script/in.script", _SCRIPT)):
        os.makedirs(os.path.dirname(os.path.join(place, name)), exist_ok=True)
        with open(os.path.join(place, name), "w", encoding="utf-8") as f:
            f.write(text)
    return coupled.execute(["cases/run", "--no-setup", "clump-half", "--end", "0.02", "--out", "kept"], _LIMIT, place)


def halves(place, where, words):
    """Runs an mpirun line in the folder of a run that was prepared for its ranks and its script's name."""
    _, dem, cfd, script = where.split()
    folder = os.path.join(place, f"by-hand-{dem}-{cfd}")
    shutil.rmtree(folder, ignore_errors=True)
    made = coupled.execute(["cases/run", "--no-setup", "clump-half", "--end", "0.02", "--dem", dem, "--cfd", cfd,
                            "--out", folder, "--dry-run"], _LIMIT, place)
    if made.status:
        return made
    if script != "in.liggghts":
        shutil.copy(os.path.join(folder, "in.liggghts"), os.path.join(folder, script))
    with open(os.path.join(folder, "run.sh"), encoding="utf-8") as f:
        exports = [line.strip() for line in f if line.startswith("export ")]
    # the ranks of a cluster, on what cores there are
    crowded = ["export OMPI_MCA_rmaps_base_oversubscribe=1"]
    line = "\n".join([*exports, *crowded, shlex.join(words)])
    return coupled.execute(["bash", "-c", line], _LIMIT, folder)


def attempt(place, trial):
    """The outcome of a trial; None where its programs are not built."""
    if trial.where.startswith("run "):
        return halves(place, trial.where, trial.words)
    if trial.where == "build":
        if trial.words[0].startswith("build/") and not os.path.isfile(os.path.join(TOP, trial.words[0])):
            return None
        words = [os.path.join(place, "out-" + w) if w.startswith("kept") else w for w in trial.words]
        words = ["/usr/bin/python3", "-E", "-s", "-B", *words[1:]] if words[0] == "python3" else words
        return coupled.execute(words, _LIMIT, TOP)
    if trial.where == "shell":
        if not shutil.which(trial.words[0]):
            return None
        return coupled.execute(["bash", "-c", " ".join(trial.words)], _LIMIT, TOP)
    if "--continue" in trial.words:  # a run that can go on
        first = coupled.execute(["cases/run", "--no-setup", "clump-half", "--end", "0.02"], _LIMIT, place)
        if first.status:
            return first
    env = {**os.environ, "PATH": os.path.join(place, "build", "bin") + ":" + os.environ["PATH"],
           "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    cwd = os.path.join(place, "script") if trial.where == "script" else place
    return coupled.execute(list(trial.words), _LIMIT, cwd, env)


def run(checks):
    every = page_commands.every_command()
    tried = [(c, page_commands.trial(c)) for c in every]
    counts = {how: sum(t.how == how for _, t in tried) for how in page_commands.HOWS}
    checks.note(f"{len(every)} commands: " + ", ".join(f"{n} {how}" for how, n in counts.items()) + ".")
    with tempfile.TemporaryDirectory() as place:
        place = os.path.realpath(place)
        first = copy(place)
        if not checks.true("a run to report", first.status == 0, first.output[-200:] if first.status else ""):
            return
        for command, trial in tried:
            if trial.how == "excerpt":
                checks.note(f"excerpt, not run: {command.page}, line {command.line}: {command.text}")
                continue
            if trial.where == "tutorials":
                continue
            outcome = attempt(place, trial)
            name = f"{command.page}: {command.text}"
            if outcome is None:
                checks.skipped(name, f"{trial.words[0]} is not there")
            else:
                checks.true(name, outcome.status == 0, trial.how if not outcome.status else
                            " ".join(outcome.output.split())[-200:])
    checks.at_most("part of the commands that is not run at all", counts["excerpt"] / len(every), MOST_EXCERPTS)
