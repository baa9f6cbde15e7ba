# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Stages of made-up settling curves whose breaks are known."""

import unittest

import numpy as np

from cases.lib.theory.stages import correlation_time, detect

TIME = np.linspace(0.0, 64.0, 1281)
THREE = np.interp(TIME, [0, 3, 30, 64], [0.15, 0.09, 0.04, 0.035])
TWO = np.interp(TIME, [0, 10, 64], [0.15, 0.05, 0.03])
ONE = 0.15 - 0.002 * TIME


def white(rms, seed=0, size=TIME.size):
    """Noise without correlation."""
    return rms * np.random.default_rng(seed).standard_normal(size)


def red(rms, rho=0.97, seed=0):
    """Noise of first-order autoregression, correlated over 30 points."""
    noise = white(1.0, seed)
    for k in range(1, noise.size):
        noise[k] += rho * noise[k - 1]
    return rms * noise / np.std(noise)


class StagesTest(unittest.TestCase):

    def check(self, fit, breaks, slopes, rtol):
        self.assertEqual(fit.count, len(slopes), msg=fit.message)
        np.testing.assert_allclose(fit.breaks, breaks, rtol=rtol)
        np.testing.assert_allclose(fit.slopes, slopes,
                                   atol=rtol * np.max(np.abs(slopes)))

    def test_exact_curves(self):
        fit = detect(TIME, THREE)
        self.check(fit, [3, 30], [-0.02, -0.05 / 27, -0.005 / 34], 5e-3)
        self.assertTrue(fit.three and fit.ordered)
        np.testing.assert_allclose(fit.heights, [0.15, 0.09, 0.04, 0.035],
                                   atol=2e-4)
        np.testing.assert_allclose(fit.height(TIME), THREE, atol=1e-3)
        fit = detect(TIME, TWO)
        self.check(fit, [10], [-0.01, -0.02 / 54], 5e-3)
        self.assertFalse(fit.three)
        fit = detect(TIME, ONE)
        self.check(fit, [], [-0.002], 1e-6)
        four = np.interp(TIME, [0, 5, 20, 40, 64],
                         [0.15, 0.1, 0.06, 0.04, 0.038])
        self.check(detect(TIME, four), [5, 20, 40],
                   [-0.01, -0.04 / 15, -0.001, -0.002 / 24], 1e-2)

    def test_noise(self):
        for rms in (1e-4, 1e-3, 3e-3):
            fit = detect(TIME, THREE + white(rms))
            self.check(fit, [3, 30], [-0.02, -0.05 / 27, -0.005 / 34], 0.06)
            self.assertTrue(fit.three)
            self.assertLess(abs(detect(TIME, TWO + white(rms)).breaks[0] - 10),
                            0.3)
            self.assertEqual(detect(TIME, ONE + white(rms)).count, 1)

    def test_correlated_noise_is_not_structure(self):
        right = 0
        for seed in range(8):
            noise = red(1e-3, seed=seed)
            for curve, count in ((ONE, 1), (TWO, 2), (THREE, 3)):
                fit = detect(TIME, curve + noise, samples=0)
                right += fit.count == count
                self.assertLess(fit.independent, 80)
        self.assertGreaterEqual(right, 22)

    def test_short_first_stage(self):
        # as in the paper: 0.9 s of 64 s, where half the fall is
        curve = np.interp(TIME, [0, 0.9, 40, 64], [0.15, 0.07, 0.05, 0.045])
        fit = detect(TIME, curve + white(1e-4))
        self.check(fit, [0.9, 40], [-0.08 / 0.9, -0.02 / 39.1, -0.005 / 24],
                   5e-3)
        self.assertTrue(fit.three)

    def test_exponential_is_not_three_stages(self):
        for noise in (0.0, 1e-4, 1e-3):
            curve = 0.05 + 0.1 * np.exp(-TIME / 15) + white(noise)
            fit = detect(TIME, curve, samples=20)
            self.assertFalse(fit.three)
            self.assertIn("bends throughout", fit.message)

    def test_line_then_exponential_tail(self):
        curve = np.where(TIME < 10, 0.15 - 0.005 * TIME,
                         0.04 + 0.06 * np.exp(-(TIME - 10) / 12))
        fit = detect(TIME, curve + white(1e-4), samples=20)
        self.assertTrue(fit.linear[0])
        self.assertFalse(fit.linear[-1])
        self.assertAlmostEqual(fit.slopes[0] / -0.005, 1.0, delta=0.05)

    def test_three_stages_with_tail(self):
        curve = np.where(TIME < 30, THREE,
                         0.035 + 0.005 * np.exp(-(TIME - 30) / 3))
        fit = detect(TIME, curve + white(1e-4), samples=20)
        self.assertTrue(fit.three)
        self.assertAlmostEqual(fit.breaks[0], 3.0, delta=0.05)
        self.assertAlmostEqual(fit.slopes[1] / (-0.05 / 27), 1.0, delta=0.02)

    def test_intervals_hold_the_truth(self):
        inside = np.zeros(5)
        for seed in range(20):
            fit = detect(TIME, THREE + white(1e-3, seed), samples=80)
            truth = [3, 30, -0.02, -0.05 / 27, -0.005 / 34]
            bounds = np.vstack([fit.breaks_ci, fit.slopes_ci])
            inside += (bounds[:, 0] <= truth) & (truth <= bounds[:, 1])
        # of 20 intervals at 95 %: 14 or fewer has a chance below 1e-3
        self.assertTrue(np.all(inside >= 14), msg=f"{inside}")
        self.assertTrue(np.all(bounds[:, 0] < bounds[:, 1]))

    def test_deterministic_and_units(self):
        a = detect(TIME, THREE + white(1e-3), samples=50)
        b = detect(TIME, THREE + white(1e-3), samples=50)
        np.testing.assert_array_equal(a.breaks_ci, b.breaks_ci)
        c = detect(TIME * 1e4 + 5e5, (THREE + white(1e-3)) * 10, samples=50)
        np.testing.assert_allclose(c.breaks, a.breaks * 1e4 + 5e5, rtol=1e-5)
        np.testing.assert_allclose(c.slopes, a.slopes * 1e-3, rtol=1e-4)

    def test_other_shapes(self):
        uneven = np.sort(np.random.default_rng(3).uniform(0, 64, 300))
        fit = detect(uneven, np.interp(uneven, TIME, THREE) + white(1e-4,
                                                                    0, 300))
        np.testing.assert_allclose(fit.breaks, [3, 30], rtol=0.02)
        self.assertEqual(detect(TIME, 0 * TIME + 0.1).count, 1)
        slow_start = np.interp(TIME, [0, 20, 64], [0.15, 0.14, 0.05])
        fit = detect(TIME, slow_start + white(1e-4))
        self.assertFalse(fit.ordered)
        self.assertIn("falls faster", fit.message)
        few = detect(TIME[::80], THREE[::80], most=2, samples=0)
        self.assertLessEqual(few.count, 2)
        self.assertTrue(np.all(np.isnan(few.slopes_ci)))

    def test_correlation_time(self):
        self.assertLess(correlation_time(white(1.0)), 1.3)
        # (1 + rho)/(1 - rho) for first-order autoregression
        noise = np.concatenate([red(1.0, 0.8, seed) for seed in range(8)])
        self.assertAlmostEqual(correlation_time(noise) / 9.0, 1.0, delta=0.2)
        self.assertEqual(correlation_time(np.zeros(50)), 1.0)

    def test_bad_input(self):
        for arguments, words in (
                ((TIME, THREE[:-1]), "equal length"),
                ((TIME[:5], THREE[:5]), "12 or more"),
                ((TIME[::-1], THREE), "should rise"),
                ((TIME, THREE, 5), "most = 5"),
                ((TIME, THREE, 4, 1.5), "level = 1.5"),
                ((TIME, THREE + np.nan), "finite")):
            with self.assertRaisesRegex(ValueError, words):
                detect(*arguments)


if __name__ == "__main__":
    unittest.main()
