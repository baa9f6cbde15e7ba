# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Debye lengths against those of tables and by the similarity."""

import unittest

from cases.lib.case import suspension
from cases.lib.case.casefile import Case
from cases.lib.case.errors import CaseError
from cases.lib.theory import screening


def settings(**changes):
    case = Case("clump-half")
    for key, value in changes.items():
        case.set(key, str(value))
    return {**case.values, **suspension.resolve(case.values)}


class ScreeningTest(unittest.TestCase):

    def test_table(self):
        # a 1:1 salt at 25 C: 0.1 M 0.96 nm, 1 mM 9.6 nm, pure water (1e-7 M) 960 nm
        for salinity, nanometres in ((0.1, 0.96), (1e-3, 9.6), (1e-7, 960)):
            self.assertAlmostEqual(1e9 * screening.debye_length(salinity) / nanometres, 1, delta=0.005)

    def test_by_the_spheres_diameters(self):
        v = settings(salinity=1e-6)
        self.assertAlmostEqual(v["debye_length"] / 3.04e-4, 1, delta=1e-12)  # 304 nm, 2 mm for 2 um
        wide = settings(salinity=1e-6, prototype_diameter=4e-6)
        self.assertAlmostEqual(wide["debye_length"] / v["debye_length"], 0.5, delta=1e-12)

    def test_the_scripts_words(self):
        self.assertEqual(settings()["coulomb_law"], "sharp")
        self.assertNotIn("debye_length", settings())
        self.assertEqual(settings(salinity=1e-6, coulomb="shifted")["coulomb_law"], "shifted screened 0.000304")

    def test_said(self):
        self.assertEqual(screening.line(settings()), "")
        said = screening.line(settings(salinity=1e-6))
        for words in ("1e-06 mol/l", "304 nm", "0.304 mm (1000 times)", "keep 0.412 of Coulomb's force"):
            self.assertIn(words, said)

    def test_overlaps(self):
        v = settings(salinity=1e-6)  # a fifth of 0.304 mm is 0.0304 of 2 mm
        self.assertEqual(screening.warnings(v, 0.0303), [])
        self.assertIn("overlap by 0.061 mm, more than a fifth of the Debye length, 0.304 mm",
                      screening.warnings(v, 0.0305)[0])
        self.assertEqual(screening.warnings(settings(), 0.5), [])
        self.assertEqual(screening.warnings(v, None), [])

    def test_scripts(self):
        v = settings(salinity=1e-6)
        own = ("pair_style hybrid/overlay gran model hooke dlvo/clump 8e-4 &\n"
               "    debye 1e-4 hamaker 1e-14 contact 2e-5\n")
        said = screening.of_scripts(v, {"in.liggghts": own})
        self.assertEqual(len(said), 1)
        self.assertIn("in.liggghts: pair dlvo/clump has a Debye length of its own, salinity's is 0.000304 m", said[0])
        self.assertEqual(screening.of_scripts(v, {"in": own.replace("1e-4", "${debye_length}", 1)}), [])
        self.assertEqual(screening.of_scripts(v, {"in": "# " + own.replace("&\n", "")}), [])
        self.assertEqual(screening.of_scripts(settings(), {"in": own}), [])

    def test_range(self):
        case = Case("clump-half")
        for bad in ("0", "-1", "6", "salty"):
            with self.assertRaisesRegex(CaseError, "salinity"):
                case.set("salinity", bad)


if __name__ == "__main__":
    unittest.main()
