# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Scaling against the paper's numbers and by going there and back."""

import contextlib
import io
import unittest

import numpy as np

from cases.lib.theory import drag
from cases.lib.theory.scaling import CALIBRATED, DAY, Scaling, main, stokes_velocity


class ScalingTest(unittest.TestCase):

    def test_paper(self):
        paper = Scaling()
        self.assertAlmostEqual(paper.stokes_ratio / 1e6, 1.0, delta=1e-12)
        self.assertAlmostEqual(paper.model.stokes / paper.prototype.stokes
                               / 1e6, 1.0, delta=1e-12)
        calibrated = Scaling(factor=CALIBRATED)
        self.assertAlmostEqual(calibrated.to_prototype(64.0) / DAY, 703.0,
                               delta=0.5)
        for days, seconds in ((77.0, 7.0), (10.0, 0.91), (130.0, 11.8)):
            self.assertAlmostEqual(calibrated.to_model(days * DAY) / seconds,
                                   1.0, delta=0.006)

    def test_there_and_back(self):
        scaling = Scaling(d_model=1e-3, d_prototype=3e-6)
        t = np.array([0.1, 5.0, 64.0])
        np.testing.assert_allclose(scaling.to_model(scaling.to_prototype(t)),
                                   t, rtol=1e-14)
        v = scaling.velocity_to_model(scaling.prototype.stokes)
        self.assertAlmostEqual(v / scaling.model.stokes, 1.0, delta=1e-12)
        self.assertAlmostEqual(scaling.velocity_to_prototype(v)
                               / scaling.prototype.stokes, 1.0, delta=1e-12)

    def test_stokes_velocity_by_force(self):
        d, rho_p, rho_f, mu = 1e-5, 2600.0, 1000.0, 1e-3
        v = stokes_velocity(d, rho_p, rho_f, mu)
        weight = np.pi / 6 * d**3 * (rho_p - rho_f) * 9.81
        self.assertAlmostEqual(3 * np.pi * mu * d * v / weight, 1.0,
                               delta=1e-12)

    def test_terminal_velocity_by_force(self):
        model = Scaling().model
        cd = 24.0 / model.re * (1.0 + 0.15 * model.re**0.687)
        force = cd * 0.5 * 1000.0 * model.terminal**2 * np.pi / 4 * model.d**2
        weight = np.pi / 6 * model.d**3 * 1600.0 * 9.81
        self.assertAlmostEqual(force / weight, 1.0, delta=1e-9)
        self.assertAlmostEqual(model.re, 1000.0 * model.terminal * model.d
                               / 8.94e-4, delta=1e-6)

    def test_terminal_velocity_either_way(self):
        down = drag.terminal_velocity(1e-3, 1100.0, 1000.0, 1e-3)
        up = drag.terminal_velocity(1e-3, 900.0, 1000.0, 1e-3)
        self.assertGreater(down, 0.0)
        self.assertAlmostEqual(up, -down, delta=1e-12)
        self.assertEqual(drag.terminal_velocity(1e-3, 1e3, 1e3, 1e-3), 0.0)

    def test_warnings(self):
        paper = Scaling()
        self.assertEqual(paper.prototype.warning, "")
        self.assertIn("not Stokes flow", paper.model.warning)
        self.assertIn("13.7 times too fast", paper.model.warning)
        self.assertIn("ratio of times", paper.warnings[-1])
        self.assertLess(paper.terminal_ratio, 0.1 * paper.stokes_ratio)

    def test_warning_begins_at_5_percent(self):
        # 0.15 Re^0.687 = 0.05 at Re = 0.202
        found = [Scaling(d_model=d, d_prototype=1e-6).model
                 for d in np.geomspace(2e-5, 2e-4, 40)]
        for side in found:
            self.assertEqual(bool(side.warning), side.re > 0.202)
        self.assertTrue(found[-1].warning)
        self.assertIn("% too fast", [s for s in found if s.warning][0].warning)
        self.assertFalse(Scaling(d_model=2e-5, d_prototype=1e-6).warnings)

    def test_bad_input(self):
        for name, value in (("mu", 0.0), ("d_model", -1.0), ("factor", -2.0),
                            ("rho_p", float("nan"))):
            with self.assertRaisesRegex(ValueError, f"{name} = "):
                Scaling(**{name: value})
        with self.assertRaisesRegex(ValueError, "above rho_f"):
            Scaling(rho_p=900.0)

    def test_command(self):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            self.assertEqual(main(["--calibrated", "--model-time", "64",
                                   "--prototype-days", "77"]), 0)
            self.assertEqual(main(["--model-speed", "0.01",
                                   "--prototype-speed", "0.864"]), 0)
            self.assertEqual(main(["--ratio", "1e4"]), 0)
            self.assertEqual(main(["--mu", "-1"]), 2)
        self.assertIn("model 64 s = prototype 703 d", out.getvalue())
        self.assertIn("prototype 77 d = model 7.01", out.getvalue())
        self.assertIn("warning: model: Re = 638", out.getvalue())
        # by Eq. 16: 1e6
        self.assertIn("model 0.01 m/s = prototype 0.864 mm/d", out.getvalue())
        self.assertIn("prototype 0.864 mm/d = model 0.01 m/s", out.getvalue())
        self.assertIn("0.0002       2e-06", out.getvalue())
        self.assertEqual(err.getvalue(),
                         "theory.scaling: mu = -1.0 should be positive\n")


if __name__ == "__main__":
    unittest.main()
