# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/stages and cases/scaling as programs."""

import contextlib
import io
import json
import os
import sys
import tempfile
import unittest
from unittest import mock

import numpy as np

from cases.lib.calibration import scaling_main, stages_main
from cases.lib.case.errors import CaseError


class StagesTest(unittest.TestCase):

    def setUp(self):
        self.store = tempfile.TemporaryDirectory()
        self.addCleanup(self.store.cleanup)
        self.path = os.path.join(self.store.name, "curve.csv")

    def write(self, text):
        with open(self.path, "w", encoding="utf-8") as f:
            f.write(text)
        return self.path

    def run_on(self, *options):
        said = io.StringIO()
        with mock.patch.object(sys, "argv", ["stages", *options]), contextlib.redirect_stdout(said):
            self.assertEqual(stages_main.main(), 0)
        with open(os.path.join(self.store.name, "stages.json"), encoding="utf-8") as f:
            return said.getvalue(), json.load(f)

    def curve(self, breaks, slopes, head="days,height_m,spare\n"):
        t = np.linspace(0, 100, 301)
        z = 0.3 + np.interp(t, breaks, np.concatenate([[0], np.cumsum(np.diff(breaks) * slopes)]))
        z += 2e-4 * np.random.default_rng(2).standard_normal(t.size)
        return self.write("# measured\n" + head + "".join(f"{a:.6g},{b:.6g},1\n" for a, b in zip(t, z)))

    def test_three_stages_of_a_measured_curve(self):
        self.curve([0, 15, 60, 100], [-0.01, -0.001, -0.0001])
        said, found = self.run_on(self.path, "--data", "days,height_m", "--samples", "60")
        self.assertTrue(found["three_stages"])
        self.assertEqual(len(found["segments"]), 3)
        for k, (slope, at) in enumerate(((-0.01, 15), (-0.001, 60), (-0.0001, None))):
            piece = found["segments"][k]
            self.assertAlmostEqual(piece["slope"] / slope, 1.0, delta=0.1)
            self.assertLessEqual(piece["slope_interval"][0], piece["slope"])
            self.assertGreaterEqual(piece["slope_interval"][1], piece["slope"])
            if at:
                self.assertAlmostEqual(found["breaks"][k], at, delta=2)
        self.assertIn("settling stages: 3", said)
        self.assertGreater(os.path.getsize(os.path.join(self.store.name, "stages.png")), 10000)

    def test_a_run_that_is_not_complete(self):
        self.curve([0, 15, 60, 100], [-0.01, -0.001, -0.0001])
        os.rename(self.path, os.path.join(self.store.name, "settling.csv"))
        with open(os.path.join(self.store.name, "summary.json"), "w", encoding="utf-8") as f:
            f.write('{"complete": false, "reason": "ended by SIGTERM"}')
        with mock.patch.object(sys, "argv", ["stages", self.store.name]), \
                self.assertRaisesRegex(CaseError, "is not complete: ended by SIGTERM"):
            stages_main.main()

    def test_fewer_are_said_to_be_fewer(self):
        self.curve([0, 30, 100], [-0.005, -0.0003])
        said, found = self.run_on(self.path, "--data", "days,height_m", "--samples", "40")
        self.assertFalse(found["three_stages"])
        self.assertEqual(found["stages"]["count"], 2)
        self.assertIn("fewer than", said)

    def test_by_stress(self):
        t = np.linspace(0, 10, 101)
        z = (np.arange(10) + 0.5) * 0.01
        curve = np.where(t < 4, 0.1 - 0.0125 * t, 0.05)
        with open(os.path.join(self.store.name, "settling.csv"), "w", encoding="utf-8") as f:
            f.write("time_s,interface_m\n")
            f.writelines(f"{a:.4g},{b:.6g}\n" for a, b in zip(t, curve))
        for begins, says in ((4.0, "agree within the interval"), (8.0, "differ by 4")):
            with open(os.path.join(self.store.name, "profile.csv"), "w", encoding="utf-8") as f:
                f.write("time_s,height_m,contact_Pa,coulomb_Pa,weight_Pa\n")
                for a in t:
                    f.writelines(f"{a:.4g},{h},{(0.8 if a >= begins else 0.1) * max(50 - 1000 * h, 0):.6g},0,"
                                 f"{max(50 - 1000 * h, 0):.6g}\n" for h in z)
            text, kept = self.run_on(self.store.name, "--samples", "40")
            self.assertIn("by stress: consolidation begins at", text)
            self.assertIn(says, text)
            self.assertAlmostEqual(kept["by_stress"]["begin"], begins, delta=0.11)

    def test_refusals(self):
        rows = "".join(f"{k},{1 - 0.01 * k},0\n" for k in range(20))
        for text, data, words in (("a,b,c\n" + rows, None, "--data TIME,HEIGHT says which two"),
                                  ("a,b,c\n" + rows, "a,x", "unknown column 'x'"),
                                  ("a,b,c\n" + rows, "a", "two columns, TIME,HEIGHT"),
                                  ("a,b,c\n" + rows + "30,x,0\n", "a,b", "line 22: '30,x,0'"),
                                  ("a,b,c\n" + rows + "3,1,0\n", "a,b", "does not come after"),
                                  ("# nothing\n", None, "holds no rows"),
                                  ("time_s,height_m\n", None, "holds names of columns, but no rows"),
                                  ("0,x\n" + rows, None, "line 1: '0,x'")):
            with self.assertRaisesRegex(CaseError, words):
                stages_main.read(self.write(text), data)

    def test_units(self):
        self.assertEqual([stages_main.unit(n) for n in ("interface_m", "z_mm", "height")], ["m", "mm", ""])
        self.assertEqual(stages_main.unit("time_days", stages_main._TIMES), "d")


class ScalingTest(unittest.TestCase):

    def test_of_a_case(self):
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            self.assertEqual(scaling_main.main(["clump-half", "--model-time", "7", "--prototype-days", "77"]), 0)
        self.assertIn("model 7 s = prototype 76.89 d", said.getvalue())
        self.assertIn("prototype 77 d = model 7.01 s", said.getvalue())
        self.assertIn("9.49e+05", said.getvalue())
        self.assertIn("warning: model: Re = 638 is not Stokes flow", said.getvalue())

    def test_other_diameters_have_a_ratio_of_their_own(self):
        for words in (["--ratio", "1e4"], ["--d-model=2e-4"], ["--d-prototype", "2e-5"]):
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                self.assertEqual(scaling_main.main(["clump-half", *words]), 0)
            self.assertRegex(said.getvalue(), r"T_p/T_m in use +1e\+04")
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            scaling_main.main(["clump-half", "--ratio", "1e4", "--calibrated"])
        self.assertRegex(said.getvalue(), r"T_p/T_m in use +9.49e\+05")

    def test_unknown_case(self):
        with self.assertRaisesRegex(CaseError, "unknown case 'odd'"):
            scaling_main.main(["odd"])


if __name__ == "__main__":
    unittest.main()
