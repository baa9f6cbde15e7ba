# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A run to which something is done: started, watched, and looked at afterwards."""

import json
import os
import signal
import subprocess
import tempfile
import time

from cases.lib.case import stops
from cases.lib.case.casefile import TOP

LIMIT = 90  # [s] for a run to end once something was done to it
PROGRAMS = {"DEM half": "liggghts-clay", "CFD half": "clayFoam", "mpirun": "mpirun"}


def slowdown():
    """How many times longer than on a machine with nothing else to do things may take here."""
    return max(1.0, os.getloadavg()[0] / (os.cpu_count() or 1))


def stat(pid):
    """(parent, name, state) of a process, None when it is gone."""
    try:
        with open(f"/proc/{pid}/stat", encoding="utf-8", errors="replace") as f:
            head, _, tail = f.read().rpartition(")")
    except OSError:
        return None
    words = tail.split()
    return int(words[1]), head.partition("(")[2], words[0]


def runs(pid):
    """Whether a process is there, and not just its entry."""
    found = stat(pid)
    return found is not None and found[2] not in "ZX"


def children(pid):
    """The children of a process, of whichever of its threads."""
    found = []
    try:
        for thread in os.listdir(f"/proc/{pid}/task"):
            with open(f"/proc/{pid}/task/{thread}/children", encoding="utf-8") as f:
                found += map(int, f.read().split())
    except OSError:
        pass  # it has ended
    return found


def descendants(root):
    """The processes that descend from one, {pid: name}."""
    found, new = {}, [root]
    while new:
        new = [c for pid in new for c in children(pid)]
        for pid in new:
            told = stat(pid)
            if told:
                found[pid] = told[1]
    return found


def as_started_by_itself(ignore=()):
    """For preexec_fn: signals are as a shell gives them, also where this process was told to ignore some (nohup)."""
    ends = stops.die_with_parent()

    def begin():
        ends()
        signal.signal(signal.SIGHUP, signal.SIG_DFL)
        for number in ignore:
            signal.signal(number, signal.SIG_IGN)
    return begin


class Run:
    """cases/run with some words in a folder of its own, output in a file."""

    def __init__(self, name, folder, *words, env=None, ignore=()):
        self.folder = folder
        self.output = tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace")
        self.process = subprocess.Popen(
            [os.path.join(TOP, "cases", "run"), "--no-setup", name, "--out", folder, "--no-pictures", *words],
            stdin=subprocess.DEVNULL, stdout=self.output, stderr=subprocess.STDOUT, start_new_session=True,
            env={**os.environ, **(env or {})},
            preexec_fn=as_started_by_itself(ignore))
        self.known = {}

    def said(self):
        """All it has said so far."""
        self.output.seek(0)
        return self.output.read()

    def look(self):
        """Notes the processes there are; whether it goes on."""
        self.known.update(descendants(self.process.pid))
        return self.process.poll() is None

    def until(self, ready, seconds=60.0):
        """Waits for a condition; False when the run ended or the time is over before."""
        end = time.monotonic() + seconds * slowdown()
        while self.look() and time.monotonic() < end:
            if ready():
                return True
            time.sleep(0.02)
        return False

    def started(self):
        """Whether both halves are there."""
        return set(PROGRAMS.values()) <= set(self.known.values())

    def marches(self):
        """Whether a line of progress was said."""
        return "\nt = " in self.said()

    def find(self, target):
        """The process of a target: `cases/run`, or one of PROGRAMS."""
        if target == "cases/run":
            return self.process.pid
        return next((p for p, name in self.known.items() if name == PROGRAMS[target][:15] and runs(p)), None)

    def send(self, target, number):
        """Sends a signal; whether there was somebody to get it."""
        pid = self.find(target)
        if pid is None:
            return False
        try:
            os.kill(pid, number)
        except ProcessLookupError:
            return False
        return True

    def end(self, limit=LIMIT):
        """Waits for the end; (exit code or None, seconds)."""
        began = time.monotonic()
        while self.look() and time.monotonic() - began < limit * slowdown():
            time.sleep(0.05)
        return self.process.poll(), time.monotonic() - began

    def left(self, seconds=10.0):
        """Names of processes that are there still, after that time at most."""
        end = time.monotonic() + seconds * slowdown()
        while time.monotonic() < end and any(runs(p) for p in self.known):
            time.sleep(0.05)
        return sorted(name for p, name in self.known.items() if runs(p))

    def state(self):
        """summary.json, {} without."""
        try:
            with open(os.path.join(self.folder, "summary.json"), encoding="utf-8") as f:
                return json.load(f)
        except (OSError, ValueError):
            return {}

    def close(self):
        """Leaves nothing of it."""
        for pid in [*self.known, self.process.pid]:
            if runs(pid):
                try:
                    os.kill(pid, signal.SIGKILL)
                except ProcessLookupError:
                    pass
        self.process.wait()
        self.output.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()
