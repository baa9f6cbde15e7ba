# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Start-up against Stokes flow, which has a closed form."""

import unittest

import numpy as np

from cases.lib.theory import flux
from cases.lib.theory.startup import startup


class StartupTest(unittest.TestCase):

    def law(self, name="ergunWenYu", d=2e-3):
        return flux.DragLawFlux(name, d, 2600.0, 1000.0, 8.94e-7)

    def test_stokes(self):
        # drag linear in the slip: v/v_end = 1 - exp(-t/tau)
        linear = flux.DragLawFlux(lambda n, slip, d, nu, rho:
                                  18.0 * nu * rho / d**2 + 0.0 * slip,
                                  2e-5, 2600.0, 1000.0, 8.94e-7)
        phi = 0.1
        found = startup(linear, phi, 2600.0)
        n = 1.0 - phi
        tau = ((2600.0 + 1000.0 * phi / n) * n**2
               / (18.0 * 8.94e-4 / 2e-5**2))
        self.assertAlmostEqual(found.lag / tau, 1.0, delta=1e-4)
        self.assertAlmostEqual(found.settled / (tau * np.log(100.0)), 1.0,
                               delta=3e-3)
        self.assertAlmostEqual(
            found.velocity / float(linear.velocity(phi)), 1.0, delta=1e-12)

    def test_ends_at_the_flux_for_every_law(self):
        for name in ("ergunWenYu", "DiFelice", "KochHill", "SchillerNaumann"):
            law = self.law(name)
            found = startup(law, 0.0636, 2600.0)
            last = ((found.fall[-1] - found.fall[-101])
                    / (found.t[-1] - found.t[-101]))
            self.assertAlmostEqual(last / float(law.velocity(0.0636)), 1.0,
                                   delta=1e-6, msg=name)

    def test_lag_is_the_way_lost(self):
        found = startup(self.law(), 0.0636, 2600.0)
        lost = found.velocity * found.t[-1] - found.fall[-1]
        self.assertAlmostEqual(lost / (found.velocity * found.lag), 1.0,
                               delta=1e-9)
        self.assertGreater(found.settled, found.lag)

    def test_bad_input(self):
        for phi, rho_p, name in ((0.0, 2600.0, "phi"), (0.7, 2600.0, "phi"),
                                 (0.1, 0.0, "rho_p")):
            with self.assertRaisesRegex(ValueError, name):
                startup(self.law(), phi, rho_p)


if __name__ == "__main__":
    unittest.main()
