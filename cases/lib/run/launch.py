# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Starts both halves in one mpirun, shows how far they are, keeps their logs."""

import contextlib
import ctypes
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import threading
import time
from dataclasses import dataclass

from cases.lib.case import cache, files, openfoam, places, stops
from cases.lib.case.errors import CaseError
from cases.lib.run import openmpi

_UNPRINTED = re.compile(r"[\x00-\x08\x0a-\x1f\x7f\ufffd]")  # behind LIGGGHTS's words on an error
_PROGRESS = re.compile(r"^clayFoam: (t = .*)$")
# LIGGGHTS's own errors; what a half says on its standard error when it ends the run
_ERROR = re.compile(r"^\s*ERROR")
_LAST_WORD = re.compile(r"^(clayFoam|liggghts-clay): ")
# said of a half that ended for a reason of its own, which tells more
AFTERMATH = re.compile(r"ended (without ever coupling|before the coupled run did)|"
                       r"^(clayFoam|liggghts-clay): stopped: ")


def cores():
    """Cores mpirun counts as slots: physical ones that this process may use."""
    pairs, physical = set(), "0"
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as f:
            for line in f:
                key, _, value = line.partition(":")
                if key.strip() == "physical id":
                    physical = value.strip()
                elif key.strip() == "core id":
                    pairs.add((physical, value.strip()))
    except OSError:
        pass
    usable = len(os.sched_getaffinity(0))
    return min(len(pairs) or usable, usable)


@dataclass(frozen=True)
class Outcome:
    """How both halves ended: cases/run's exit code, and why if that is not 0."""

    code: int
    reason: str


_SAVING = 8  # seconds that a run which is stopped has to save its state
_PR_SET_CHILD_SUBREAPER = 36


def adopt_orphans():
    """Descendants whose parent ends become this process's children."""
    ctypes.CDLL(None).prctl(_PR_SET_CHILD_SUBREAPER, 1)


def children():
    """The processes that are children of this one."""
    found = []
    for entry in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{entry}/stat", encoding="utf-8", errors="replace") as f:
                if int(f.read().rpartition(")")[2].split()[1]) == os.getpid():
                    found.append(int(entry))
        except OSError:
            continue
    return found


class Run:
    """One coupled run in its folder."""

    def __init__(self, folder, dem, cfd):
        self.folder, self.dem, self.cfd = folder, dem, cfd
        self.restart = ""  # the DEM half's file of the saved state that the run goes on from
        self.wall = 0.0

    def exports(self):
        """The environment of both halves, besides the user's own."""
        names = dict(openfoam.environment())
        if "CLAYFOAM_CACHE" not in os.environ:  # resistances of clumps belong to the project, not into the user's home
            names["CLAYFOAM_CACHE"] = cache.place("resistance")
        if os.geteuid() == 0:
            names["OMPI_ALLOW_RUN_AS_ROOT"] = names["OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"] = "1"
        if self.dem + self.cfd > cores():
            names.update(openmpi.crowded())
        return names

    def command(self):
        """The plain line that runs both halves, as words."""
        words = ["mpirun", "--bind-to", "none"]
        if self.dem + self.cfd > cores():
            words += openmpi.CROWDED
        restart = ["-var", "restart", "1", "-var", "restart_file", self.restart] if self.restart else []
        words += ["-np", str(self.dem), "liggghts-clay", "-in", "in.liggghts", "-log", "DEM/log",
                  *restart, ":", "-np", str(self.cfd), "clayFoam", "-case", "CFD"]
        if self.cfd > 1:
            words.append("-parallel")
        return words

    def script(self):
        """What one types to run the case by hand."""
        lines = [f"cd {shlex.quote(self.folder)}",
                 f"export PATH={shlex.quote(places.programs()[0])}:$PATH"]
        lines += [f"export {k}={shlex.quote(v)}" for k, v in self.exports().items()]
        return "\n".join(lines + [shlex.join(self.command())]) + "\n"

    def write_script(self):
        with files.writing(os.path.join(self.folder, "run.sh")) as f:
            f.write("#!/bin/sh\n# This run by hand.\n" + self.script())

    def environment(self):
        path = places.programs()[0] + os.pathsep + os.environ.get("PATH", "")
        return {**os.environ, **self.exports(), "PATH": path}

    def go(self, lock=None):
        """Runs both halves to the end; gives how they ended. They keep the folder's lock."""
        words = self.command()
        words.insert(1, "--tag-output")
        for program in ("mpirun", "liggghts-clay", "clayFoam"):
            if not shutil.which(program, path=self.environment()["PATH"]):
                raise CaseError(f"{program} is not there; {places.cure()}")
        began = time.monotonic()
        adopt_orphans()
        halves = None
        try:
            with stops.passed_over():
                halves = subprocess.Popen(words, cwd=self.folder, env=self.environment(),
                                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                          stderr=subprocess.STDOUT, text=True, errors="replace",
                                          pass_fds=() if lock is None else (lock.number,),
                                          preexec_fn=stops.die_with_parent())
            watch = threading.Thread(target=self._no_orphans, args=(halves,), daemon=True)
            watch.start()
            said = self._watch(halves.stdout)
            status = halves.wait()
            watch.join()
        except stops.Stopped as e:
            return Outcome(128 + e.signal, f"ended by {e} to {places.called('run')}")
        finally:
            with stops.passed_over():
                self._end(halves)
            self.wall = time.monotonic() - began
        if status < 0:
            return Outcome(1, f"mpirun was ended by {signal.Signals(-status).name}")
        if status:
            return Outcome(1, (said or "no half said why; mpirun may have been sent a signal") +
                           f" (mpirun's exit code {status})")
        return Outcome(0, "")

    @staticmethod
    def _no_orphans(halves):
        """Ends ranks that outlive their mpirun: they may hold the pipe that is read."""
        halves.wait()
        for pid in children():
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)

    @staticmethod
    def _end(halves):
        """Nothing that was started is left behind."""
        if halves and halves.poll() is None:
            # at the next exchange both halves save their states, and end
            halves.send_signal(signal.SIGUSR1)
            with contextlib.suppress(subprocess.TimeoutExpired):
                halves.wait(_SAVING)
        if halves and halves.poll() is None:
            halves.terminate()
            try:
                halves.wait(10)
            except subprocess.TimeoutExpired:
                halves.kill()
                halves.wait()
        # ranks whose mpirun is gone
        for pid in children():
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        for pid in children():
            with contextlib.suppress(ChildProcessError):
                os.waitpid(pid, 0)

    def _watch(self, stream):
        """Sorts what the halves say; returns the line that tells of an error."""
        shown = _Progress()
        said, after, others = "", "", []
        path = os.path.join(self.folder, "CFD", "log")
        with files.naming(path), open(path, "w", encoding="utf-8", buffering=1) as log:
            for line in stream:
                tag = openmpi.TAG.match(line)
                if not tag:
                    others.append(line.strip())
                    continue
                rank, content = int(tag.group(1)), _UNPRINTED.sub("", tag.group(3))
                if rank >= self.dem:
                    log.write(content + "\n")
                step = _PROGRESS.match(content)
                if step:
                    shown.show(step.group(1))
                elif (_ERROR.match(content) or
                      tag.group(2) == "err" and _LAST_WORD.match(content)):
                    if AFTERMATH.search(content):
                        after = after or content.strip()
                    else:
                        said = said or content.strip()
        shown.close()
        if said or after:
            return said or after
        # a half that was killed says nothing; mpirun does
        lines = [x for x in others if x and not x.startswith("--")]
        return openmpi.noticed(others) or " ".join(lines[:3])


class _Progress:
    """One line, renewed in place on a terminal, else now and then."""

    def __init__(self):
        self.terminal = sys.stdout.isatty()
        self.last, self.share, self.width = 0.0, -100.0, 0

    def show(self, line):
        if self.terminal:
            print("\r" + line.ljust(self.width), end="", flush=True)
            self.width = len(line)
            return
        match = re.search(r"([\d.]+) %", line)
        share = float(match.group(1)) if match else 0.0
        now = time.monotonic()
        if share - self.share >= 5 or now - self.last >= 10 or share >= 100:
            print(line, flush=True)
            self.share, self.last = share, now

    def close(self):
        if self.terminal and self.width:
            print()
