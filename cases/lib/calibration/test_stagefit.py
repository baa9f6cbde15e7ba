# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Stages of made-up curves, with a slow start and with a bend in the first."""

import unittest

import numpy as np

from cases.lib.calibration import stagefit

TIME = np.linspace(0.0, 10.0, 501)


def curve(times, slopes, noise=1e-4):
    heights = np.concatenate([[0.15], 0.15 + np.cumsum(np.diff(times) * slopes)])
    return np.interp(TIME, times, heights) + noise * np.random.default_rng(1).standard_normal(TIME.size)


class StagefitTest(unittest.TestCase):

    def check(self, times, slopes, wanted, start, breaks):
        found = stagefit.of(TIME, curve(times, slopes), samples=50)
        self.assertEqual(found.count, len(wanted), msg=f"{found}")
        np.testing.assert_allclose(found.slopes, wanted, rtol=0.15)
        np.testing.assert_allclose(found.breaks, breaks, atol=0.3)
        self.assertAlmostEqual(found.start, start, delta=0.2)
        self.assertEqual((found.slopes_ci.shape, found.breaks_ci.shape),
                         ((len(wanted), 2), (len(wanted) - 1, 2)))
        self.assertTrue(np.all(found.slopes_ci[:, 0] <= found.slopes) and
                        np.all(found.slopes <= found.slopes_ci[:, 1]))

    def test_stages(self):
        self.check([0, 2, 6, 10], [-0.04, -0.008, -0.001], [-0.04, -0.008, -0.001], 0, [2, 6])
        self.check([0, 3, 10], [-0.03, -0.002], [-0.03, -0.002], 0, [3])
        self.check([0, 10], [-0.01], [-0.01], 0, [])

    def test_slow_start_is_no_stage(self):
        self.check([0, 1, 4, 10], [-0.004, -0.03, -0.002], [-0.03, -0.002], 1, [4])
        self.check([0, 1, 3, 6, 10], [0.002, -0.03, -0.01, -0.001], [-0.03, -0.01, -0.001], 1, [3, 6])

    def test_a_bend_is_no_stage(self):
        self.check([0, 2, 4, 10], [-0.03, -0.022, -0.002], [-0.026, -0.002], 0, [4])
        found = stagefit.of(TIME, curve([0, 1, 2, 4, 10], [-0.025, -0.018, -0.024, -0.001]), samples=0)
        self.assertEqual(found.count, 2)

    def test_a_knee_is_no_stage(self):
        found = stagefit.of(TIME, curve([0, 4, 5, 10], [-0.03, -0.012, -0.0005]), samples=0)
        self.assertEqual(found.count, 2)
        self.assertAlmostEqual(found.breaks[0], 4.4, delta=0.4)


if __name__ == "__main__":
    unittest.main()
