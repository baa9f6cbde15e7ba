# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Water against tabled values."""

import contextlib
import io
import unittest

import numpy as np

from cases.lib.theory import water


class WaterTest(unittest.TestCase):

    def test_density_table(self):
        # CRC Handbook of Chemistry and Physics, air-free water at 101325 Pa
        table = {0.0: 999.84, 4.0: 999.97, 20.0: 998.21, 25.0: 997.05,
                 40.0: 992.22, 60.0: 983.20}
        for t, rho in table.items():
            self.assertAlmostEqual(float(water.density(t)), rho, delta=0.02)

    def test_density_is_greatest_near_4_c(self):
        t = np.linspace(0.0, 10.0, 1001)
        self.assertAlmostEqual(t[np.argmax(water.density(t))], 3.98, delta=0.03)

    def test_viscosity_table(self):
        # IAPWS values; 25 C: 0.8900 mPa s
        table = {0.0: 1.792e-3, 20.0: 1.0016e-3, 25.0: 8.900e-4,
                 40.0: 6.527e-4, 60.0: 4.660e-4}
        for t, mu in table.items():
            self.assertAlmostEqual(float(water.dynamic_viscosity(t)) / mu, 1.0,
                                   delta=1e-3)

    def test_kinematic_and_shape(self):
        nu = water.kinematic_viscosity(np.array([[20.0, 25.0]]))
        self.assertEqual(nu.shape, (1, 2))
        self.assertAlmostEqual(nu[0, 0] * 1e6, 1.0034, delta=1e-3)

    def test_out_of_range(self):
        for t in (-0.1, 60.1, float("nan")):
            with self.assertRaisesRegex(ValueError, "temperature = "):
                water.density(t)
            with self.assertRaisesRegex(ValueError, "between 0 and 60 C"):
                water.dynamic_viscosity(t)

    def test_command(self):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            self.assertEqual(water.main(["20"]), 0)
            self.assertEqual(water.main(["90"]), 1)
        self.assertIn("rho 998.20", out.getvalue())
        self.assertEqual(err.getvalue().count("\n"), 1)


if __name__ == "__main__":
    unittest.main()
