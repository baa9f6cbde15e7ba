# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The store of runs, with a small script in the place of the coupled run."""

import contextlib
import os
import signal
import subprocess
import sys
import tempfile
import textwrap
import time
import unittest
from unittest import mock

import pytest

from cases.lib.case.casefile import TOP
from cases.lib.case.errors import CaseError
from cases.lib.run import runkey, runs

# argv: folder, file to note the start in, seconds, end
SCRIPT = textwrap.dedent("""
    import os, sys, time
    folder, notes, seconds, end = sys.argv[1:]
    os.makedirs(folder)
    with open(notes, "a") as f:
        f.write(f"start {os.getpid()}\\n")
    print("t = 1 s of 2 s, 50.0 %", flush=True)
    time.sleep(float(seconds))
    if end == "bad":
        print("cases/run: stopped after 1 s, exit code 3; logs in x")
        print("ERROR: the spring is too stiff")
        sys.exit(3)
    with open(os.path.join(folder, "settling.csv"), "w") as f:
        f.write("time_s,interface_m\\n0,0.15\\n1,0.1\\n")
    if end != "partly":
        with open(os.path.join(folder, "summary.json"), "w") as f:
            f.write('{"complete": %s, "reason": "it ended at 0.1 s of 2 s"}' % ("false" if end == "cut" else "true"))
    with open(notes, "a") as f:
        f.write(f"end {os.getpid()}\\n")
    """)


class RunsTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.top = folder.name
        self.notes = os.path.join(self.top, "notes")
        self.build = {"bin": "1"}
        patch = mock.patch.object(runkey, "programs", lambda: self.build)
        patch.start()
        self.addCleanup(patch.stop)
        self.said = []

    def store(self, seconds=0.0, end="good", **more):
        return runs.Store(os.path.join(self.top, "runs"), tell=self.said.append,
                          command=lambda name, changes, folder: [
                              sys.executable, "-c", SCRIPT, folder, self.notes, str(seconds), end], **more)

    def started(self, word="start"):
        if not os.path.isfile(self.notes):
            return 0
        with open(self.notes, encoding="utf-8") as f:
            return sum(line.startswith(word) for line in f)

    def test_a_run_is_made_once(self):
        folder = self.store().run("clump-half", {"charge": 3e-10})
        self.assertEqual(list(runs.curve(folder)["interface_m"]), [0.15, 0.1])
        self.assertEqual(self.store().run("clump-half", {"charge": "3.0e-10"}), folder)
        self.assertEqual(self.store().finished("clump-half", {"charge": 3e-10}), folder)
        self.assertEqual(self.started(), 1)
        many = self.store().run_many([("clump-half", {"charge": q}) for q in (3e-10, 2e-10, 2e-10)])
        self.assertEqual([r.reused for r in many], [True, False, False])
        self.assertEqual(many[1].folder, many[2].folder)
        self.assertEqual(self.started(), 2)

    def test_what_decides_the_result_is_in_the_key(self):
        first = self.store().run("clump-half", {})
        self.assertIsNone(self.store().finished("clump-half", {"seed": 2}))
        self.assertIsNone(self.store(ranks=(2, 1)).finished("clump-half", {}))
        self.build = {"bin": "2"}
        self.assertIsNone(self.store().finished("clump-half", {}))
        self.build = {"bin": "1"}
        whole = runkey.inputs
        with mock.patch.object(runkey, "inputs", lambda case: {**whole(case), "code": "other"}):
            self.assertIsNone(self.store().finished("clump-half", {}))
        self.assertEqual(self.store().finished("clump-half", {}), first)

    def test_input_files_are_in_the_key(self):
        from cases.lib.case.casefile import Case
        found = runkey.inputs(Case("clump-half"))["files"]
        for name in ("in.liggghts", "contacts.liggghts", "CFD/system/fvSolution"):
            self.assertIn(name, found)
        self.assertNotIn("case.json", found)

    def test_the_code_that_makes_a_run_is_in_the_key(self):
        found = {}
        runkey._modules("cases.lib.run.prepare", found)
        self.assertTrue({"cases.lib.run.prepare", "cases.lib.case.meshes", "cases.lib.packing.packing",
                         "cases.lib.packing.pack_shapes", "cases.lib.case.suspension"} <= set(found))
        # what these make is in the key by its values; runs are reported by others
        self.assertFalse({"cases.lib.case.casefile", "cases.lib.case.openfoam", "cases.lib.run.report"} & set(found))

    def test_a_failed_run_says_why_and_is_made_anew(self):
        with self.assertRaisesRegex(runs.RunFailed, "charge=3e-10 failed: ERROR: the spring is too stiff"):
            self.store(end="bad").run("clump-half", {"charge": 3e-10})
        results = self.store(end="partly").run_many([("clump-half", {"charge": 3e-10})])
        self.assertIn("without summary.json", results[0].error)
        self.assertEqual(self.store().run_many([("clump-half", {"charge": 3e-10})])[0].error, "")
        self.assertEqual(self.started(), 3)

    def test_a_run_that_was_cut_is_never_taken(self):
        result = self.store(end="cut").run_many([("clump-half", {})])[0]
        self.assertIn("failed: it ended at 0.1 s of 2 s", result.error)
        self.assertIsNone(self.store().finished("clump-half", {}))
        folder = self.store().run("clump-half", {})
        self.assertEqual(self.store().finished("clump-half", {}), folder)
        with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as f:
            f.write('{"complete": false}')
        self.assertIsNone(self.store().finished("clump-half", {}))
        self.assertEqual(self.started(), 2)

    def test_a_damaged_curve_is_made_anew(self):
        for damage in (lambda p: os.truncate(p, 30), lambda p: os.truncate(p, 0), os.remove):
            folder = self.store().run("clump-half", {})
            damage(os.path.join(folder, "settling.csv"))
            self.assertIsNone(self.store().finished("clump-half", {}))
        self.assertEqual(list(runs.curve(self.store().run("clump-half", {}))["interface_m"]), [0.15, 0.1])
        self.assertEqual(self.started(), 4)

    def test_a_damaged_note_is_made_anew(self):
        for note in ("", "{}", "[", '{"key": "other", "wall_s": 1}'):
            folder = self.store().run("clump-half", {})
            with open(os.path.join(folder, "run.json"), "w", encoding="utf-8") as f:
                f.write(note)
            self.assertIsNone(self.store().finished("clump-half", {}))
        self.store().run("clump-half", {})
        self.assertEqual(self.started(), 5)

    def test_programs_changed_while_it_ran(self):
        store = self.store()
        plain = store.command

        def change(*args):
            self.build = {"bin": "2"}
            return plain(*args)
        store.command = change
        self.assertIn("were changed while it ran", store.run_many([("clump-half", {})])[0].error)

    def test_what_decides_is_gone_after_the_run(self):
        store = self.store()
        plain = store.command

        def change(*args):
            self.build = None
            return plain(*args)
        store.command = change

        def programs():
            if self.build is None:
                raise CaseError("clayFoam is not there")
            return self.build
        with mock.patch.object(runkey, "programs", programs):
            self.assertIn("were changed while it ran", store.run_many([("clump-half", {})])[0].error)

    def test_stopping_ends_what_a_run_has_started(self):
        code = ("import subprocess, sys; c = subprocess.Popen(['sleep', '60']); "
                "open(sys.argv[1], 'w').write(f'{c.pid}\\n'); c.wait()")
        store = runs.Store(os.path.join(self.top, "runs"), tell=self.said.append,
                           command=lambda *_: [sys.executable, "-c", code, self.notes])
        os.makedirs(store.folder)
        job = store._job("clump-half", {})
        self.assertTrue(store._take(job))
        store._start(job, False)
        self.wait(lambda: os.path.isfile(self.notes) and open(self.notes, encoding="utf-8").read().endswith("\n"))
        with open(self.notes, encoding="utf-8") as f:
            child = int(f.read())
        self.wait(lambda: b"sleep" in self.words_of(child))
        store._stop(job)
        self.wait(lambda: b"sleep" not in self.words_of(child))

    def test_a_broken_curve(self):
        path = os.path.join(self.top, "settling.csv")
        for content in ("", "a,b\n1,2\n", "time_s,interface_m\n", "time_s,interface_m\n0,1\n1,2,3\n"):
            with open(path, "w", encoding="utf-8") as f:
                f.write(content)
            with self.assertRaisesRegex(CaseError, "settling.csv: "):
                runs.curve(self.top)

    @pytest.mark.long
    def test_at_most_so_many_at_once(self):
        with mock.patch.object(runs.launch, "cores", lambda: 4):
            self.assertEqual(runs.default_jobs(), 2)
            wanted = [("clump-half", {"seed": s}) for s in range(1, 7)]
            for jobs, most in ((None, 2), (9, 4), (1, 1)):
                going, peak = 0, 0
                with contextlib.suppress(FileNotFoundError):
                    os.remove(self.notes)
                runs.Store(os.path.join(self.top, str(jobs)), tell=self.said.append,
                           command=self.store(0.2).command).run_many(wanted, jobs)
                with open(self.notes, encoding="utf-8") as f:
                    for line in f:
                        going += 1 if line.startswith("start") else -1
                        peak = max(peak, going)
                self.assertLessEqual(peak, most)
                self.assertEqual((peak == 1), (jobs == 1))
        self.assertTrue(any(line.startswith("run 6 of 6: clump-half") for line in self.said))

    def test_a_killed_run_ends_and_is_made_anew(self):
        code = textwrap.dedent(f"""
            import sys

            from cases.lib.run import runkey, runs
            runkey.programs = lambda: {self.build!r}
            script, folder, notes = {SCRIPT!r}, {os.path.join(self.top, "runs")!r}, {self.notes!r}
            runs.Store(folder, command=lambda n, c, out: [sys.executable, "-c", script, out, notes, "30", "good"]
                       ).run("clump-half", {{}})
            """)
        for number, sign in enumerate((signal.SIGINT, signal.SIGTERM, signal.SIGKILL), 1):
            # a shell's background jobs ignore SIGINT, and so would what they start
            process = subprocess.Popen([sys.executable, "-c", code], cwd=TOP, stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL,
                                       preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
            self.wait(lambda: self.started() == number)
            process.send_signal(sign)
            process.wait(10)
            with open(self.notes, encoding="utf-8") as f:
                made = int(f.read().split()[-1])
            self.wait(lambda: not os.path.isdir(f"/proc/{made}") or b"\0" not in self.words_of(made))
        self.assertIsNone(self.store().finished("clump-half", {}))
        self.store().run("clump-half", {})
        self.assertEqual((self.started(), self.started("end")), (4, 1))

    def test_two_stores_make_a_run_once(self):
        code = textwrap.dedent(f"""
            import sys

            from cases.lib.run import runkey, runs
            runkey.programs = lambda: {self.build!r}
            script, folder, notes = {SCRIPT!r}, {os.path.join(self.top, "runs")!r}, {self.notes!r}
            runs.Store(folder, command=lambda n, c, out: [sys.executable, "-c", script, out, notes, "1", "good"]
                       ).run("clump-half", {{}})
            """)
        pair = [subprocess.Popen([sys.executable, "-c", code], cwd=TOP, stdout=subprocess.DEVNULL) for _ in range(2)]
        self.assertEqual([p.wait(20) for p in pair], [0, 0])
        self.assertEqual(self.started(), 1)

    def test_bad_input(self):
        for name, changes, words in (("clump-hal", {}, "did you mean 'clump-half'"),
                                     ("clump-half", {"charg": 1}, "did you mean 'charge'"),
                                     ("clump-half", {"charge": "much"}, "must be a number")):
            with self.assertRaisesRegex(CaseError, words):
                self.store().run(name, changes)
        self.assertEqual(self.started(), 0)

    @staticmethod
    def words_of(pid):
        try:
            with open(f"/proc/{pid}/cmdline", "rb") as f:
                return f.read()
        except OSError:
            return b""

    def wait(self, condition, seconds=10.0):
        end = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), end)
            time.sleep(0.02)


if __name__ == "__main__":
    unittest.main()
