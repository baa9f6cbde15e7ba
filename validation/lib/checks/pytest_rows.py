# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A plugin of pytest: writes what happens to each test as a line of JSON into the
pipe of --rows-to as it happens, and ends a test that takes too long.

Lines: {"listed": [id, ...]}, {"began": id}, {"ended": id, "reason": ""}, where
the reason says why the test has not passed."""

import json
import os
import signal

import pytest


class TooLong(Exception):
    """A test that went on for longer than --limit."""


def pytest_addoption(parser):
    parser.addoption("--rows-to", type=int, metavar="FD", help="file descriptor for a line of JSON a test")
    parser.addoption("--limit", type=float, default=300.0, metavar="S", help="seconds a test may take (300)")


def pytest_configure(config):
    if config.getoption("--rows-to") is not None:
        config.pluginmanager.register(Rows(config.getoption("--rows-to"), config.getoption("--limit")))


class Rows:
    """Tells of every test through a pipe."""

    def __init__(self, pipe, limit):
        self.pipe, self.limit, self.reasons = pipe, limit, {}

    def _tell(self, **what):
        os.write(self.pipe, (json.dumps(what) + "\n").encode())

    def pytest_collection_finish(self, session):
        self._tell(listed=[item.nodeid for item in session.items])

    def pytest_collectreport(self, report):
        if report.outcome != "passed":
            self._tell(ended=report.nodeid, reason=_reason(report))

    def pytest_runtest_logstart(self, nodeid):
        self._tell(began=nodeid)

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_protocol(self, item):
        def over(*_):
            raise TooLong(f"took longer than {self.limit:g} s")
        before = signal.signal(signal.SIGALRM, over)
        signal.setitimer(signal.ITIMER_REAL, self.limit)
        yield
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)

    def pytest_runtest_logreport(self, report):
        if report.outcome != "passed":
            self.reasons.setdefault(report.nodeid, _reason(report))

    def pytest_runtest_logfinish(self, nodeid):
        self._tell(ended=nodeid, reason=self.reasons.pop(nodeid, ""))


def _reason(report):
    """Why a part of a test has not passed, in a line."""
    if report.outcome == "skipped":
        return f"skipped: {report.longrepr[2]}" if isinstance(report.longrepr, tuple) else "skipped"
    crash = getattr(report.longrepr, "reprcrash", None)
    return " ".join((crash.message if crash else str(report.longrepr)).split()) or report.outcome
