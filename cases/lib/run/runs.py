# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A store of runs: a run that was made once is not made again.

Every run lies in a folder named by its case and a key, the hash of all that
decides its result. Runs are made by cases/run's own program, each a process of its
own, several at once; killed ones are made anew, failed ones reported.
"""

import contextlib
import fcntl
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
import time
import warnings
from dataclasses import dataclass

from cases.lib.case import files, places, settings, stops
from cases.lib.case.casefile import Case, TOP, text
from cases.lib.case.errors import CaseError
from cases.lib.run import folders, launch, openmpi, runkey, state

_DONE = "run.json"
_SHARE = re.compile(r"([\d.]+) %")


class RunFailed(CaseError):
    """A run that did not come to its end."""


@dataclass(frozen=True)
class Result:
    """A run of `run_many`: its folder, the error's line or "", whether it was
    there before, the wall time [s] it took when it was made."""

    folder: str
    error: str = ""
    reused: bool = False
    wall_s: float = 0.0


@dataclass
class _Job:
    name: str
    changes: dict
    key: str
    folder: str
    work: float
    lock: int = -1
    process: object = None
    began: float = 0.0


def default_jobs(ranks=2):
    """Runs at once so that every rank has a core: of 2 ranks, half the cores."""
    return max(1, launch.cores() // ranks)


def curve(folder):
    """The columns of a run's settling.csv as arrays by name."""
    import numpy as np
    path = os.path.join(folder, "settling.csv")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of an empty file
            rows = np.genfromtxt(path, delimiter=",", names=True)
        good = rows.size and {"time_s", "interface_m"} <= set(rows.dtype.names or ())
    except (ValueError, IndexError):  # rows of other lengths; an empty file
        good = False
    if not good:
        raise CaseError(f"{path}: is not the settling curve of a run")
    return {k: np.atleast_1d(rows[k]) for k in rows.dtype.names}


def _note(folder):
    """What the store noted of a run when it had ended well, {} without."""
    try:
        with open(os.path.join(folder, _DONE), encoding="utf-8") as f:
            found = json.load(f)
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) and "wall_s" in found else {}


def words(changes):
    """Changes as one reads them."""
    return " ".join(f"{k}={v if isinstance(v, str) else text(v)}" for k, v in changes.items())


class Store:
    """Runs in `folder` (results/runs); `ranks` of the DEM and of the CFD half.

    tell(line) is what progress goes to. command(name, changes, folder) gives
    the words of the process that makes a run.
    """

    def __init__(self, folder=None, ranks=(1, 1), tell=None, command=None, frames=2):
        self.folder = os.path.abspath(folder or os.path.join(places.base(), "results", "runs"))
        self.ranks, self.frames = ranks, frames
        self.tell = tell or (lambda line: print(line, flush=True))
        self.command = command or self._command

    def _command(self, name, changes, folder):
        found = [sys.executable, "-E", "-s", "-B", TOP, "cases.lib.run.run_main", name,
                 "--dem", str(self.ranks[0]), "--cfd", str(self.ranks[1]), "--no-pictures", "--out", folder]
        for key, value in {"frames": self.frames, **changes}.items():
            found += ["--set", f"{key}={value if isinstance(value, str) else text(value)}"]
        return found

    def _job(self, name, changes):
        case = Case(name)
        settings.apply(case, {"frames": self.frames, **changes})
        derived = case.derive(*self.ranks)
        key = runkey.key(case, derived)
        return _Job(name, changes, key, os.path.join(self.folder, f"{case.name}-{key}"), float(derived["steps"]))

    def finished(self, name, changes):
        """The folder of a run that is there already, else None."""
        job = self._job(name, changes)
        return job.folder if self._is_finished(job) else None

    @staticmethod
    def _is_finished(job):
        note = _note(job.folder)
        return (note.get("key") == job.key and state.complete(job.folder)
                and note.get("settling.csv") == files.sha256(os.path.join(job.folder, "settling.csv")))

    def run(self, name, changes):
        """The folder of a finished run; RunFailed when it fails."""
        result = self.run_many([(name, changes)])[0]
        if result.error:
            raise RunFailed(result.error)
        return result.folder

    def run_many(self, wanted, jobs=None):
        """Makes what is wanted, a list of (case, changes); a list of Results.

        At most `jobs` at once, never more than there are cores.
        """
        jobs = max(1, min(jobs or default_jobs(sum(self.ranks)), launch.cores()))
        os.makedirs(self.folder, exist_ok=True)
        asked = [self._job(*w) for w in wanted]
        unique = {job.key: job for job in asked}
        results = {k: self._there(job) for k, job in unique.items() if self._is_finished(job)}
        waiting = [job for k, job in unique.items() if k not in results]
        if results and waiting:
            self.tell(f"{len(results)} of {len(unique)} runs are there already")
        if waiting:
            old = None
            if (threading.current_thread() is threading.main_thread()
                    and signal.getsignal(signal.SIGTERM) == signal.SIG_DFL):
                old = signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
            try:
                self._work(waiting, jobs, results, len(unique))
            finally:
                if old is not None:
                    signal.signal(signal.SIGTERM, old)
        return [results[job.key] for job in asked]

    @staticmethod
    def _there(job):
        return Result(job.folder, reused=True, wall_s=_note(job.folder)["wall_s"])

    def _work(self, waiting, jobs, results, total):
        going, elsewhere, began, told = [], set(), time.monotonic(), time.monotonic()
        done, all_work = 0.0, sum(job.work for job in waiting)
        try:
            while waiting or going:
                for job in list(waiting):
                    if len(going) >= jobs:
                        break
                    if not self._take(job):  # look again later
                        if job.key not in elsewhere:
                            self.tell(f"another process makes {job.name} {words(job.changes)}: waiting for it")
                        elsewhere.add(job.key)
                        continue
                    waiting.remove(job)
                    if self._is_finished(job):  # by that process
                        os.close(job.lock)
                        results[job.key] = self._there(job)
                        all_work -= job.work
                    else:
                        self._start(job, jobs * sum(self.ranks) > launch.cores())
                        going.append(job)
                for job in [j for j in going if j.process.poll() is not None]:
                    going.remove(job)
                    result = results[job.key] = self._end(job)
                    done += job.work
                    said = result.error or f"{job.name} {words(job.changes)}: {result.wall_s:.0f} s"
                    self.tell(f"run {len(results)} of {total}: {said}")
                if time.monotonic() - told > 30 and going:
                    told = time.monotonic()
                    shares = [self._share(job) for job in going]
                    part = done + sum(s * j.work for s, j in zip(shares, going))
                    left = f"about {_long((told - began) * (all_work - part) / part)} to go" if part else ""
                    self.tell(f"{len(results)} of {total} runs finished, {len(going)} going "
                              f"({', '.join(f'{100 * s:.0f} %' for s in shares)}) {left}".rstrip())
                time.sleep(0.1)
        finally:
            for job in going:
                self._stop(job)

    def _take(self, job):
        """Whether the run is this process's to make, and no other's."""
        job.lock = os.open(job.folder + ".lock", os.O_CREAT | os.O_RDWR, 0o644)
        try:
            fcntl.flock(job.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            return True
        except OSError:
            os.close(job.lock)
            return False

    def _start(self, job, crowded):
        shutil.rmtree(job.folder, ignore_errors=True)
        job.began = time.monotonic()
        with open(job.folder + ".log", "w", encoding="utf-8") as log:
            # the lock lasts as long as the run, even if this process is killed
            job.process = subprocess.Popen(
                self.command(job.name, job.changes, job.folder), stdin=subprocess.DEVNULL, stdout=log,
                stderr=subprocess.STDOUT, start_new_session=True, pass_fds=(job.lock,),
                env={**os.environ, **openmpi.YIELD} if crowded else None, preexec_fn=stops.die_with_parent())

    @staticmethod
    def _share(job):
        """How far a run is, 0 to 1."""
        try:
            with open(job.folder + ".log", encoding="utf-8", errors="replace") as f:
                found = _SHARE.findall(f.read())
        except OSError:
            return 0.0
        return min(1.0, float(found[-1]) / 100) if found else 0.0

    def _end(self, job):
        """Notes how a run ended."""
        seconds = time.monotonic() - job.began
        log, error = job.folder + ".log", ""
        if job.process.returncode:
            error = _error(log, job.process.returncode)
        elif not all(os.path.isfile(os.path.join(job.folder, f)) for f in ("summary.json", "settling.csv")):
            error = "ended without summary.json and settling.csv"
        elif not state.complete(job.folder):
            error = folders.summary(job.folder).get("reason") or "it is not complete"
        elif not self._same(job):
            error = "its input files or the programs were changed while it ran"
        os.makedirs(job.folder, exist_ok=True)
        shutil.move(log, os.path.join(job.folder, "log"))
        if error:
            error = f"{job.name} {words(job.changes)} failed: {error} (log in {job.folder}/log)"
        else:
            files.write_json(os.path.join(job.folder, _DONE), {
                "case": job.name, "changes": job.changes, "key": job.key, "wall_s": round(seconds, 3),
                "settling.csv": files.sha256(os.path.join(job.folder, "settling.csv"))})
        os.close(job.lock)
        return Result(job.folder, error, False, seconds)

    def _same(self, job):
        """Whether the run's key is still that of its input files and programs."""
        try:
            return self._job(job.name, job.changes).key == job.key
        except (CaseError, OSError):  # one of them is gone
            return False

    @staticmethod
    def _stop(job):
        """Ends a run and all it started."""
        job.process.terminate()  # it ends its halves itself
        with contextlib.suppress(subprocess.TimeoutExpired):
            job.process.wait(15)
        # what is left of it; a run is a session of its own
        with contextlib.suppress(ProcessLookupError):
            os.killpg(job.process.pid, signal.SIGKILL)
        with contextlib.suppress(subprocess.TimeoutExpired):
            job.process.wait(5)
        os.close(job.lock)


def _error(log, status):
    """The line of a failed run's log that says why."""
    with open(log, encoding="utf-8", errors="replace") as f:
        lines = [x.strip() for x in f if x.strip()]
    after = [i for i, x in enumerate(lines) if x.startswith(f"{places.called('run')}: stopped")]
    if after and after[-1] + 1 < len(lines):
        return lines[after[-1] + 1]
    return lines[-1] if lines else f"exit code {status}"


def _long(seconds):
    """A length of time as one says it."""
    if seconds < 90:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"
