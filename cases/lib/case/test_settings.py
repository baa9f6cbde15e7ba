# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of a command line: what follows them, and what they cannot decide."""

import os
import tempfile
import unittest

from cases.lib.case import places, settings
from cases.lib.case.casefile import Case
from cases.lib.case.errors import CaseError


def applied(name, *words):
    case, lines = Case(name), []
    changes = settings.apply(case, settings.read(words), lines.append)
    return case, changes, lines


class SettingsTest(unittest.TestCase):

    def test_reading(self):
        self.assertEqual(settings.read(["a=1", "b = 2", "a=3"]), {"a": "3", "b": "2"})
        for wrong in ("a", "=1"):
            with self.assertRaisesRegex(CaseError, f"--set {wrong}: must have the form KEY=VALUE"):
                settings.read([wrong])

    def test_what_follows(self):
        for name, words, follows in (
                ("clump-half", ["solids=7"], {"clumps": "solid_fraction"}),
                ("clump-half", ["solid_fraction=0.05"], {"clumps": "solid_fraction"}),
                ("clump-half", ["temperature=20"], {"fluid_density": "water", "viscosity": "water"}),
                ("clump-half", ["temperature=20", "viscosity=1e-3"], {"fluid_density": "water"}),
                ("clump-half", ["temperature=20", "viscosity=water"], {"fluid_density": "water"}),
                ("clump-half", ["clumps=100", "tube_height=0.2", "fill_height=0.1", "layers=12"], {}),
                ("rp-04a", ["solids=7", "temperature=20"], {}),
                ("rp-04a", ["clumps=100"], {}),
                ("sphere-half", ["solids=7"], {})):
            case, changes, lines = applied(name, *words)
            with self.subTest(words):
                self.assertEqual(changes, {**follows, **settings.read(words)})
                self.assertEqual({k: case.values[k] for k in follows}, follows)
                self.assertEqual(lines, [", ".join(f"{k} follows: {w}" for k, w in follows.items())] if follows else [])
                # what was said goes for a run that is told all of it
                self.assertEqual(settings.follow(Case(name), changes), {})

    def test_the_run_changes(self):
        plain = Case("clump-half").derive(1, 1)
        fewer = applied("clump-half", "solids=7")[0].derive(1, 1)
        self.assertLess(fewer["solid_fraction"], 0.5 * plain["solid_fraction"])
        self.assertLess(fewer["clumps"], 65)
        self.assertAlmostEqual(applied("clump-half", "temperature=20")[0].derive(1, 1)["viscosity"], 1.002e-3,
                               delta=3e-6)

    def test_what_decides_nothing(self):
        for name, words, says in (
                ("clump-half", ["solids=7", "clumps=100"], "solids = 7 decides nothing: clumps = 100 is set, too"),
                ("clump-half", ["solid_fraction=0.3", "clumps=135"],
                 "solid_fraction = 0.3 decides nothing: clumps = 135"),
                ("sphere-half", ["solids=7", "solid_fraction=0.1"], "solids = 7 decides nothing: solid_fraction = 0.1"),
                ("sphere-half", ["solids=7", "spheres=10"], "solids = 7 decides nothing: spheres = 10"),
                ("rp-04a", ["temperature=20", "viscosity=1e-3", "fluid_density=998"],
                 "temperature = 20 decides nothing: fluid_density = 998 is set, too")):
            with self.assertRaisesRegex(CaseError, says):
                applied(name, *words)

    def test_accuracy_stands_for_others(self):
        case = applied("clump-full", "accuracy=fast")[0]
        plain = Case("clump-full").values
        self.assertEqual(case.values["coupling_steps"], 100)
        self.assertEqual((case.values["dem_step"], plain["dem_step"]), (2e-5, 1.5625e-5))
        case = applied("sphere-half", "stiffness=1e4", "accuracy=reference")[0]
        self.assertEqual((case.values["stiffness"], case.values["coupling_steps"]), (1e4, 200))
        case, changes, _ = applied("clump-half", "accuracy=balanced")
        self.assertEqual({**case.values, "accuracy": "balanced"}, Case("clump-half").values)
        self.assertEqual(changes, {"accuracy": "balanced"})
        with self.assertRaisesRegex(CaseError, "accuracy = quick: must be one of fast, balanced, reference"):
            applied("clump-half", "accuracy=quick")

    def test_folder(self):
        with tempfile.TemporaryDirectory() as top:
            self.assertTrue(os.path.isdir(settings.folder(os.path.join(top, "a", "b"))))
            path = os.path.join(top, "file")
            open(path, "w", encoding="utf-8").close()
            self.assertEqual(settings.path(None, "a"), os.path.join(places.TOP, "results", "a"))
            for wrong, says in (("", "must name a folder"), (" ", "must name a folder"),
                                (path, "is a file; name a folder"), (os.path.join(path, "b"), "Not a directory")):
                with self.assertRaisesRegex(CaseError, says):
                    settings.folder(wrong)


if __name__ == "__main__":
    unittest.main()
