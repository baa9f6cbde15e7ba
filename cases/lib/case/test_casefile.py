# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of casefile and suspension: cases that are like others, words for numbers."""

import json
import math
import os
import tempfile
import unittest
from unittest import mock

from cases.lib.case import casefile, suspension
from cases.lib.case.casefile import Case
from cases.lib.case.errors import CaseError


class InFolder(unittest.TestCase):
    """Cases in a folder of the test's own."""

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.top = place.name
        patch = mock.patch.object(casefile, "PLACES", (self.top,))
        patch.start()
        self.addCleanup(patch.stop)

    def write(self, name, **content):
        os.makedirs(os.path.join(self.top, name))
        with open(os.path.join(self.top, name, "case.json"), "w", encoding="utf-8") as f:
            json.dump(content, f)

    def base(self):
        def number(value, **more):
            return {"value": value, "is": "a number", **more}
        self.write("base", parameters={
            "end": number(1.0), "dem_step": number(1e-5), "coupling_steps": number(20),
            "frames": number(10), "curve_rows": number(200), "seed": number(1),
            "width": number(2.0, above=0), "height": number("width", **{"or": ["width"], "above": 0})})


class LikeTest(InFolder):

    def test_takes_over_and_changes(self):
        self.base()
        self.write("one", title="one", like="base", set={"width": 3.0})
        self.write("two", title="two", like="one", parameters={"depth": {"value": 4, "is": "depth"}})
        self.assertEqual(casefile.names(), ["one", "two"])
        case = Case("two")
        self.assertEqual((case.values["width"], case.values["depth"], case.title), (3.0, 4, "two"))
        self.assertEqual([os.path.basename(f) for f in case.folders], ["base", "one", "two"])

    def test_refusals_name_the_file_and_the_setting(self):
        self.base()
        for content, says in (
                ({"like": "bse"}, "like: unknown case 'bse'; did you mean 'base'?"),
                ({"like": "bad"}, "cannot be like itself"),
                ({"like": "base", "set": {"widht": 1}}, "set: unknown key 'widht'; did you mean 'width'?"),
                ({"like": "base", "set": {"width": -1}}, "width = -1: must be a finite number above 0"),
                ({"like": "base", "sett": {}}, "unknown entry 'sett'; did you mean 'set'?"),
                ({"like": "base", "parameters": {"x": {"is": "x"}}}, "x: the entry 'value' is missing"),
                ({"parameters": {}}, "'end' is missing")):
            with self.subTest(says):
                os.makedirs(os.path.join(self.top, "bad"), exist_ok=True)
                path = os.path.join(self.top, "bad", "case.json")
                with open(path, "w", encoding="utf-8") as f:
                    json.dump({"title": "bad", **content}, f)
                with self.assertRaises(CaseError) as refused:
                    Case("bad")
                self.assertIn(says, str(refused.exception))
                self.assertIn(path, str(refused.exception))

    def test_a_word_or_a_number(self):
        self.base()
        self.write("one", title="one", like="base")
        case = Case("one")
        case.set("height", "2.5")
        self.assertEqual(case.values["height"], 2.5)
        case.set("height", "width")
        self.assertEqual(case.values["height"], "width")
        for wrong in ("depth", "-1", "nan"):
            with self.assertRaisesRegex(CaseError, f"height = {wrong}: must be a .*number.*or width"):
                case.set("height", wrong)

    def test_limits_are_said(self):
        self.base()
        self.write("one", title="one", like="base", parameters={
            "most": {"value": 2, "is": "a count", "min": 1, "max": 5, "whole": True},
            "share": {"value": 0.5, "is": "a share", "above": 0, "below": 1}})
        case = Case("one")
        for key, wrong, says in (("most", "6", "most = 6: must be a whole number from 1 to 5 (a count)"),
                                 ("most", "1.5", "most = 1.5: must be a whole number from 1 to 5 (a count)"),
                                 ("share", "1", "share = 1: must be a finite number above 0 and below 1 (a share)"),
                                 ("seed", "0", "seed = 0: must be a whole number of at least 1 (a number)")):
            with self.assertRaises(CaseError) as refused:
                case.set(key, wrong)
            self.assertEqual(str(refused.exception), says)


class BrokenTest(InFolder):
    """A case.json that somebody has written wrongly is one line, and hides no other case."""

    def broken(self, text):
        os.makedirs(os.path.join(self.top, "bad"), exist_ok=True)
        with open(os.path.join(self.top, "bad", "case.json"), "wb") as f:
            f.write(text)

    def test_one_line_each(self):
        self.base()
        entry = b'"is": "a number", "value": '
        for text, says in (
                (b"", "Expecting value"), (b"[]", "must be an object"), (b"\xff", "codec can't decode"),
                (b'{"title": "bad", "a": ' + 100000 * b"[" + b"}", "nested too deep"),
                (b'{"title": "bad", "like": []}', "like: must be a case's name"),
                (b'{"title": 5, "like": "base"}', "title: must be text"),
                (b'{"title": "bad", "like": "base", "set": []}', "set: must be an object"),
                (b'{"title": "bad", "like": "base", "set": {"end": "long"}}', "end = long: must be a finite number"),
                (b'{"title": "bad", "like": "base", "set": {"end": 1' + 400 * b"0" + b"}}", "too large"),
                (b'{"title": "bad", "like": "base", "set": {"end": NaN}}', "end = nan: must be a finite number"),
                (b'{"title": "bad", "like": "base", "parameters": {"end": {' + entry + b'"word"}}}',
                 "end = word: must be a finite number"),
                (b'{"title": "bad", "like": "base", "parameters": {"end": 5}}', "not iterable"),
                (b'{"title": "bad", "like": "base", "parameters": []}', "parameters: must be an object"),
                (b'{"title": "bad", "like": "base", "limits": {"end": {"most": 5}}}',
                 "limits: end: unknown entry 'most'"),
                (b'{"title": "bad", "like": "base", "limits": {"ende": {}}}', "limits: unknown key 'ende'")):
            with self.subTest(text[:60]):
                self.broken(text)
                with self.assertRaises(CaseError) as refused:
                    Case("bad")
                self.assertIn(says, str(refused.exception))
                self.assertIn(os.path.join("bad", "case.json"), str(refused.exception))
                self.assertNotIn("\n", str(refused.exception))

    def test_the_others_are_named(self):
        self.base()
        self.write("one", title="the first", like="base")
        self.broken(b"{")
        self.assertEqual(casefile.names(), ["bad", "one"])
        self.assertEqual(Case("one").title, "the first")

    def test_limits_are_narrowed(self):
        self.base()
        self.write("one", title="one", like="base", limits={"width": {"min": 1, "max": 3}})
        case = Case("one")
        case.set("width", "3")
        with self.assertRaisesRegex(CaseError, "width = 4: must be a finite number from 1 to 3"):
            case.set("width", "4")

    def test_values_that_overflow(self):
        self.base()
        self.write("one", title="one", like="base", parameters={
            "sphere_radius": {"value": 1e308, "is": "r"}, "density": {"value": 1, "is": "d"}})
        with self.assertRaisesRegex(CaseError, "do not fit together"):
            Case("one").derive(1, 1)


class UnitsTest(unittest.TestCase):
    """Values in other units than those asked for."""

    def test_are_refused_with_the_unit(self):
        for key, value, unit in (("density", "2.6", "kg/m3"), ("fluid_density", "1", "kg/m3"),
                                 ("viscosity", "0.894", "Pa s"), ("tube_radius", "16.25", "m"),
                                 ("tube_height", "150", "m"), ("fill_height", "150", "m"),
                                 ("sphere_radius", "1", "m"), ("gravity", "981", "m/s2"), ("charge", "0.393", "C"),
                                 ("cutoff", "12", "m"), ("layer_spacing", "1", "m")):
            with self.subTest(key):
                with self.assertRaisesRegex(CaseError, rf"^{key} = {value}: must be a finite number .*\d {unit}[ ,]"):
                    Case("clump-half").set(key, value)

    def test_what_the_cases_have_is_within(self):
        for name in casefile.names():
            case = Case(name)
            for key, value in case.values.items():
                case._check(key, value, value)


class ColumnTest(unittest.TestCase):
    """The columns there are."""

    def resolved(self, name, **changes):
        case = Case(name)
        for key, value in changes.items():
            case.set(key, str(value))
        return {**case.values, **suspension.resolve(case.values)}

    def test_table_of_samples(self):
        # percent by mass, solid fraction, height [m] of the full-size tube; Table 3
        for name, fraction, height in (("rp-04a", 0.0298, 0.2938), ("rp-05a", 0.0252, 0.2974),
                                       ("rp-07a", 0.0655, 0.3255), ("rp-15a", 0.0278, 0.2953)):
            v = self.resolved(name)
            volume = math.pi * 0.01625**2 * v["tube_height"]
            with self.subTest(name):
                self.assertAlmostEqual(v["fill_height"], height / 2, delta=1e-4)
                self.assertAlmostEqual(
                    v["clumps"] * 14 * 4 / 3 * math.pi * 1e-9 / volume, v["solid_fraction"], delta=1e-12)
                # a whole number of clumps
                self.assertAlmostEqual(v["solid_fraction"], fraction, delta=0.5 * fraction / v["clumps"] + 1e-4)
                self.assertTrue(9.4e-4 < v["viscosity"] < 9.9e-4)
                self.assertAlmostEqual(v["fluid_density"], 997.85, delta=0.15)

    def test_fifteen_percent(self):
        self.assertAlmostEqual(suspension.solid_fraction(15, 2600, 1000), 0.0636, delta=1e-4)
        self.assertEqual(self.resolved("clump-half", clumps="solid_fraction")["clumps"], 135)
        self.assertEqual(self.resolved("sphere-half")["spheres"], 1888)

    def test_overlaps_once(self):
        v = self.resolved("clump-half", volume="union")
        # two caps of height h = r - spacing/2 are the lens of two spheres
        r, gap = v["sphere_radius"], v["layer_spacing"]
        h = r - gap / 2
        lens = 2 * math.pi * h**2 * (3 * r - h) / 3
        self.assertAlmostEqual(suspension.particle_volume(v), 14 * 4 / 3 * math.pi * r**3 - 7 * lens, delta=1e-20)

    def test_mass_of_a_particle(self):
        sphere = 4 / 3 * math.pi * 1e-9 * 2600
        self.assertAlmostEqual(self.resolved("sphere-half")["body_mass"] / sphere, 1, delta=1e-12)
        self.assertAlmostEqual(self.resolved("clump-half")["body_mass"] / (14 * sphere), 1, delta=1e-12)
        v = self.resolved("clump-half", volume="union")
        self.assertAlmostEqual(v["body_mass"] / (2600 * suspension.particle_volume(v)), 1, delta=1e-12)

    def test_no_room(self):
        with self.assertRaisesRegex(CaseError, "fill_height = 0.2 m: must be at most tube_height = 0.15 m"):
            self.resolved("clump-half", fill_height=0.2)


class DeriveTest(unittest.TestCase):

    def test_seeds_are_primes_of_their_own(self):
        found = [casefile.prime_seed(k) for k in (*range(1, 200), 2147483647)]
        for p in found:
            self.assertTrue(10000 < p < 2**31 and all(p % k for k in range(2, math.isqrt(p) + 1)), p)
        self.assertEqual(len(set(found)), len(found))

    def test_neighbours_are_sought_as_far_as_the_spheres_are_wide(self):
        case = Case("lattice-scene")
        for radius, skin in ((5e-6, 1e-5), (1e-3, 1e-3)):
            case.set("sphere_radius", repr(radius))
            self.assertAlmostEqual(case.derive(1, 1)["neighbour_skin"], skin, delta=1e-18)
        with open(os.path.join(casefile.TOP, "cases", "common", "settings.liggghts"), encoding="utf-8") as f:
            self.assertIn("${neighbour_skin} bin", f.read())


if __name__ == "__main__":
    unittest.main()
