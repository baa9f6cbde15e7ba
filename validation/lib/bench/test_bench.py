# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of validation/bench: errors, front, ratios, plan, targets' arithmetic."""

import json
import os
import tempfile
import unittest
from unittest import mock

import numpy as np

from cases.lib.case import casefile
from validation.lib.bench import bench_curve, bench_main, bench_plan, bench_run, bench_skips, bench_targets
from validation.lib.checks.verdicts import Broken


def line(slope, offset=0.0, end=2.0, n=21):
    t = np.linspace(0, end, n)
    return {"time_s": t, "interface_m": 1 - slope * t + offset, "mean_height_m": 0.5 - slope * t}


class Curves(unittest.TestCase):
    def test_difference(self):
        self.assertEqual(bench_curve.difference(line(0.1), line(0.1)), 0)
        # all is lower by 0.01 where 0.2 were sunk
        self.assertAlmostEqual(bench_curve.difference(line(0.1, -0.01), line(0.1)), 0.05)
        # other times, and a reference that goes on: only what both have
        self.assertAlmostEqual(bench_curve.difference(line(0.1, -0.01, 1.0, 7), line(0.1)), 0.05)
        with self.assertRaisesRegex(ValueError, "has not sunk at all"):
            bench_curve.difference(line(0.1), line(0.0))

    def test_spread_is_the_standard_deviation(self):
        found = bench_curve.spread([line(0.11), line(0.09)])
        share = np.linspace(0, 1, 21)
        self.assertAlmostEqual(found, np.std([0.22, 0.18], ddof=1) * np.sqrt(np.mean(share**2)) / 0.2)
        # where a packing begins is no difference
        self.assertAlmostEqual(bench_curve.spread([line(0.1, 0.01), line(0.1, -0.01)]), 0)
        with self.assertRaisesRegex(ValueError, "two curves"):
            bench_curve.spread([line(0.1)])

    def test_front(self):
        points = [(1.0, 0.01), (0.5, 0.02), (2.0, 0.005), (1.5, 0.02), (0.5, 0.03)]
        self.assertEqual(bench_curve.front(points), [True, True, True, False, False])
        self.assertEqual(bench_curve.front([(1, 1), (1, 1)]), [True, True])
        # below the floor errors are all alike, and the fastest wins
        self.assertEqual(bench_curve.front(points, 0.01), [True, True, False, False, False])
        self.assertEqual(bench_curve.front(points, 1), [False, True, False, False, True])

    def test_ratios(self):
        self.assertEqual(bench_curve.ratios([2.0, 3.0], [1.0, 3.0, 3.0]), [1.0, 1.0])
        with self.assertRaises(ValueError):
            bench_curve.ratios([1.0], [1.0])


class Plan(unittest.TestCase):
    def test_every_point_is_a_case(self):
        for name in bench_plan.CASES:
            values = casefile.Case(name).values
            seen = set()
            for setting, _, changes in bench_plan.settings(values):
                case = casefile.Case(name)
                bench_run_settings(case, changes)
                seen.add(setting)
                if setting in ("dem_step", "stiffness"):  # the coupling interval stays
                    self.assertAlmostEqual(case.values["dem_step"] * case.values["coupling_steps"],
                                           values["dem_step"] * values["coupling_steps"], delta=0.21e-4)
            self.assertLessEqual({"dem_step", "stiffness", "coupling_steps", "overlap", "void_fraction", "mesh",
                                  "tolerance", "accuracy", "rest", "answer_lag", "quiet_fluid"}, seen)
            exact = bench_plan.reference(values)
            bench_run_settings(casefile.Case(name), exact)
            self.assertEqual((exact["rest"], exact["answer_lag"], exact["quiet_fluid"]), ("no", "0", 0))
            self.assertEqual("cutoff" in seen and "coulomb_steps" in seen, name == "clump-half")
            quick = bench_plan.settings(values, quick=True)
            self.assertLess(len(quick), 17)

    def test_stiffer_keeps_the_interval_and_resolves_the_contact(self):
        made = bench_plan.stiffer({"stiffness": 100, "dem_step": 1e-5, "coupling_steps": 20}, 25)
        self.assertEqual(made, {"stiffness": 2500, "dem_step": 2e-6, "coupling_steps": 100})

    def test_window_is_whole_intervals(self):
        self.assertAlmostEqual(bench_main.fitted(0.1, {"dem_step": 3e-5, "coupling_steps": 10}, {}), 0.0999)
        self.assertAlmostEqual(bench_main.fitted(1e-9, {"dem_step": 3e-5, "coupling_steps": 10}, {}), 3e-4)


def bench_run_settings(case, changes):
    from cases.lib.case import settings
    settings.apply(case, changes)


class Targets(unittest.TestCase):
    def test_steps(self):
        rows = [(0, 0.0), (500, 5.0), (900, 8.0), (1000, 8.2)]
        self.assertAlmostEqual(bench_targets.last_step(rows), 0.002)
        self.assertAlmostEqual(bench_targets.mean_step(rows), 0.0082)

    def test_stock_script(self):
        path = os.path.join(casefile.CASES, "clump-half", "in.liggghts")
        with open(path, encoding="utf-8") as f:
            text = bench_targets.stock_clumps(f.read())
        for ours in ("gran/lean", "coul/clump", "multisphere/clump"):
            self.assertNotIn(ours, text)
        for stock in ("pair_style gran model hooke/stiffness tangential history lean no\n", "pair_coeff * *\n",
                      "fix bodies all multisphere\n"):
            self.assertIn(stock, text)

    def test_other_laws_of_contact(self):
        with open(os.path.join(casefile.CASES, "column1890", "in.liggghts"), encoding="utf-8") as f:
            text = f.read()
        for stock, word in ((True, "lean no"), (False, "lean yes")):
            changed = bench_targets.contacts_by(text, "hertz tangential history", stock)
            self.assertIn('variable wall_law string "hertz tangential history"', changed)
            self.assertIn("pair_style gran model hertz tangential history " + word + "\n", changed)
        with self.assertRaises(Broken):
            bench_targets.contacts_by("run 1", "hertz", True)

    def test_what_is_missing_is_not_met(self):
        def fast(_):
            return 0.2, "so"

        def gone(_):
            raise bench_targets.Missing("no such case")

        def inaccurate(_):
            return 0.2, "error 3 %", False

        with mock.patch.object(bench_targets, "TARGETS", (("a", 0.3, fast), ("b", 1.0, gone), ("c", 1.0, inaccurate),
                                                          ("d", 0.1, fast))):
            rows = bench_targets.measure(True, False, lambda _: None)
        self.assertEqual([r["passed"] for r in rows], [True, False, False, False])
        self.assertEqual(rows[1]["measured"], None)
        self.assertEqual(rows[1]["note"], "not measured: no such case")
        self.assertIn("MISSED b", bench_targets.table(rows))


class Skips(unittest.TestCase):
    def test_every_variant_is_a_case(self):
        for quick in (True, False):
            rows = bench_skips.plan(quick)
            for v in [v for r in rows for v in (r.work, r.skip)]:
                bench_run_settings(casefile.Case(v.case), v.changes)
            for word in ("charges", "bodies", "torque", "fields on the wire", "empty cells", "smoothing",
                         "void-fraction updates", "quiescent fluid", "resting bed", "far Coulomb pairs"):
                self.assertIn(word, [r.feature for r in rows])
            # a pair differs in something
            self.assertFalse([r.feature for r in rows if r.work.key() == r.skip.key()])

    def test_edits_change_the_scripts(self):
        for case, edit in (("clump-half", "without charges"), ("sphere-half", "with bodies")):
            with open(os.path.join(casefile.CASES, case, "in.liggghts"), encoding="utf-8") as f:
                text = f.read()
            changed = bench_skips.EDITS[edit](text)
            self.assertNotEqual(text, changed)
            self.assertEqual("coul/clump" in changed, False)
            self.assertEqual(edit == "with bodies", "fix bodies" in changed and case == "sphere-half")

    def test_gain_is_the_median_of_pairs(self):
        times = iter([4.0, 1.0, 9.0, 3.0, 10.0, 2.0])  # in turn
        with tempfile.TemporaryDirectory() as top:
            def run(variant):
                place = os.path.join(top, str(variant.changes["x"]))
                for half, text in (("DEM/dem.json", f'{{"dem_cpu_s": {next(times)}}}'), ("CFD/cfd.json", "{}")):
                    os.makedirs(os.path.join(place, os.path.dirname(half)), exist_ok=True)
                    with open(os.path.join(place, half), "w", encoding="utf-8") as f:
                        f.write(text)
                with open(os.path.join(place, "settling.csv"), "w", encoding="utf-8") as f:
                    f.write(f"time_s,interface_m\n0,1\n1,{0.9 - 0.01 * variant.changes['x']}\n")
                return place

            work, skip = (bench_skips.Variant("sphere-half", {"x": x}) for x in (0, 1))
            row = bench_skips.Row("f", "s", "c", ("dem.dem_cpu_s",), work, skip, lambda a, b: "so")
            found = bench_skips.Pairs([row], 3, lambda _: None, run).go()[0]
            self.assertEqual((found["work_s"], found["skipped_s"], found["gain"]), (9, 2, 4))
            self.assertAlmostEqual(found["error"], np.sqrt(0.5) * 0.1)
            self.assertEqual(bench_skips.error(os.path.join(top, "0"), os.path.join(top, "0")), 0)
            self.assertIn("so", bench_skips.table([found]))

    def test_a_run_that_fails_leaves_a_row(self):
        def gone(_):
            raise bench_skips.Broken("no such style")

        row = bench_skips.plan(True)[0]
        found = bench_skips.Pairs([row], 1, lambda _: None, gone).go()[0]
        self.assertEqual((found["gain"], found["note"]), (None, "not measured: no such style"))
        self.assertIn("no such style", bench_skips.table([found]))


class History(unittest.TestCase):
    def test_a_change_is_seen(self):
        row = {"case": "x", "setting": "baseline", "value": "as shipped", "wall_s": 2.0, "error": 0.01}
        with tempfile.TemporaryDirectory() as top, mock.patch.object(bench_run, "PLACE", top), \
                mock.patch.object(bench_main.runkey, "programs", lambda: {"a": 1}):
            self.assertIn("nothing was kept", bench_main.history("settings", False, [row], 1.0))
            # another load of the machine alone is no change
            same = bench_main.history("settings", False, [{**row, "wall_s": 4.0}], 2.0)
            self.assertIn("2, was 2 (+0 %)", same)
            self.assertIn("the same programs", same)
            self.assertIn("1, was 2 (-50 %)", bench_main.history("settings", False, [{**row, "wall_s": 1.0}], 1.0))
            with open(os.path.join(top, "history.jsonl"), encoding="utf-8") as f:
                self.assertEqual(len([json.loads(x) for x in f]), 3)


if __name__ == "__main__":
    unittest.main()
