# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of saved states in a run folder: checkpoints/STEP/dem and cfd, with the
sums by which a torn, mixed or missing part is found (exchange/saved_pair.h)."""

import os
import re
import shutil
import zlib
from dataclasses import dataclass

from cases.lib.case.errors import CaseError
from cases.lib.case.places import called

FOLDER = "checkpoints"
_FIRST = re.compile(r"pair (\d+) step (\d+)$")
_NUMBER = re.compile(r"^(\w+)\s+(\S+);", re.M)


@dataclass(frozen=True)
class Pair:
    """A complete pair: its folder, number and DEM step, the time [s], the parts
    of the CFD half, one a rank."""

    folder: str
    number: int
    step: int
    time: float
    cfd: tuple

    @property
    def dem(self):
        """The file that the DEM half reads."""
        return os.path.join(self.folder, "dem", "state")


def _sum(path):
    total, size = 0, 0
    with open(path, "rb") as f:
        while part := f.read(1 << 20):
            total, size = zlib.crc32(part, total), size + len(part)
    return f"{total:08x} {size}"


def _part(folder):
    """Number and step of one half's part; CaseError where it is not whole."""
    path = os.path.join(folder, "sums")
    try:
        with open(path, encoding="utf-8") as f:
            lines = f.read().splitlines()
    except (OSError, UnicodeDecodeError):
        raise CaseError(f"{path} is missing") from None
    first = _FIRST.match(lines[0]) if lines else None
    if not first or len(lines) < 2:
        raise CaseError(f"{path} is torn")
    for line in lines[1:]:
        words = line.split(" ", 2)
        if len(words) != 3:
            raise CaseError(f"{path} is torn")
        file = os.path.join(folder, words[2])
        if not os.path.isfile(file):
            raise CaseError(f"{file} is missing")
        if _sum(file) != f"{words[0]} {words[1]}":
            raise CaseError(f"{file} is not what was written")
    return int(first.group(1)), int(first.group(2))


def numbers(folder):
    """The numbers of the CFD half's part, {name: text}."""
    with open(os.path.join(folder, "uniform", "couplingPair"), encoding="utf-8") as f:
        return dict(_NUMBER.findall(f.read()))


def read(folder):
    """The pair of that folder; CaseError names what is torn, mixed or missing."""
    found = _part(os.path.join(folder, "dem"))
    cfd = os.path.join(folder, "cfd")
    ranks = sorted((d for d in os.listdir(cfd) if d.startswith("processor")), key=lambda d: int(d[9:])) \
        if os.path.isdir(cfd) else []
    parts = [os.path.join(cfd, d) for d in ranks] or [cfd]
    for part in parts:
        other = _part(part)
        if other != found:
            raise CaseError(f"{part} is of pair {other[0]}, the DEM half's part of pair {found[0]}")
    said = numbers(parts[0])
    if int(said["ranks"]) != len(parts):
        raise CaseError(f"{cfd} has the parts of {len(parts)} ranks of {said['ranks']}")
    return Pair(folder, *found, float(said["time"]), tuple(parts))


def latest(run_folder, tell=print, before=None):
    """The last complete pair of a run, of a step before that one; what is passed
    over is told. CaseError where there is none."""
    top = os.path.join(run_folder, FOLDER)
    steps = [d for d in os.listdir(top) if d.isdigit() and (before is None or int(d) < before)] \
        if os.path.isdir(top) else []
    for name in sorted(steps, key=int, reverse=True):
        try:
            return read(os.path.join(top, name))
        except CaseError as e:
            tell(f"{called('run')}: passed over, not whole: {e}")
    raise CaseError(f"{run_folder} holds no complete saved state (in {FOLDER})")


def put(pair, case_folder, name):
    """Copies the CFD half's part to the time folder `name` of the case, of each
    rank's where there were several. Written beside its place and renamed."""
    for part in pair.cfd:
        rank = os.path.basename(part)
        at = os.path.join(case_folder, rank, name) if rank.startswith("processor") else os.path.join(case_folder, name)
        beside = at + ".part"
        shutil.rmtree(beside, ignore_errors=True)
        shutil.copytree(part, beside, ignore=shutil.ignore_patterns("sums"))
        shutil.rmtree(at, ignore_errors=True)
        os.replace(beside, at)
