# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Signals end a program with its own code and a line, and nothing it started is left."""

import os
import signal
import subprocess
import sys
import textwrap
import time

import pytest

from cases.lib.case.casefile import TOP

WAITS = textwrap.dedent("""
    import time
    from cases.lib.case import program
    def work():
        try:
            print("ready", flush=True)
            time.sleep(30)
        finally:
            time.sleep(0.3)
            print("in order", flush=True)
    program.run(work, "cases/x")
    """)

LIMIT = 10 * max(1.0, os.getloadavg()[0] / (os.cpu_count() or 1))  # [s]


def start(code, **more):
    return subprocess.Popen([sys.executable, "-c", code], cwd=TOP, text=True, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, **more)


@pytest.mark.parametrize(("ignored", "number"),
                         [(False, s) for s in (signal.SIGHUP, signal.SIGINT, signal.SIGTERM, signal.SIGUSR1)]
                         + [(True, s) for s in (signal.SIGINT, signal.SIGTERM, signal.SIGUSR1)])
def test_a_signal_ends_it_in_order(number, ignored):
    how = signal.SIG_IGN if ignored else signal.SIG_DFL
    p = start(WAITS, preexec_fn=lambda: signal.signal(number, how))
    assert p.stdout.readline() == "ready\n"
    p.send_signal(number)
    p.send_signal(number)  # what has to be put in order is
    out, err = p.communicate(timeout=LIMIT)
    assert (p.returncode, out) == (128 + number, "in order\n")
    assert err == f"cases/x: ended by {number.name}; what was finished is kept\n"


def test_a_signal_is_not_lost_ahead_of_a_wait():
    code = textwrap.dedent("""
        import ctypes
        from cases.lib.case import program
        def work():
            print("ready", flush=True)
            list(map(ctypes.CDLL(None).sleep, [60, 60]))  # two waits without a step of Python's between them
        program.run(work, "cases/x")
        """)
    p = start(code)
    assert p.stdout.readline() == "ready\n"
    time.sleep(0.3)
    p.send_signal(signal.SIGTERM)
    try:
        assert p.wait(LIMIT) == 128 + signal.SIGTERM
    finally:
        p.kill()
        p.communicate()


def test_nohup_is_heeded():
    p = start(WAITS, preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    assert p.stdout.readline() == "ready\n"
    p.send_signal(signal.SIGHUP)
    with pytest.raises(subprocess.TimeoutExpired):
        p.wait(0.5)
    p.kill()
    p.communicate()


def test_children_die_with_it():
    code = textwrap.dedent("""
        import subprocess, time
        from cases.lib.case import stops
        p = subprocess.Popen(["sleep", "60"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                             preexec_fn=stops.die_with_parent())
        print(p.pid, flush=True)
        time.sleep(60)
        """)
    p = start(code)
    child = int(p.stdout.readline())
    p.kill()
    p.communicate()
    end = time.monotonic() + LIMIT
    while os.path.isdir(f"/proc/{child}") and time.monotonic() < end:
        time.sleep(0.02)
    assert not os.path.isdir(f"/proc/{child}")


@pytest.mark.parametrize("stream", [1, 2])
def test_a_closed_stream_is_no_traceback(stream):
    code = textwrap.dedent("""
        from cases.lib.case import program
        from cases.lib.case.errors import CaseError
        def work():
            print("a" * 100)
            raise CaseError("bad")
        program.run(work, "cases/x")
        """)
    p = subprocess.run([sys.executable, "-c", code], cwd=TOP, capture_output=True, text=True, check=False,
                       preexec_fn=lambda: os.close(stream))
    assert p.returncode == 2
    assert "Traceback" not in p.stderr and "Exception" not in p.stderr


def test_nobody_listens():
    code = textwrap.dedent("""
        from cases.lib.case import program
        def work():
            print("a" * 100)
            return 0
        program.run(work, "cases/x")
        """)
    for target in ("/dev/full", None):
        if target:
            with open(target, "w", encoding="utf-8") as out:
                p = subprocess.run([sys.executable, "-c", code], cwd=TOP, stdout=out, stderr=subprocess.PIPE, text=True,
                                   check=False)
        else:
            read, write = os.pipe()
            os.close(read)
            p = subprocess.run([sys.executable, "-c", code], cwd=TOP, stdout=write, stderr=subprocess.PIPE, text=True,
                               check=False)
            os.close(write)
        assert p.returncode != 0
        assert p.stderr in (("cases/x: standard output: No space left on device\n",
                             "cases/x: No space left on device\n") if target else ("",))
        assert "Traceback" not in p.stderr and "Exception" not in p.stderr


@pytest.mark.parametrize("raised, says", [
    ("OSError(28, 'No space left on device', '/place')", "cases/x: /place: No space left on device\n"),
    ("RecursionError()", "cases/x: an input is nested too deep\n"),
    ("MemoryError()", "cases/x: the memory does not suffice; take fewer particles or cells\n")])
def test_errors_of_the_machine_are_one_line(raised, says):
    code = f"from cases.lib.case import program\ndef work():\n    raise {raised}\nprogram.run(work, 'cases/x')\n"
    p = subprocess.run([sys.executable, "-c", code], cwd=TOP, capture_output=True, text=True, check=False)
    assert (p.returncode, p.stderr) == (2, says)
