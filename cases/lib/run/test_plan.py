# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What is foreseen of a run, and what is refused before any work is done."""

import os
import re
import resource
import subprocess

import pytest

from cases.lib.case import settings
from cases.lib.case.casefile import Case, TOP
from cases.lib.case.errors import CaseError
from cases.lib.run import plan


def values(name="clump-half", dem=1, cfd=1, **changes):
    case = Case(name)
    settings.apply(case, changes)
    return {**case.values, **case.derive(dem, cfd)}


def test_counts():
    p = plan.foresee(values())
    assert (p.cells, p.spheres, p.steps, p.exchanges) == (576, 1890, 448000, 7000)
    assert plan.foresee(values("column1890")).cells == 8 * 8 * 12
    assert plan.foresee(values("fluidised-bed", mesh="tet")).cells == 6 * 4 * 4 * 24
    assert plan.foresee(values("lattice-scene")).spheres == 8 * 8 * 24
    assert plan.foresee(values("growth-scene", across=20)).spheres == 8000


def test_costs_grow_as_they_should():
    one, more = plan.foresee(values()), plan.foresee(values(end=14))
    assert more.seconds == pytest.approx(2 * one.seconds)
    assert more.memory == one.memory
    cells = plan.foresee(values(layers=12000))
    assert cells.memory - one.memory == pytest.approx(576 * 999 * 8e3)
    far = plan.foresee(values(cutoff=1))
    assert far.memory - one.memory == pytest.approx(4 * (far_pairs(1e9) - far_pairs(0.012)), rel=1e-6)
    assert plan.foresee(values(charge=0, cutoff=1)).memory == pytest.approx(plan.foresee(values(charge=0)).memory)


def far_pairs(cutoff):
    return plan._pairs({**values(), "cutoff": cutoff}, 1890)


def test_one_line():
    line = plan.foresee(values()).line()
    assert re.fullmatch(r"plan: 576 cells, 1890 spheres, 448000 steps, 7000 exchanges; about 1\d\d MB of memory, "
                        r"\d+ MB of disk, \d+ s", line)


def test_the_machine_is_seen():
    with open("/proc/meminfo", encoding="utf-8") as f:
        all_of_it = int(f.readline().split()[1]) * 1024
    assert 1e8 < plan.machine_memory() <= all_of_it


@pytest.mark.parametrize("changes, dem, cfd, cores, memory, says", [
    ({}, 1, 577, 1000, 1e12, "--cfd 577: must be at most the 576 cells of the mesh"),
    ({}, 9, 8, 2, 1e12, "--dem 9 --cfd 8: must be at most 16 ranks on the 2 cores of this machine; --oversize"),
    ({}, 1, 1, 2, 1e8, "this machine has 100 MB; take fewer cells or particles, or --oversize")])
def test_refusals(changes, dem, cfd, cores, memory, says):
    v = values(dem=dem, cfd=cfd, **changes)
    with pytest.raises(CaseError, match=re.escape(says)):
        plan.check(plan.foresee(v), v, cores, memory)


def test_what_fits_is_not_refused():
    v = values(dem=8, cfd=8)
    plan.check(plan.foresee(v), v, 2, 1e9)


def spent():
    """Processor time [s] of all children that have ended, whatever else the machine does."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


@pytest.mark.parametrize("words, says", [
    (["--set", "core_cells=10000"], "core_cells = 10000: must be a whole number from 1 to 500"),
    (["--set", "clumps=1e8"], "clumps = 1e8: must be a whole number from 1 to 10000000"),
    (["--set", "solids=99.9"], "solids = 99.9 %: are 0.997 of the suspension by volume"),
    (["--set", "layers=1e6"], "layers = 1e6: must be a whole number from 1 to 20000"),
    (["--set", "cutoff=1e5"], "cutoff = 1e5: must be a finite number above 0 and of at most 1 m"),
    (["--set", "core_cells=500", "--set", "layers=20000"], "take fewer cells or particles, or --oversize"),
    (["--cfd", "1000"], "--cfd 1000: must be at most the 576 cells of the mesh")])
def test_sizes_are_refused_at_once(words, says, tmp_path):
    before = spent()
    done = subprocess.run([os.path.join(TOP, "cases", "run"), "--no-setup", "clump-half", "--out", str(tmp_path / "r"),
                           *words], capture_output=True, text=True, check=False, timeout=60)
    assert (done.returncode, done.stderr.count("\n")) == (2, 1)
    assert says in done.stderr
    assert not (tmp_path / "r").exists()
    assert spent() - before < 2


def test_oversize_and_dry_run_go_on(tmp_path):
    for words in (["--oversize"], []):
        done = subprocess.run([os.path.join(TOP, "cases", "run"), "--no-setup", "sphere-half", "--dry-run", "--out",
                               str(tmp_path / "r"), "--dem", "100", *words], capture_output=True, text=True,
                              check=False)
        assert done.returncode == 0, done.stderr
        assert "-np 100 liggghts-clay" in done.stdout
