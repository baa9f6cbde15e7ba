# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of validation/stress: the sample, the scenes, the bounds, reasons."""

import itertools
import math
import os
import tempfile
import unittest

import numpy as np
import pytest

from validation.lib.stress import stress_bounds, stress_main, stress_run
from validation.lib.stress import stress_design as design


class Sample(unittest.TestCase):
    def test_it_covers_what_was_asked_for(self):
        points = design.design()
        self.assertGreaterEqual(len(points), 300)
        self.assertEqual(len({stress_main.identity(p) for p in points}), len(points))
        for key, (low, high) in design.AXES.items():
            values = [p[key] for p in points]
            self.assertAlmostEqual(max(values) / high, 1, msg=key)
            self.assertAlmostEqual(min(v for v in values if v) / low, 1, msg=key)
        for key, words in design.WORDS.items():
            self.assertEqual({p[key] for p in points}, set(words))
        # intervals that are reached, not only asked for
        reached = [design.scene(p)["interval_ratio"] for p in points]
        self.assertGreater(max(reached), 9e3)
        self.assertGreater(sum(r > 10 for r in reached), 20)

    def test_the_sample_fills_the_space(self):
        points = design.latin(64)
        for key in ("viscosity", "stiffness", "solids"):
            low, high = design.AXES[key]
            u = [math.log(p[key] / low) / math.log(high / low) for p in points]
            self.assertEqual(list(np.histogram(u, 8, (0, 1))[0]), 8 * [8])
        self.assertEqual(points, design.latin(64))
        # no two axes go together
        keys = ("viscosity", "stiffness", "solids", "cell", "diameter")
        u = np.array([[math.log(p[k]) for k in keys] for p in design.latin(128)])
        c = np.corrcoef(u.T) - np.eye(5)
        self.assertLess(abs(c).max(), 0.25)

    @pytest.mark.long
    def test_a_short_map_has_all_parts(self):
        points = design.design(30)
        self.assertLessEqual(abs(len(points) - 30), 1)
        self.assertEqual({p["shape"] for p in points}, {"spheres", "clumps"})

    def test_particles_lie_apart_and_inside(self):
        for p in design.design(120):
            scene = design.scene(p)
            v, d = scene["values"], p["diameter"]
            size = (v["size_x"], v["size_y"], v["size_z"])
            half = (0.5, 0.5, 0.5) if p["shape"] == "spheres" else (1.5, 1.5, 0.75)
            for at in (a for _, a in scene["places"]):
                for axis in range(3):
                    if axis == 2 or p["sides"] != "cyclic":
                        self.assertGreaterEqual(at[axis], half[axis] * d * (1 - 1e-9))
                        self.assertLessEqual(at[axis], size[axis] - half[axis] * d * (1 - 1e-9))
            if p["shape"] == "spheres":
                x = np.array([a for _, a in scene["places"]])
                for i, j in itertools.combinations(range(min(len(x), 40)), 2):
                    self.assertGreater(np.linalg.norm(x[i] - x[j]), 0.999 * d)
            self.assertGreaterEqual(v["coupling_steps"], 1)
            self.assertLessEqual(scene["solids"], 1.05 * p["solids"])

    def test_limits(self):
        # undamped it would be sqrt(2 m/k)
        step = design.contact_limit(1000, 1e-5)
        self.assertLess(step, math.sqrt(2 * 1e-5 / 1000))
        self.assertGreater(step, 0.5 * math.sqrt(2 * 1e-5 / 1000))
        # Stokes: d2 (rho - rho_f) g/(18 mu)
        self.assertAlmostEqual(design.terminal_velocity(1e-5, 2600, 1e-3) / (1e-10 * 1600 * 9.81 / 18e-3), 1,
                               delta=0.01)


class Bounds(unittest.TestCase):
    scene = design.scene(design.PLAIN)
    good = {"overlap_over_d": 0.01, "courant": 0.5, "momentum": 1e-14, "volume_error": 1e-15, "fastest": 0.1,
            "fluid": 0.1, "void_fraction": [0.5, 1.0], "lost": 0}

    def test_each_is_seen(self):
        self.assertEqual(stress_bounds.exceeded(self.good, self.scene), [])
        for key, bad, says in (("overlap_over_d", 0.6, "overlap/d 0.6 is above 0.5"), ("courant", 9.0, "Courant"),
                               ("momentum", 1e-3, "momentum"), ("volume_error", 1e-3, "volume error"),
                               ("fastest", 99.0, "particle speed"), ("fluid", 99.0, "fluid speed"),
                               ("fastest", math.nan, "is NaN"), ("void_fraction", [-0.1, 1.0], "not within 0 and 1"),
                               ("void_fraction", [0.5, 1.1], "not within"), ("lost", 2, "2 spheres were lost")):
            found = stress_bounds.exceeded({**self.good, key: bad}, self.scene)
            self.assertEqual(len(found), 1, key)
            self.assertIn(says, found[0])

    def test_what_can_drive_a_particle(self):
        jet = design.scene({**design.PLAIN, "jump": 50.0})
        self.assertGreater(stress_bounds.speed_scale(jet), 50 * jet["terminal"])
        charged = design.scene({**design.PLAIN, "charge_factor": 30.0})
        self.assertGreater(stress_bounds.speed_scale(charged), 2 * stress_bounds.speed_scale(self.scene))


class Ends(unittest.TestCase):
    def judged(self, status, why):
        with tempfile.TemporaryDirectory() as place:
            return stress_run.judge({}, status, why, Bounds.scene, place)["outcome"]

    def test_outcomes(self):
        self.assertEqual(self.judged(None, ""), "failed")
        self.assertEqual(self.judged(1, "ERROR: timestep 1 s is above 0.1 s"), "refused")
        for why in ("", "mpirun noticed that process rank 0 exited on signal 11", "U (nan nan 0)",
                    "particle 3 is NaN at step 7", "particle 3 came with NaN or infinity at time 0 s"):
            self.assertEqual(self.judged(1, why), "failed", why)

    def test_the_cause_is_told_from_the_aftermath(self):
        lines = ["[1,1]<stderr>:clayFoam: stopped: the DEM half ended before the coupled run did",
                 "[1,0]<stdout>:ERROR: Fix couple/foam: particle 7 was pushed out of the box",
                 "mpirun noticed that process rank 1 ended"]
        self.assertIn("particle 7", stress_run.reason(lines))
        self.assertIn("mpirun noticed", stress_run.reason(lines[2:]))

    def test_a_map_goes_on(self):
        with tempfile.TemporaryDirectory() as place:
            path = os.path.join(place, "runs.jsonl")
            with open(path, "w", encoding="utf-8") as f:
                f.write('{"version": "a", "id": "x", "outcome": "bounded"}\n{"version": "b", "id": "y"}\n'
                        '{"version": "a", "i')
            self.assertEqual(stress_main.kept(path, "a"), {"x": {"id": "x", "outcome": "bounded"}})
            self.assertEqual(stress_main.kept(path + ".gone", "a"), {})

    def test_the_page_gets_the_counts(self):
        with tempfile.TemporaryDirectory() as place:
            path = os.path.join(place, "page.md")
            with open(path, "w", encoding="utf-8") as f:
                f.write("a\n<!-- last map -->\nold\n<!-- end of last map -->\nb\n")
            for _ in range(2):
                stress_main.record("3 runs", path)
            with open(path, encoding="utf-8") as f:
                page = f.read()
            self.assertEqual(page, "a\n<!-- last map -->\n\n```\n3 runs\n```\n\n<!-- end of last map -->\nb\n")

    def test_reasons_are_counted_without_numbers(self):
        self.assertEqual(stress_main.kind("step 1.5e-05 s of particle 7"), stress_main.kind("step 3 s of particle 12"))


if __name__ == "__main__":
    unittest.main()
