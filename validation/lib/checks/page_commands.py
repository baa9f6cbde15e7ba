# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The commands that stand in the project's pages, and how each is tried: as it stands, made short, or by its words."""

import glob
import os
import re
import shlex
from dataclasses import dataclass

from cases.lib.case.casefile import TOP

_CASES = ("run", "report", "pack", "stages", "consolidation", "study", "calibrate", "sweep", "kynch", "figures",
          "scaling", "clay")
_CHECKS = ("run", "stress", "matrix", "bench", "growth")
_PROGRAMS = (*(f"cases/{n}" for n in _CASES), *(f"validation/{n}" for n in _CHECKS), "clay", "cmake/setup.sh", "cmake",
             "ctest", "cpack", "python3", "clang-format", "mpirun", "liggghts-clay", "clayFoam", "source", "cd",
             "export", "cp", "mkdir", "sphinx-build", "surfaceMeshTriangulate", "blockMesh", "snappyHexMesh")
_START = re.compile(r"^(?:" + "|".join(map(re.escape, _PROGRAMS)) + r"|build/bin/\w+)(?=\s|$)")
HOWS = ("as it stands", "made short", "its words", "excerpt")


@dataclass(frozen=True)
class Command:
    """A command of a page."""

    page: str
    line: int
    text: str
    block: bool  # or within a sentence
    fenced: bool = False


@dataclass(frozen=True)
class Trial:
    """How a command is tried: words to run, where ("project", "run": the folder of a prepared run, "script": of a
    script), and how much of the command that is, one of HOWS."""

    how: str
    words: tuple = ()
    where: str = "project"


def pages():
    """All pages, without those of build and results."""
    found = [os.path.relpath(p, TOP) for p in glob.glob(os.path.join(TOP, "**", "*.md"), recursive=True)]
    return sorted(p for p in found if p.split(os.sep)[0] not in ("build", "results"))


def commands(page, text):
    """The Commands of a page's text: lines of its blocks, and what stands between backquotes with more than a name."""
    found, fence, held = [], False, None
    for number, line in enumerate(text.split("\n"), 1):
        if line.startswith("```"):
            fence = not fence
            continue
        if fence or line.startswith("    "):
            said = (held[1] + " " if held else "") + line.strip()
            if said.endswith("\\"):
                held = (held or (number,))[0], said[:-1].strip()
                continue
            at, held = held[0] if held else number, None
            said = re.sub(r"^[$>] ", "", said)
            if _START.match(said) and not re.match(r"^(cd|export|cp|mkdir|source|clayFoam|cmake)\s{2,}", said):
                found.append(Command(page, at, re.split(r"\s+#\s", said)[0].strip(), True, fence))
            continue
        for said in re.findall(r"`([^`]+)`", line):
            # a program with an option is spoken of; with what it is to act on it is a command
            if _START.match(said) and any(not w.startswith("-") for w in said.split()[1:]):
                found.append(Command(page, number, said.strip(), False))
    return found


def every_command():
    """The commands of all pages, those that are alike once."""
    found = {}
    for page in pages():
        with open(os.path.join(TOP, page), encoding="utf-8") as f:
            for c in commands(page, f.read()):
                found.setdefault(" ".join(c.text.split()), c)
    return list(found.values())


def _filled(text):
    """A command with values where the page has words in capitals or dots for them."""
    program = text.split()[0]
    case = "linters" if program.startswith("validation/") else "clump-half"
    number = {"cases/figures": "2"}.get(program, "2")
    curve = "kept.csv" if "--make-data" in text else "curve.csv" if program == "cases/stages" else "kept.json"
    for word, value in ((r"\[CASE\]", ""), (r"KEY=A,B,C", "charge=1e-10,2e-10"), (r"charge=\.\.\.", "charge=3e-10"),
                        (r"time_scale=\.\.\.", "time_scale=8e5"), (r"\bCASE\b", case), (r"\bNAME\b", case),
                        (r"\bDIR\b", "kept"), (r"\bFILE\b", curve), (r"\bPART\b", "kills"), (r"\bT\b", "0.02"),
                        (r"--cfd M\b", "--cfd 2"), (r"\bM\b", "5e-4"), (r"\bN\b", number),
                        (r"--prefix A\b", "--prefix kept-prefix")):
        text = re.sub(word, value, text)
    return text


def trial(command):
    """The Trial of a command."""
    if command.page.startswith("manual") and command.fenced:
        return Trial("as it stands", where="tutorials")  # which that check runs, in their order
    text = _filled(command.text)
    if "..." in text or "&&" in text or "$" in text:
        return Trial("excerpt")
    words = shlex.split(text)
    if words[0] == "export":
        return Trial("as it stands", ("bash", "-c", text))
    program = words[0]
    if text.startswith("cmake --build build --target docs"):
        return Trial("as it stands", tuple(words), "build")
    if program in ("clay", "cases/clay") and len(words) > 1:
        return _of_cases(["cases/clay"], [w for w in words[1:] if w != "--quiet"], "--quiet" in words)
    if program.startswith("cases/"):
        return _of_cases([], [program[6:], *words[1:]])
    if program.startswith("validation/"):
        return _of_checks(program, words[1:])
    if program in ("mpirun", "liggghts-clay"):
        return _of_halves(words)
    if program.startswith("build/bin/"):
        return Trial("its words", (*words, "--gtest_list_tests"), "build")
    short = {"ctest": ("its words",
                       (*words, *([] if "--test-dir" in words else ["--test-dir", "build"]), "-N"),
                       "build"),
             "cpack": ("made short", (*words[:-1], "kept-packages"), "build"),
             "python3": ("its words", (*words, "--collect-only", "-q"), "build"),
             "clang-format": ("made short", tuple("--dry-run" if w == "-i" else w for w in words), "shell"),
             "source": ("as it stands", ("bash", "-c", text), "project")}
    if text.startswith("cmake --install"):
        return Trial("as it stands", tuple(words), "build") if "--prefix" in words else Trial("excerpt")
    return Trial(*short[program]) if program in short and len(words) > 1 else Trial("excerpt")


def _of_cases(before, words, quiet=False):
    """cases/PROGRAM ..., or clay PROGRAM ..."""
    name, rest = words[0], words[1:]
    start = [*before, "--no-setup", *(["--quiet"] if quiet else []), name] if before else [
        f"cases/{name}", "--no-setup"]
    how, more = "as it stands", []
    if not rest and name != "scaling":
        how, more = "its words", ["--help"]
    elif name == "run":
        if rest[0].startswith("--") and rest[0] not in ("--list",):
            return Trial("excerpt")
        if not {"--list", "--keys", "--dry-run"} & set(rest):
            at = [i for i, w in enumerate(rest) if w == "--end"]
            short = "0.04" if "--continue" in rest else "0.02"
            if at:
                rest[at[0] + 1] = short
            else:
                more = ["--end", short]
            how = "made short"
    elif name in ("sweep", "figures", "study"):
        how, more = "made short", ["--dry-run"]
    elif name == "kynch" and "--solve" not in rest:
        how, more = ("its words", ["--help"]) if "--runs" in rest else ("made short", ["--solve"])
    elif name in ("calibrate", "consolidation"):
        how, more = "its words", ["--help"]
    return Trial(how, (*start, *rest, *more))


def _of_checks(program, rest):
    """Checks take their time: their names and options are tried."""
    listed = {"validation/run", "validation/matrix"}
    if program in listed and "--list" in rest:
        return Trial("as it stands", (program, "--no-setup", *rest))
    return Trial("its words", (program, "--no-setup", *rest, "--list" if program in listed else "--help"))


def _of_halves(words):
    """Both halves in the folder of a run that was prepared, or the DEM half alone with a script of its own."""
    if words[0] == "liggghts-clay":
        return Trial("as it stands", tuple(words), "script")
    # more ranks than that are for clusters
    counts = [int(w) for before, w in zip(words, words[1:]) if before == "-np"]
    if sum(counts) > 6 or "-var" in words or len(counts) != 2:
        return Trial("excerpt")
    script = words[words.index("-in") + 1]
    return Trial("as it stands", tuple(words), f"run {counts[0]} {counts[1]} {script}")
