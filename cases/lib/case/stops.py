# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Signals that end a program before its time, as an exception."""

import contextlib
import ctypes
import os
import signal
import threading

ENDING = (signal.SIGHUP, signal.SIGINT, signal.SIGTERM, signal.SIGUSR1)
_PR_SET_PDEATHSIG = 1
_REMINDED = 0.1  # [s]


class Stopped(BaseException):
    """A signal asked the program to end; `signal` is its number."""

    def __init__(self, number):
        super().__init__(signal.Signals(number).name)
        self.signal = number


def heed():
    """From now on each of these signals raises Stopped, once; further ones are
    passed over, so that what has to be put in order is. SIGINT does so also where
    a shell has a background job ignore it; SIGHUP does not where nohup has."""
    heard = threading.Event()

    def stop(number, _frame):
        heard.set()
        for other in ENDING:
            if signal.getsignal(other) is stop:
                signal.signal(other, lambda *_: None)
        raise Stopped(number)
    for number in ENDING:
        if not (number == signal.SIGHUP and signal.getsignal(number) == signal.SIG_IGN):
            signal.signal(number, stop)
    _remind(heard)


def _remind(heard):
    """Python acts on a signal between two of its own steps: one that comes just before it waits in the system would
    be acted on after that, however long it is. It is sent again until it is heard."""
    read, write = os.pipe()
    os.set_blocking(write, False)

    def again():
        number = os.read(read, 1)[0]
        while number not in ENDING:
            number = os.read(read, 1)[0]
        while not heard.wait(_REMINDED):
            signal.pthread_kill(threading.main_thread().ident, number)
    with passed_over():  # the thread is sent none of them
        threading.Thread(target=again, daemon=True).start()
    signal.set_wakeup_fd(write, warn_on_full_buffer=False)


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
        signal.set_wakeup_fd(-1)  # what the child is sent is not for this process
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGTERM)
        for number in ENDING:  # as they are where a program is started by itself
            if number != signal.SIGHUP:
                signal.signal(number, signal.SIG_DFL)
        signal.pthread_sigmask(signal.SIG_SETMASK, ())
        if os.getppid() != parent:
            os._exit(1)
    return ask
