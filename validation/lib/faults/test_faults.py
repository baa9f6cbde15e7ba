# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The table of faults: what is drawn, what counts as right, what is kept."""

import json
import signal
import subprocess
import sys
import time

import pytest

from cases.lib.case.casefile import TOP
from validation.lib.faults import inputs, kills, resumed, tries, victim


def test_the_same_inputs_every_time():
    first = [inputs.words(n) for n in range(40)]
    assert first == [inputs.words(n) for n in range(40)]
    assert first != [inputs.words(n, seed=2) for n in range(40)]
    assert len({tuple(w) for w in first}) > 35
    assert all(w[0] in inputs.CASES and len(w) >= 3 for w in first)


def test_every_signal_to_every_part():
    plan = kills.plan(20)
    assert len(plan) == 20 * len(kills.TARGETS) * len(kills.SIGNALS)
    assert plan == kills.plan(20)
    assert len({t["moment"] for t in plan}) == len(plan)
    assert {t["during"] for t in plan} == {"start-up", "march"}


def test_exit_codes():
    assert kills.wanted_code("DEM half", "KILL") == kills.wanted_code("mpirun", "TERM") == 1
    assert [kills.wanted_code("cases/run", n) for n in ("KILL", "SEGV", "TERM", "INT", "HUP", "USR1")] == [
        -9, -11, 143, 130, 129, 138]


def test_runs_that_go_on_are_drawn_and_compared(tmp_path):
    plan = resumed.plan(20)
    assert plan == resumed.plan(20) and len(plan) == 20 * len(resumed.TRIALS)
    assert {t["ranks"] for t in plan} == {(1, 1), (2, 1)}
    assert resumed.SAVES < set(resumed.TRIALS)
    for name, text in (("a", "time_s,time_days,z\n0,9,-4\n1,9,2\n"), ("b", "time_s,time_days,z\n0,8,-4\n1,8,2.4\n"),
                       ("c", "time_s,time_days,z\n0,9,-4\n")):
        (tmp_path / name).mkdir()
        (tmp_path / name / "settling.csv").write_text(text)
    a, b, c = (resumed.curve(str(tmp_path / name)) for name in "abc")
    assert a == [[0, -4], [1, 2]]
    assert resumed.apart(a, a) == 0
    assert abs(resumed.apart(a, b) - 0.1) < 1e-15
    assert resumed.apart(a, c) == resumed.apart([], []) == float("inf")


class Ended:
    """A run that has ended in some way."""

    def __init__(self, code=1, left=(), state=None, said="why"):
        self.code, self.names, self.what, self.words = code, list(left), state, said

    def end(self):
        return self.code, 1.0

    def left(self, _):
        return self.names

    def said(self):
        return self.words

    def state(self):
        return {"complete": False, "reason": "why"} if self.what is None else self.what


def test_what_counts_as_right():
    trial = {"target": "DEM half", "signal": "TERM"}
    assert kills.judge(Ended(), trial) == ""
    for run, says in ((Ended(code=None), "goes on"), (Ended(code=0), "exit code 0"), (Ended(left=["x"]), "left after"),
                      (Ended(state={}), "summary.json"), (Ended(state={"complete": True}), "summary.json"),
                      (Ended(state={"complete": False, "reason": ""}), "summary.json"),
                      (Ended(said="Traceback\nwhy"), "a traceback"), (Ended(said=""), "was not said")):
        assert says in kills.judge(run, trial)


def test_tries_are_kept_and_those_of_other_programs_are_not(tmp_path):
    path, count = str(tmp_path / "tries"), []

    def attempt():
        count.append(1)
        return "bad" if len(count) == 1 else ""
    assert [tries.Tries(path, "1").outcome("a", attempt) for _ in range(3)] == ["bad", "", ""]
    assert len(count) == 2
    assert tries.Tries(path, "2").outcome("a", attempt) == ""
    assert len(count) == 3
    with open(path, "a", encoding="utf-8") as f:
        f.write(json.dumps({"version": "2", "what": "b", "wrong": ""})[:-3])  # it was killed here
    assert tries.Tries(path, "2").outcome("a", attempt) == ""
    assert len(count) == 3


def test_what_tries_are_compared_with_is_kept(tmp_path):
    made = []

    def make():
        made.append([[0.1, len(made)]])
        return made[-1], "bad" if len(made) == 1 else ""
    for of, number, says in (("1", 0, "bad"), ("1", 1, ""), ("1", 1, ""), ("2", 2, ""), ("1", 1, "")):
        assert tries.Tries(str(tmp_path / "tries"), of).kept("whole", make) == ([[0.1, number]], says)
    assert len(made) == 3


def test_shares_are_all_of_it(tmp_path):
    assert tries.parted(["kills", "disk:2/3"]) == {"kills": (1, 1), "disk": (2, 3)}
    for bad in ("kills:0/3", "kills:4/3", "kills:1", "kills:a/b"):
        with pytest.raises(ValueError):
            tries.parted([bad])
    shares = [tries.Tries(str(tmp_path / "tries"), "1", (n, 3)) for n in (1, 2, 3)]
    assert sorted(t for share in shares for t in share.mine(range(20))) == list(range(20))
    assert len({share.place("a") for share in shares}) == 3
    assert tries.Tries(str(tmp_path / "tries"), "1").place("a") == "a"


def test_nothing_is_left_when_validation_is_ended(tmp_path):
    code = ("from validation.lib.checks import coupled\nfrom cases.lib.case import program\n"
            f"program.run(lambda: coupled.execute(['sh', '-c', 'echo $$ > {tmp_path}/pid; sleep 60; true'], 60), 'x')")
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGKILL):
        p = subprocess.Popen([sys.executable, "-c", code], cwd=TOP, stderr=subprocess.DEVNULL)
        path, end = tmp_path / "pid", time.monotonic() + 30
        while not (path.exists() and path.read_text().endswith("\n")) and time.monotonic() < end:
            time.sleep(0.02)
        child = int(path.read_text())
        path.unlink()
        p.send_signal(number)
        assert p.wait(30) in (128 + number, -number)
        while victim.runs(child) and time.monotonic() < end:
            time.sleep(0.02)
        assert not victim.runs(child)


def test_a_run_heeds_what_this_process_ignores():
    code = "import signal; print(*(int(signal.getsignal(n)) for n in (signal.SIGHUP, signal.SIGTERM, signal.SIGUSR1)))"
    old = {n: signal.signal(n, signal.SIG_IGN) for n in (signal.SIGHUP, signal.SIGTERM)}
    try:
        said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True,
                              preexec_fn=victim.as_started_by_itself((signal.SIGUSR1,))).stdout
    finally:
        for number, how in old.items():
            signal.signal(number, how)
    assert said.split() == [str(int(how)) for how in (signal.SIG_DFL, signal.SIG_DFL, signal.SIG_IGN)]


def test_what_is_left_is_found():
    run = object.__new__(victim.Run)
    run.process = subprocess.Popen(["sh", "-c", "sleep 60 & sleep 60"])
    run.known = {}
    end = time.monotonic() + 20
    while len([n for n in run.known.values() if n == "sleep"]) < 2 and time.monotonic() < end:
        run.look()
    run.process.send_signal(signal.SIGKILL)
    run.process.wait()
    assert run.left(0.1) == ["sleep", "sleep"]
    for pid in run.known:
        subprocess.run(["kill", "-9", str(pid)], check=False)
