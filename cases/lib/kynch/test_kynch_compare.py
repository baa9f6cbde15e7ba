# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/kynch: readings of made-up columns, the theory's part, refusals."""

import contextlib
import io
import json
import os
import sys
import tempfile
import unittest
from unittest import mock

import numpy as np

from cases.lib.case.casefile import Case
from cases.lib.case.errors import CaseError
from cases.lib.kynch import kynch_column, kynch_compare, kynch_measure


def values(**changes):
    case = Case("sphere-half")
    for key, value in changes.items():
        case.set(key, str(value))
    return {**case.values, **case.derive(1, 1)}


class ProfileTest(unittest.TestCase):

    def test_one_sphere_cut_by_edges(self):
        # caps of a unit sphere about z = 5: pi h^2 (3 - h)/3
        edges = np.array([3.0, 4.0, 4.5, 5.0, 5.5, 6.0, 9.0])

        def cap(h):
            return np.pi * h**2 * (3 - h) / 3

        whole = 4 / 3 * np.pi
        found = kynch_measure.profile({"z": np.array([5.0])}, 1.0, 2.0, edges)
        np.testing.assert_allclose(2.0 * found, [0, 0, cap(0.5), whole / 2, whole - cap(0.5), whole, whole],
                                   atol=1e-12)

    def test_all_solids_above_all_spheres(self):
        z = np.random.default_rng(1).uniform(0.01, 0.1, 300)
        found = kynch_measure.profile({"z": z}, 1e-3, 1e-3, np.linspace(0, 0.2, 201))
        self.assertAlmostEqual(found[-1] / (300 * 4 / 3 * np.pi * 1e-9 / 1e-3), 1.0, delta=1e-12)
        self.assertTrue(np.all(np.diff(found) >= 0))


class MadeUpRun(unittest.TestCase):
    """A run folder whose spheres move as Kynch's theory wants it."""

    @classmethod
    def setUpClass(cls):
        cls.store = tempfile.TemporaryDirectory()
        cls.folders = [cls.make(os.path.join(cls.store.name, str(seed)), seed) for seed in (1, 2)]

    @classmethod
    def tearDownClass(cls):
        cls.store.cleanup()

    @staticmethod
    def make(folder, seed):
        v = values(end=0.8, frames=80, seed=seed)
        column = kynch_column.Column(v, 0.52)
        k = column.kynch
        os.makedirs(os.path.join(folder, "DEM"))
        number = int(v["spheres"])
        share = (np.arange(number) + 0.5) / number
        times = np.linspace(0, 0.8, 81)
        grid = np.linspace(0, v["tube_height"], 1501)
        with open(os.path.join(folder, "settling.csv"), "w", encoding="utf-8") as f:
            f.write("time_s,interface_m,bed_m,mean_height_m\n")
            for t in times:
                late = float(column.late(t))
                below = k.solids_below(grid, late)[0]
                z = np.interp(share * below[-1], below, grid)
                f.write(f"{t:.9g},{float(k.interface(late)):.9g},{float(k.bed(late)):.9g},{z.mean():.9g}\n")
                step = round(t / v["dem_step"])
                with open(os.path.join(folder, "DEM", f"spheres.{step:09d}.dump"), "w", encoding="utf-8") as d:
                    d.write("ITEM: ATOMS id z\n" + "".join(f"{n} {x:.9g}\n" for n, x in enumerate(z, 1)))
        with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as f:
            json.dump({"case": "sphere-half", "settings": v}, f)
        return folder

    def test_finds_the_theory_again(self):
        found = kynch_compare.Comparison(self.folders)
        self.assertAlmostEqual(found.phi_m, 0.52, delta=0.002)
        for key, gate in (("interface_speed", 0.002), ("top_speed", 0.002), ("bed_speed", 0.002),
                          ("meeting_time", 0.002), ("meeting_height", 0.002), ("lag", 0.02)):
            self.assertLess(abs(found.row(key)["error"]), gate, msg=key)
        self.assertLess(found.row("rms_over_height_late")["mean"], 1e-3)
        self.assertLess(found.row("mean_height_rms_late")["mean"], 1e-3)
        self.assertGreater(found.row("rms_over_height")["mean"], 0.02)

    def test_the_bed_is_read_off_its_floor_and_top(self):
        """Single spheres on the bed raise its top, and not its solid fraction."""
        from cases.lib.kynch import kynch_measure
        record = kynch_measure.Record(self.folders[0])
        before = record.packed
        record.top = record.top * 1.05
        self.assertAlmostEqual(record.packed, before, delta=0.03 * before)
        record.top = record.top * 0.3
        mean = record.values["solid_fraction"] * record.values["fill_height"] / record.settled()
        self.assertAlmostEqual(record.packed, mean)

    def test_program_writes_table_csv_json_pictures(self):
        out = os.path.join(self.store.name, "out")
        said = io.StringIO()
        with mock.patch.object(sys, "argv", ["kynch", "--runs", *self.folders, "--out", out]), \
                contextlib.redirect_stdout(said):
            self.assertEqual(kynch_compare.main(), 0)
        self.assertIn("interface speed", said.getvalue())
        self.assertEqual(sorted(os.listdir(out)), ["flux.png", "kynch.csv", "kynch.json", "kynch.png"])
        with open(os.path.join(out, "kynch.json"), encoding="utf-8") as f:
            found = json.load(f)["comparisons"][0]
        self.assertEqual(found["seeds"], [1, 2])
        self.assertAlmostEqual(found["quantities"]["interface_speed"]["theory"], 0.2361, delta=2e-4)

    def test_runs_that_differ_are_refused(self):
        other = os.path.join(self.store.name, "other")
        self.make(other, 3)
        path = os.path.join(other, "summary.json")
        with open(path, encoding="utf-8") as f:
            s = json.load(f)
        s["settings"]["drag"] = "DiFelice"
        with open(path, "w", encoding="utf-8") as f:
            json.dump(s, f)
        with self.assertRaisesRegex(CaseError, "drag is not that of"):
            kynch_compare.Comparison([self.folders[0], other])

    def test_foreign_folders(self):
        folder = os.path.join(self.store.name, "foreign")
        os.makedirs(folder)
        for content, words in (("[]", "was not written by cases/run"),
                               ('{"case": "x"}', "was not written by cases/run"),
                               ('{"case": "x", "settings": 1}', "was not written by cases/run"),
                               ('{"case": "x", "settings": {}, "complete": false, "reason": "ended by SIGTERM"}',
                                "is not complete: ended by SIGTERM; name a finished run"),
                               ('{"case": "x", "settings": {"end": 1}}', "has no setting seed")):
            with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as f:
                f.write(content)
            with self.assertRaisesRegex(CaseError, words):
                kynch_measure.Record(folder)

    def test_one_bad_group_does_not_stop_the_others(self):
        out, bad = os.path.join(self.store.name, "groups"), os.path.join(self.store.name, "none")
        said, errors = io.StringIO(), io.StringIO()
        with mock.patch.object(sys, "argv", ["kynch", "--phi0", "0.1,0.15", "--out", out]), \
                mock.patch.object(kynch_compare, "make", lambda args: ([[bad], self.folders], False)), \
                contextlib.redirect_stdout(said), contextlib.redirect_stderr(errors):
            self.assertEqual(kynch_compare.main(), 1)
        self.assertIn("holds no summary.json", errors.getvalue())
        with open(os.path.join(out, "kynch.json"), encoding="utf-8") as f:
            self.assertEqual(len(json.load(f)["comparisons"]), 1)

    def test_a_column_that_still_sinks_is_refused(self):
        record = kynch_measure.Record(self.folders[0])
        record.t, record.top = record.t[:40], record.top[:40]
        with self.assertRaisesRegex(CaseError, "does not rest at its end"):
            record.settled()


class RefusalTest(unittest.TestCase):

    def test_cases(self):
        with self.assertRaisesRegex(CaseError, "not free equal spheres"):
            kynch_column.refuse("clump-half", Case("clump-half").values)
        with self.assertRaisesRegex(CaseError, "charge = 1e-10"):
            kynch_column.refuse("x", {**values(), "charge": 1e-10})
        with self.assertRaisesRegex(CaseError, "drag = odd"):
            kynch_column.refuse("x", {**values(), "drag": "odd"})
        with self.assertRaisesRegex(CaseError, "below that of the bed"):
            kynch_column.Column(values(), 0.05)

    def test_options(self):
        with self.assertRaisesRegex(CaseError, "between 0 and 1"):
            kynch_compare.fractions("0.1,x")
        with self.assertRaisesRegex(CaseError, "take one of them"):
            kynch_compare.changed("sphere-half", ["spheres=100"], "0.1")
        self.assertAlmostEqual(kynch_compare.statistics([1.0, 2.0, 3.0])[1], 1.0, delta=1e-12)

    def test_runs_last_until_the_column_rests(self):
        for phi_0 in (0.02, 0.15, 0.3):
            v = values(solid_fraction=phi_0)
            self.assertGreater(kynch_column.enough(v), kynch_column.Column(v, 0.525).kynch.t_end)
        v = values(coupling_steps=7)
        intervals = kynch_column.enough(v) / (7 * v["dem_step"])
        self.assertAlmostEqual(intervals, round(intervals), delta=1e-6)


if __name__ == "__main__":
    unittest.main()
