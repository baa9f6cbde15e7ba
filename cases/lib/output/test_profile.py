# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The table of both halves' profiles, of made-up files."""

import os
import tempfile
import unittest

import numpy as np

from cases.lib.output import profile

VALUES = {"fluid_density": 1000.0, "density": 2600.0, "gravity": 9.81, "tube_height": 0.1, "viscosity": 1e-3,
          "dem_step": 1e-5}
HEAD = ("time_s,height_m,solid_fraction,velocity_m_s,flux_m_s,contact_Pa,coulomb_Pa,wall_Pa,fluid_Pa,weight_Pa\n")


class ProfileTest(unittest.TestCase):

    def setUp(self):
        store = tempfile.TemporaryDirectory()
        self.addCleanup(store.cleanup)
        self.folder = store.name
        self.z = (np.arange(20) + 0.5) * 0.005
        with open(os.path.join(self.folder, "solids.csv"), "w", encoding="utf-8") as f:
            f.write(HEAD)
            for t in (0.0, 0.5, 1.0):
                f.writelines(f"{t},{h:.7g},0.1,-0.01,-0.001,10,2,1,0,15\n" for h in self.z)
            f.write("1.5,0.0025,0.1,-0.01")  # torn
        at = os.path.join(self.folder, "CFD", "postProcessing", "fluid", "0")
        os.makedirs(at)
        with open(os.path.join(at, "fluid.dat"), "w", encoding="utf-8") as f:
            f.write("# time [s]\tz [m]\tn\tn Uz [m/s]\tp [m2/s2]\n")
            for t in (0.5, 1.0):
                f.writelines(f"{t}\t{h}\t0.9\t0.001\t{7 + 2 * (0.1 - h)}\n" for h in (0.0125, 0.0375, 0.0625, 0.0875))

    def test_joined(self):
        c = profile.joined(self.folder, VALUES)
        self.assertEqual(list(c["time_s"]), [0.0, 0.5, 1.0])
        self.assertTrue(np.all(np.isnan(c["excess_pressure_Pa"][0])))  # the fluid has no row then
        # linear between the layers and beyond, and nothing at the top
        np.testing.assert_allclose(c["excess_pressure_Pa"][1], 2000 * (0.1 - self.z), rtol=1e-9)
        np.testing.assert_allclose(c["fluid_velocity_m_s"][2], 0.001 / 0.9, rtol=1e-9)

    def test_permeability(self):
        # 0.001 m/s upwards and solids down at 0.01 m/s, 0.9 of them fluid: 0.01 m/s against 2000 Pa/m
        c = profile.joined(self.folder, VALUES)
        np.testing.assert_allclose(c["permeability_m2"][1], 1e-3 * (0.001 + 0.9 * 0.01) / 2000, rtol=1e-9)
        none = profile.permeability(np.array([0.01, 0.1, 0.1]), np.zeros(3), np.array([1e-3, 1e-3, -1e-3]),
                                    np.array([-2e3, -1.0, -2e3]), 1e-3, 15696.0)
        self.assertTrue(np.all(np.isnan(none)))  # few solids, no slope, a flux that goes up it

    def test_written_and_read(self):
        c = profile.joined(self.folder, VALUES)
        profile.write(self.folder, c)
        again = profile.read(self.folder)
        self.assertEqual(list(again), list(c))
        for name, values in c.items():
            np.testing.assert_allclose(again[name], values, rtol=2e-6)

    def test_imbalance(self):
        c = profile.joined(self.folder, VALUES)
        c["excess_pressure_Pa"][1:] = 2.0
        np.testing.assert_allclose(profile.imbalance(c, 2), 0, atol=1e-12)
        c["excess_pressure_Pa"][2] = 5.0
        np.testing.assert_allclose(profile.imbalance(c, 2), 0.1, atol=1e-12)


if __name__ == "__main__":
    unittest.main()
