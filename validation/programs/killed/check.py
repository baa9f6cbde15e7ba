# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A half that is killed in the middle of a run must not leave the other behind."""

import os
import signal
import subprocess
import time

from validation.lib.checks import coupled
from validation.lib.checks.verdicts import Broken

TITLE = "one half killed: the other ends too, soon and with an error"
SECONDS = 20


def _children(parent):
    """Processes that descend from one, as (pid, name)."""
    found = []
    for entry in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{entry}/stat", encoding="utf-8") as f:
                head, _, tail = f.read().rpartition(")")
        except OSError:
            continue
        if int(tail.split()[1]) == parent:
            found.append((int(entry), head.partition("(")[2]))
            found += _children(int(entry))
    return found


def _runs(pid):
    """Whether a process is there, and not just its entry."""
    try:
        with open(f"/proc/{pid}/stat", encoding="utf-8") as f:
            return f.read().rpartition(")")[2].split()[0] not in "ZX"
    except OSError:
        return False


def _kill(checks, program):
    folder = os.path.join(coupled.RUNS, "killed", program)
    run = subprocess.Popen([os.path.join(coupled.TOP, "cases", "run"), "--no-setup", "clump-half",
                            "--out", folder, "--overwrite", "--end", "1"], stdin=subprocess.DEVNULL, text=True,
                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    try:
        # its first line of progress, after those on plan and packing, says that both halves march
        said = [run.stdout.readline() for _ in range(3)]
        if not any(line.startswith("t = ") for line in said):
            raise Broken(f"{program}: the run did not start: {''.join(said)} {run.stdout.read()[-200:]}")
        halves = {name[:15]: pid for pid, name in _children(run.pid)}
        os.kill(halves[program], signal.SIGKILL)
        began = time.monotonic()
        output, _ = run.communicate(timeout=60)
        seconds = time.monotonic() - began
    finally:
        if run.poll() is None:
            run.terminate()
            run.wait()
    checks.true(f"{program} killed: exit code not 0", run.returncode != 0, run.returncode)
    checks.at_most(f"{program} killed: seconds until all ended", seconds, SECONDS)
    checks.equal(f"{program} killed: halves left",
                 [name for name, pid in halves.items() if _runs(pid)], [])
    checks.true(f"{program} killed: a line says so", "signal 9" in output or "ended" in output,
                output.strip().splitlines()[-1])


def run(checks):
    _kill(checks, "liggghts-clay")
    _kill(checks, "clayFoam")
