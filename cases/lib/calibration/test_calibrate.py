# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Calibration with made-up curves in the place of runs: their charge, time
scale and end of consolidation are known."""

import contextlib
import csv
import io
import json
import os
import sys
import tempfile
import textwrap
import unittest
from unittest import mock

import numpy as np
import pytest

from cases.lib.calibration import caldata, calfit, calibrate, calloop, stages_main
from cases.lib.case import program
from cases.lib.case.casefile import TOP
from cases.lib.case.errors import CaseError
from cases.lib.run import runkey, runs

DAY = 86400.0
CHARGES = [2e-10, 3.3e-10, 4.7e-10]


def curve(q, seed, end=1.5, spread=1.0, creep=0.02):
    """A fall to a height that hangs on the charge; seed 0 has no deviation of
    its own in speed, height, creep, and a slow wave."""
    rng = np.random.default_rng(seed)
    a, b, c = spread * rng.standard_normal(3) if seed else (0.0, 0.0, 0.0)
    t = np.linspace(0, end, 301)
    high = 0.16 + 0.17 * (q / 4e-10)**1.5 + 0.005 * a - creep * (t - 0.5) * (1 + 0.3 * c)
    fast = 1 - 1.45 * (1 - 0.05 * q / 4e-10) * (1 + 0.01 * b) * t
    y = high + 0.01 * np.logaddexp(0, (fast - high) / 0.01)
    return t, y + 0.002 * a * np.sin(9 * t + 3 * b)


def data_of(q, s, seed, noise=0.003, end=1.5, **more):
    """A made-up measurement of 80 rows; s seconds of the laboratory to one."""
    t, y = curve(q, seed, 1.5, **more)
    tau = np.linspace(0, end, 80)
    z = np.interp(tau, t, y) + noise * np.random.default_rng(seed).standard_normal(80)
    return caldata.of("made-up", tau * s / DAY, 0.3 * z, 0.3)


def search(data, first=0, charges=CHARGES, tell=lambda line: None, **more):
    return calloop.search(data, lambda pairs: [curve(q, 1000 * first + k, **more) for q, k in pairs], charges,
                          tell=tell)


class DataTest(unittest.TestCase):

    def read(self, content, **more):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "curve.csv")
            with open(path, "w", encoding="utf-8") as f:
                f.write(content)
            return caldata.read(path, **more)

    def test_reading(self):
        rows = "\n".join(f"{d}, {0.3 - 0.01 * min(d, 12) - 0.0005 * d}" for d in range(40))
        for head in ("", "# a comment\ndays,height\n\n", "\ufeffday, height [m]\n"):
            data = self.read(head + rows + " # the last\n")
            self.assertEqual((len(data.days), data.height0, len(data.slopes)), (40, 0.3, 2))
            self.assertAlmostEqual(data.breaks[0], 12, delta=0.2)
        self.assertEqual(self.read(rows, height0=0.6).y[0], 0.5)

    def test_bad_rows_by_line(self):
        good = [f"{d},{0.3 - 0.01 * d}" for d in range(15)]
        for row, words in (("1;2", "line 4: '1;2': must be days and height"),
                           ("a,0.2", "line 4: 'a,0.2': must be two numbers"),
                           ("2,nan", "line 4.*must be finite"), ("-3,0.2", "line 4: day -3: must be 0 or more"),
                           ("2.5,0", "line 4: height 0: must be above 0"),
                           ("1,0.2", "line 4: day 1 does not come after day 2"),
                           ("3,0.2,1", "line 4: '3,0.2,1': must be days and height")):
            with self.assertRaisesRegex(CaseError, words):
                self.read("\n".join([*good[:3], row, *good[3:]]))
        with self.assertRaisesRegex(CaseError, "11 rows; must be at least 12"):
            self.read("\n".join(good[:11]))
        with self.assertRaisesRegex(CaseError, "does not fall in its first stage"):
            self.read("\n".join(f"{d},{0.1 + 0.01 * d}" for d in range(15)))
        with self.assertRaisesRegex(CaseError, "line 1: '0,x': must be two numbers"):
            self.read("\n".join(["0,x", *good]))
        with self.assertRaisesRegex(CaseError, "--height0 0"):
            self.read("\n".join(good), height0=0.0)

    def test_noise(self):
        for noise in (0.001, 0.005):
            found = np.mean([data_of(3e-10, 8e5, seed, noise).noise for seed in range(1, 20)])
            self.assertAlmostEqual(found / noise, 1, delta=0.2)


class FitTest(unittest.TestCase):

    def test_emulator_is_a_parabola(self):
        t = np.linspace(0, 2, 50)
        e = calfit.Emulator([1, 2, 3, 4], [(t, q**2 - t * q) for q in (1, 2, 3, 4)])
        np.testing.assert_allclose(e.mean(2.5), 6.25 - 2.5 * e.t, atol=1e-9)
        self.assertEqual(e.dof, 1)
        np.testing.assert_allclose(e.left, 0, atol=1e-9)
        np.testing.assert_allclose(e.at(e.mean(2), np.array([1.0, 3.0])), [2, -2], atol=1e-6)
        # the standard error of a new value: sigma^2 (1 + leverage)
        rng, inside = np.random.default_rng(1), 0
        e = calfit.Emulator(np.linspace(1, 4, 9), [(t, 0 * t)] * 9)
        for _ in range(400):
            middle, error = e.scalar(rng.standard_normal(9), 2.5)
            inside += abs(rng.standard_normal() - middle) < 2.447 * error  # t of 6 at 95 %
        self.assertAlmostEqual(inside / 400, 0.95, delta=0.035)

    def test_falling(self):
        np.testing.assert_allclose(calloop.falling([3, 1, 2, 0, 1, 0]), [3, 1.5, 1.5, 0.5, 0.5, 0])

    def test_rest(self):
        t = np.linspace(0, 10, 1001)
        moment, still = calloop.rest(t, np.exp(-2 * t))
        self.assertTrue(still)
        self.assertAlmostEqual(moment, np.log(100) / 2, delta=0.02)
        self.assertFalse(calloop.rest(t, 1 - 0.09 * t)[1])
        self.assertFalse(calloop.rest(t, np.maximum(1 - t, 0.3 - 0.01 * t))[1])


class SearchTest(unittest.TestCase):

    def test_exact_curves(self):
        made = calloop.search(data_of(2.5e-10, 7e5, 0, 1e-5), lambda p: [curve(q, 0) for q, _ in p], CHARGES,
                              tell=lambda line: None)
        self.assertAlmostEqual(made.fit.q / 2.5e-10, 1, delta=0.01)
        self.assertAlmostEqual(made.fit.s / 7e5, 1, delta=0.01)

    @pytest.mark.long
    def test_truth_lies_in_the_intervals(self):
        rng, inside, count = np.random.default_rng(7), np.zeros(3), 14
        for k in range(1, count + 1):
            q, s = rng.uniform(2e-10, 4e-10), 8e5 * rng.uniform(0.5, 2)
            made = search(data_of(q, s, 50 + k, creep=0.0), k, creep=0.0)
            f = made.fit
            self.assertTrue(f.determined)
            self.assertLess(f.q_interval[1] - f.q_interval[0], 0.5 * f.q)
            self.assertLess(f.s_interval[1] - f.s_interval[0], 0.2 * f.s)
            self.assertLessEqual(len(made.charges), 10)
            last = calloop.end_of_consolidation(made)
            truth = s / DAY * calloop.rest(*curve(q, 50 + k, creep=0.0))[0]
            inside += [f.q_interval[0] <= q <= f.q_interval[1], f.s_interval[0] <= s <= f.s_interval[1],
                       last["reached"] and last["low"] <= truth <= last["high"]]
        # of 14 intervals at 95 %: 10 or fewer has a chance below 0.005
        self.assertTrue(np.all(inside > 10), msg=f"{inside}")

    def test_one_stage_does_not_tell_the_charge(self):
        data = data_of(3e-10, 8e5, 77, end=0.4)
        self.assertEqual(len(data.slopes), 1)
        f = search(data).fit
        self.assertFalse(f.determined)
        self.assertTrue(f.q_edges[0] and f.q_edges[1])
        self.assertTrue(f.s_interval[0] <= 8e5 <= f.s_interval[1])
        self.assertLess(f.s_interval[1] / f.s_interval[0], 1.3)

    def test_a_scale_that_only_the_charges_tried_bound(self):
        # one stage, whose rate goes with 1/(1 + q/q1): any charge fits, each with its scale
        def degenerate(q, seed):
            rng = np.random.default_rng(seed)
            t = np.linspace(0, 1.5, 301)
            return t, 1 - 0.3 * (1 + 0.005 * rng.standard_normal()) / (1 + q / 3e-10) * t
        tau = np.linspace(0, 1.5, 80)
        y = np.interp(tau, *degenerate(3e-10, 5)) + 1e-3 * np.random.default_rng(5).standard_normal(80)
        data = caldata.of("made-up", tau * 8e5 / DAY, 0.15 * y, 0.15)
        made = calloop.search(data, lambda pairs: [degenerate(q, 10 + k) for q, k in pairs], CHARGES,
                              tell=lambda line: None)
        self.assertTrue(made.fit.known and not made.fit.determined)
        self.assertFalse(calloop.scale_determined(made))
        said = calibrate.report("x", data, {}, made, [""] * len(made.charges))
        self.assertFalse(said["time_scale"]["determined"])
        self.assertIn("not determined", said["time_scale"]["says"])
        # a rate that does not hang on the charge: the scale is known without it
        flat = calloop.search(data, lambda pairs: [degenerate(3e-10, 10 + k) for _, k in pairs], CHARGES,
                              tell=lambda line: None)
        self.assertFalse(flat.fit.determined)
        self.assertTrue(calloop.scale_determined(flat))

    def test_charges_are_added_beyond_those_tried(self):
        for q, charges in ((4.2e-10, [1.5e-10, 2.2e-10, 3e-10]), (1.6e-10, [2.5e-10, 3.2e-10, 4e-10])):
            made = search(data_of(q, 8e5, 90), charges=charges)
            self.assertTrue(min(made.charges) < q < max(made.charges))
            self.assertTrue(made.fit.determined)
            self.assertTrue(made.fit.q_interval[0] <= q <= made.fit.q_interval[1])

    def test_not_at_rest_gives_a_bound_only(self):
        made = search(data_of(3e-10, 8e5, 91, creep=0.05), creep=0.05)
        last = calloop.end_of_consolidation(made)
        self.assertEqual((last["reached"], last["days"]), (False, None))
        self.assertAlmostEqual(last["low"], 1.5 * made.fit.s_interval[0] / DAY)

    def test_nothing_is_predicted_from_a_bad_fit_or_from_an_edge(self):
        good = data_of(3e-10, 8e5, 91)
        tau = good.days * DAY / 8e5
        # a second stage that no charge gives
        bent = caldata.of("bent", good.days, good.height - 0.05 * np.clip(tau - 0.7, 0, 0.5), 0.3)
        above = data_of(4.5e-10, 8e5, 92)
        far = calloop.search(above, lambda p: [curve(q, k) for q, k in p], [1.5e-10, 1.8e-10, 2.1e-10], most=3,
                             tell=lambda line: None)
        for data, made, words in ((bent, search(bent), "times as far off as noise"),
                                  (above, far, "C, is the highest tried")):
            self.assertIn(words, calloop.unpredictable(made))
            r = calibrate.report("x", data, {}, made, [""] * len(made.charges))
            last = r["end_of_consolidation"]
            self.assertEqual((last["days"], last["low"], last["high"]), (None, None, None))
            self.assertIn("not predicted", calibrate.table(r))
            self.assertTrue(any(n.endswith("nothing is predicted") for n in r["notes"]))
            with tempfile.TemporaryDirectory() as out:
                calibrate.write(out, r, data, made)
                with open(os.path.join(out, "calibration.csv"), encoding="utf-8") as f:
                    days = [float(row["days"]) for row in csv.DictReader(f)]
            self.assertAlmostEqual(max(days), data.days[-1])
        self.assertEqual(calloop.unpredictable(search(good)), "")

    def test_stages_are_counted_as_cases_stages_does(self):
        for q, end in ((3e-10, 1.5), (3e-10, 0.4), (4e-10, 1.0)):
            data = data_of(q, 8e5, 77, end=end)
            args = stages_main.parser().parse_args(["x", "--samples", "20"])
            fit, stages = stages_main.find(data.days, data.height, args)
            said = stages_main.table(fit, stages, ["days", "height_m"], None)
            self.assertIn(f"settling stages: {len(data.slopes)}", said)
            self.assertNotIn("fewer than three", said)

    def test_three_runs_are_too_few_for_intervals(self):
        made = calloop.search(data_of(3e-10, 8e5, 92), lambda p: [curve(q, k) for q, k in p], CHARGES,
                              most=3, tell=lambda line: None)
        self.assertFalse(made.fit.known or made.fit.determined)
        self.assertIn("3 runs are the most", made.why)

    def test_every_run_has_a_packing_of_its_own(self):
        made = search(data_of(3e-10, 8e5, 93))
        self.assertEqual(made.seeds, list(range(1, len(made.charges) + 1)))
        again = search(data_of(3e-10, 8e5, 93))
        self.assertEqual((made.charges, made.fit.q_interval), (again.charges, again.fit.q_interval))


# argv: folder, charge, seed
SCRIPT = textwrap.dedent("""
    import os, sys
    from cases.lib.calibration.test_calibrate import curve
    folder, q, seed = sys.argv[1], float(sys.argv[2]), int(sys.argv[3])
    os.makedirs(folder)
    with open(os.path.join(folder, "settling.csv"), "w") as f:
        f.write("time_s,interface_m\\n")
        f.writelines(f"{t},{0.15 * y}\\n" for t, y in zip(*curve(q, seed, creep=0.0)))
    with open(os.path.join(folder, "summary.json"), "w") as f:
        f.write('{"complete": true}')
    """)


class ProgramTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.top, self.made, store = folder.name, [], runs.Store

        def stand_in(*_, **more):
            def command(name, changes, out):
                self.made.append(changes)
                return [sys.executable, "-B", "-c", SCRIPT, out, str(changes["charge"]), str(changes["seed"])]
            return store(os.path.join(self.top, "runs"), tell=lambda line: None, command=command, **more)
        for patch in (mock.patch.object(runkey, "programs", lambda: {}), mock.patch.object(runs, "Store", stand_in),
                      mock.patch.dict(os.environ, PYTHONPATH=TOP)):
            patch.start()
            self.addCleanup(patch.stop)

    def calibrate(self, *words):
        said, errors = io.StringIO(), io.StringIO()
        with mock.patch.object(sys, "argv", ["calibrate", "clump-half", *words]), \
                contextlib.redirect_stdout(said), contextlib.redirect_stderr(errors):
            status = program.guarded(calibrate.main, "cases/calibrate")
        return status, said.getvalue(), errors.getvalue()

    @pytest.mark.long
    def test_made_up_truth_is_recovered(self):
        data, out = os.path.join(self.top, "made.csv"), os.path.join(self.top, "out")
        status, *_ = self.calibrate("--make-data", data, "--true", "charge=2.7e-10", "time_scale=7e5",
                                    "--seed", "301", "--end", "1.5")
        self.assertEqual((status, len(self.made)), (0, 1))
        words = ("--data", data, "--height0", "0.15", "--charges", "2e-10,3.3e-10,4.7e-10", "--end", "1.5",
                 "--out", out)
        status, said, errors = self.calibrate(*words)
        self.assertEqual(status, 0, msg=errors)
        self.assertIn("well determined", said)
        with open(os.path.join(out, "calibration.json"), encoding="utf-8") as f:
            found = json.load(f)
        for key, truth in (("charge", 2.7e-10), ("time_scale", 7e5)):
            self.assertTrue(found[key]["determined"])
            self.assertTrue(found[key]["low"] <= truth <= found[key]["high"], msg=f"{found[key]}")
            self.assertLess(found[key]["high"] - found[key]["low"], 0.3 * truth)
        self.assertTrue(found["end_of_consolidation"]["reached"])
        self.assertEqual(len(found["runs"]), len(self.made) - 1)
        with open(os.path.join(out, "calibration.csv"), encoding="utf-8", newline="") as f:
            rows = list(csv.DictReader(f))
        measured = [r for r in rows if r["measured"]]
        self.assertEqual(len(measured), 80)
        inside = [float(r["low"]) <= float(r["measured"]) <= float(r["high"]) for r in measured]
        self.assertGreater(np.mean(inside), 0.85)
        with open(os.path.join(out, "calibration.png"), "rb") as f:
            self.assertEqual(f.read(4), b"\x89PNG")
        before = len(self.made)  # all runs are there now
        self.assertEqual(self.calibrate(*words)[1], said)
        self.assertEqual(len(self.made), before)

    def test_bad_input(self):
        data = os.path.join(self.top, "none.csv")
        for words, said in ((("--data", data), "none.csv: No such file"),
                            (("--data", data, "--set", "charge=1e-10"), "chooses the charge itself"),
                            (("--data", data, "--set", "frictio=1"), "did you mean 'friction'"),
                            (("--data", data, "--jobs", "0"), "--jobs 0"),
                            (("--make-data", data, "--true", "friction=1"), "--true friction=1"),
                            (("--make-data", data, "--rows", "5"), "--rows 5")):
            status, _, errors = self.calibrate(*words)
            self.assertEqual(status, 2)
            self.assertIn(said, errors)
            self.assertEqual(errors.count("\n"), 1)
        with open(data, "w", encoding="utf-8") as f:
            f.writelines(f"{d},{0.3 - 0.01 * min(d, 9)}\n" for d in range(20))
        for charges, said in (("1e-10,2e-10", "three different"), ("a,b,c", "numbers with commas")):
            self.assertIn(said, self.calibrate("--data", data, "--charges", charges)[2])
        for words, said in ((("--noise", "nan"), "--noise nan"), ((), "was not made by this program")):
            self.assertIn(said, self.calibrate("--make-data", data, *words)[2])
        self.assertIn("is a file", self.calibrate("--data", data, "--out", data)[2])
        self.assertEqual(self.made, [])


if __name__ == "__main__":
    unittest.main()
