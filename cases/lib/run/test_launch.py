# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""How a run is watched and ended, with a small script in the place of mpirun."""

import os
import signal
import subprocess
import sys
import textwrap
import time

import pytest

from cases.lib.case.casefile import TOP
from cases.lib.run import launch


@pytest.fixture
def run(tmp_path):
    (tmp_path / "CFD").mkdir()
    return launch.Run(str(tmp_path), 1, 1)


def test_the_reason_is_the_line_without_garbage(run, tmp_path):
    said = run._watch(["[1,1]<stdout>: clayFoam: starts\n", "[1,0]<stdout>:ERROR: no room\x07\x00\ufffd\x01\n",
                       "[1,1]<stderr>:clayFoam: stopped: the DEM half ended: no room\n"])
    assert said == "ERROR: no room"
    assert (tmp_path / "CFD" / "log").read_text().splitlines() == [
        "clayFoam: starts", "clayFoam: stopped: the DEM half ended: no room"]


def program(tmp_path, name, text):
    path = tmp_path / "bin" / name
    path.parent.mkdir(exist_ok=True)
    path.write_text(f"#!{sys.executable}\n{textwrap.dedent(text)}")
    path.chmod(0o755)


# cases/run's launcher with the folder of stand-ins first on the PATH; says the outcome
GO = textwrap.dedent("""
    import os, sys
    from cases.lib.case import program
    from cases.lib.run import launch
    folder, path = sys.argv[1:]
    class Run(launch.Run):
        def environment(self):
            return {**os.environ, "PATH": path + os.pathsep + os.environ["PATH"]}
    def work():
        print(Run(folder, 1, 1).go(), flush=True)
        return 0
    program.run(work, "x")
    """)


def start(tmp_path, mpirun):
    (tmp_path / "CFD").mkdir()
    program(tmp_path, "mpirun", mpirun)
    for name in ("liggghts-clay", "clayFoam"):
        program(tmp_path, name, "")
    return subprocess.Popen([sys.executable, "-c", GO, str(tmp_path), str(tmp_path / "bin")], cwd=TOP, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE)


# an mpirun whose rank lives on in a session of its own and heeds no SIGTERM
STUBBORN = """
    import os, signal, subprocess, sys, time
    p = subprocess.Popen([sys.executable, "-c", "import signal, time; signal.signal(signal.SIGTERM, signal.SIG_IGN); "
                          "print('up', flush=True); time.sleep(100)"], start_new_session=True, stdout=subprocess.PIPE)
    p.stdout.readline()
    with open("rank.part", "w") as f:
        f.write(str(p.pid))
    os.rename("rank.part", "rank")
    END
    """


def rank(tmp_path, seconds=30):
    end = time.monotonic() + seconds
    while not (tmp_path / "rank").exists() and time.monotonic() < end:
        time.sleep(0.02)
    return int((tmp_path / "rank").read_text())


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGUSR1])
def test_a_signal_ends_all_that_was_started(tmp_path, number):
    p = start(tmp_path, STUBBORN.replace("END", "time.sleep(100)"))
    pid = rank(tmp_path)
    p.send_signal(number)
    out, err = p.communicate(timeout=60)
    assert out == f"Outcome(code={128 + number}, reason='ended by {number.name} to cases/run')\n", err
    assert not os.path.isdir(f"/proc/{pid}")


def test_ranks_that_outlive_mpirun_are_ended(tmp_path):
    p = start(tmp_path, STUBBORN.replace("END", "os.kill(os.getpid(), signal.SIGKILL)"))
    pid = rank(tmp_path)
    out, err = p.communicate(timeout=60)
    assert out == "Outcome(code=1, reason='mpirun was ended by SIGKILL')\n", err
    assert not os.path.isdir(f"/proc/{pid}")


def test_the_last_line_of_a_half_is_the_reason(tmp_path):
    p = start(tmp_path, """
        import sys
        print("[1,0]<stderr>:liggghts-clay: ended by SIGTERM at 1 s of 2 s", flush=True)
        sys.exit(3)
        """)
    assert p.communicate(timeout=60)[0] == (
        "Outcome(code=1, reason=\"liggghts-clay: ended by SIGTERM at 1 s of 2 s (mpirun's exit code 3)\")\n")


def test_a_run_that_ends_well(tmp_path):
    assert start(tmp_path, "").communicate(timeout=60)[0] == "Outcome(code=0, reason='')\n"
