# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Signals that end a program before its time, as an exception."""

import contextlib
import ctypes
import os
import signal

ENDING = (signal.SIGHUP, signal.SIGINT, signal.SIGTERM, signal.SIGUSR1)
_PR_SET_PDEATHSIG = 1


class Stopped(BaseException):
    """A signal asked the program to end; `signal` is its number."""

    def __init__(self, number):
        super().__init__(signal.Signals(number).name)
        self.signal = number


def heed():
    """From now on each of these signals raises Stopped, once; further ones are
    passed over, so that what has to be put in order is. SIGINT does so also where
    a shell has a background job ignore it; SIGHUP does not where nohup has."""
    def stop(number, _frame):
        for other in ENDING:
            if signal.getsignal(other) is stop:
                signal.signal(other, lambda *_: None)
        raise Stopped(number)
    for number in ENDING:
        if not (number == signal.SIGHUP and signal.getsignal(number) == signal.SIG_IGN):
            signal.signal(number, stop)


@contextlib.contextmanager
def passed_over():
    """Signals wait until what must be whole is done."""
    old = signal.pthread_sigmask(signal.SIG_BLOCK, ENDING)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, old)


def die_with_parent(parent=None):
    """For preexec_fn: the child is sent SIGTERM when this process ends, however that is."""
    parent = os.getpid() if parent is None else parent

    def ask():
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGTERM)
        for number in ENDING:  # as they are where a program is started by itself
            if number != signal.SIGHUP:
                signal.signal(number, signal.SIG_DFL)
        signal.pthread_sigmask(signal.SIG_SETMASK, ())
        if os.getppid() != parent:
            os._exit(1)
    return ask
