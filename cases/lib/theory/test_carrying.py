# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Where stresses carry, on made-up profiles."""

import unittest

import numpy as np

from cases.lib.theory import carrying

Z = (np.arange(10) + 0.5) * 0.01


class CarryingTest(unittest.TestCase):

    def test_front_from_the_bottom_up(self):
        weight = 100 - 1000 * Z
        stress = np.where(Z < 0.04, 0.6, 0.4) * weight
        self.assertAlmostEqual(carrying.front(Z, stress, weight), 0.04, delta=1e-12)
        stress[0] = 0.4 * weight[0]  # not at the bottom: none
        self.assertEqual(carrying.front(Z, stress, weight), 0)
        self.assertAlmostEqual(carrying.front(Z, 0.51 * weight, weight), 0.095, delta=0.006)
        self.assertEqual(carrying.front(Z, 0 * weight, 0 * weight), 0)

    def test_impacts_are_left_out(self):
        rows = np.ones((9, 1))
        rows[4] = 1000
        self.assertTrue(np.all(carrying.smoothed(rows) == 1))
        rows[0] = np.nan  # the fluid has no row at the start
        found = carrying.smoothed(rows)
        self.assertTrue(np.isfinite(found[1:]).all())

    def test_boundaries_are_for_good(self):
        times = np.arange(6.0)
        begin, end = carrying.boundaries(times, [0, 1, 0, 1, 4, 10], [10.0] * 6)
        self.assertEqual((begin, end), (3, 5))
        self.assertEqual(carrying.boundaries(times, [0] * 6, [1.0] * 6), (None, None))

    def test_of_a_profile(self):
        times = np.linspace(0, 10, 101)
        weight = np.tile(np.maximum(50 - 1000 * Z, 0), (101, 1))
        # the bottom carries from 3 s on, all from 6 s on
        share = np.where(times[:, None] >= 3 + 3 * Z / 0.05, 0.9, 0.1)
        found = carrying.of_profile({"time_s": times, "height_m": Z, "weight_Pa": weight,
                                     "contact_Pa": 0.5 * share * weight, "coulomb_Pa": 0.5 * share * weight})
        self.assertAlmostEqual(found[2], 3.3, delta=0.11)
        self.assertAlmostEqual(found[3], 5.7, delta=0.35)


if __name__ == "__main__":
    unittest.main()
