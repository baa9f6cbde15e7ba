# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of the beds of validation/stress."""

import math
import unittest
from unittest import mock

from validation.lib.checks.verdicts import Broken
from validation.lib.stress import stress_beds, stress_design, stress_main


class Beds(unittest.TestCase):
    def test_each_bound_is_seen(self):
        good = {"energy": 1e-14, "moved": 1e-5, "height": 1e-5, "drop_error": 1e-3, "velocity_error": 1e-3,
                "solid_flux_error": 0.01, "fluid_flux_error": 0.01, "above": 1e-3, "momentum": 1e-14, "lost": 0}
        self.assertEqual(stress_beds.exceeded(good), [])
        for key, bad in (("energy", 2e-12), ("moved", 2e-3), ("height", 0.5), ("drop_error", 0.02),
                         ("height", math.nan), ("velocity_error", 0.04), ("solid_flux_error", 0.04),
                         ("fluid_flux_error", math.nan), ("above", 0.1), ("momentum", 1e-7), ("lost", 1)):
            found = stress_beds.exceeded({**good, key: bad})
            self.assertEqual(len(found), 1)
            self.assertIn(key, found[0])

    def test_a_bed_that_is_refused_has_failed(self):
        with mock.patch.object(stress_beds, "measure", side_effect=Broken("ERROR: the interval is too long")):
            row = stress_beds.one(stress_beds.points()[0], "nowhere")
        self.assertEqual(row["outcome"], "failed")
        self.assertIn("too long", row["reason"])

    def test_the_map_has_four_hundred_runs_of_all_states(self):
        points = stress_beds.points()
        self.assertEqual({p["bed"] for p in points}, {"rest", "jammed", "held", "frozen", "fed"})
        rest = {(p["model"], p["overlap"], p["scheme"]) for p in points if p["bed"] == "rest"}
        self.assertEqual(len(rest), 8)
        both = points + stress_design.design()
        self.assertGreaterEqual(len({stress_main.identity(p) for p in both}), 400)


if __name__ == "__main__":
    unittest.main()
