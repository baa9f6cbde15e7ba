# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A plugin of pytest: writes what happens to each test as a line of JSON into the
pipe of --rows-to as it happens, and ends a test that takes too long. Several of
pytest that have the same empty folder as --share run each test once among them.

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
    parser.addoption("--share", metavar="FOLDER", help="runs only the tests that no other with this folder has taken")


def pytest_configure(config):
    if config.getoption("--rows-to") is not None:
        config.pluginmanager.register(Rows(config.getoption("--rows-to"), config.getoption("--limit")))
    if config.getoption("--share"):
        config.pluginmanager.register(Shared(config.getoption("--share")))


class Shared:
    """Runs the tests that it is the first to take, one after the other."""

    def __init__(self, folder):
        self.folder = folder

    def _taken(self, number):
        """Takes a test; False when another one has it already."""
        try:
            os.close(os.open(os.path.join(self.folder, str(number)), os.O_CREAT | os.O_EXCL))
        except FileExistsError:
            return False
        return True

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session):
        if session.testsfailed or session.config.option.collectonly:
            return None  # pytest itself says what is wrong
        mine = (item for number, item in enumerate(session.items) if self._taken(number))
        item = next(mine, None)
        while item:
            # what both need, such as a module's fixtures, is kept for the next
            following = next(mine, None)
            item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
            item = following
        return True


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
