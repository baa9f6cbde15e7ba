# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Packings: all in the tube, none overlapping, as many as asked, and what is
said when they do not fit."""

import contextlib
import io
import json
import math
import os
import shutil
import subprocess
import tempfile
import unittest
from unittest import mock

import numpy as np
import pytest

from cases.lib.case import cache
from cases.lib.case.casefile import Case, TOP
from cases.lib.case.errors import CaseError
from cases.lib.case.suspension import particle_volume, resolve
from cases.lib.packing import pack_box, pack_expansion, pack_main, pack_packmol, pack_random, pack_shapes, packing

R = 1e-3
PLATE, SPHERE = pack_shapes.plate(R, R), pack_shapes.single(R)
TUBE = pack_shapes.Tube(0.01, 0.04)


def quiet(_):
    """Progress that nobody sees."""


def number(shape, solid_fraction, tube=TUBE):
    return round(solid_fraction * math.pi * tube.radius**2 * tube.height
                 / (len(shape.centres) * 4 / 3 * math.pi * shape.radius**3))


def brute(shape, x, q):
    """Largest overlap by looking at every two spheres."""
    p, n = shape.spheres(x, q), len(shape.centres)
    d = np.linalg.norm(p[:, None] - p[None], axis=2)
    body = np.arange(len(p)) // n
    return max(0.0, 2 * shape.radius - d[body[:, None] != body[None]].min())


class BoxTest(unittest.TestCase):
    """Spheres in boxes with periodic sides and with walls."""

    def test_apart_inside_and_even(self):
        size = [8e-3, 8e-3, 24e-3]
        for fraction, cyclic in ((0.05, True), (0.3, False), (0.5, True)):
            count = round(fraction * 8 * 8 * 24 / (np.pi / 6))
            x = pack_box.place(5e-4, count, size, cyclic, 3, lambda _: None)
            self.assertEqual(x.shape, (count, 3))
            self.assertLess(pack_box.overlap(x, 5e-4, size, cyclic), 1e-9)
            self.assertTrue(np.all((x[:, 2] > 5e-4 - 1e-9) & (x[:, 2] < size[2] - 5e-4 + 1e-9)))
            if not cyclic:
                self.assertTrue(np.all((x[:, :2] > 5e-4 - 1e-9) & (x[:, :2] < 8e-3 - 5e-4 + 1e-9)))
            layers = np.histogram(x[:, 2], bins=4, range=(0, size[2]))[0]
            self.assertLess(np.ptp(layers), 0.2 * count / 4)

    def test_too_many(self):
        with self.assertRaises(pack_shapes.NotPacked):
            pack_box.place(5e-4, round(0.75 * 216 / (np.pi / 6)), [6e-3] * 3, True, 1, lambda _: None)


class ShapeTest(unittest.TestCase):

    def test_plate(self):
        self.assertEqual(PLATE.centres.shape, (14, 3))
        np.testing.assert_allclose(PLATE.centres.mean(axis=0), 0, atol=1e-18)
        self.assertAlmostEqual(PLATE.reach / R, 1 + math.hypot(2, 0.5), places=12)

    def test_turning(self):
        rng = np.random.default_rng(3)
        q = pack_shapes.random_turns(rng, 20)
        m = pack_shapes.rotations(q)
        np.testing.assert_allclose(m @ m.transpose(0, 2, 1), np.tile(np.eye(3), (20, 1, 1)), atol=1e-14)
        np.testing.assert_allclose(np.linalg.det(m), 1, atol=1e-14)
        # a quarter about z, after q: x goes to y
        quarter = pack_shapes.rotations(pack_shapes.turned(q, np.tile([0, 0, math.pi / 2], (20, 1))))
        np.testing.assert_allclose(quarter[:, 1], m[:, 0], atol=1e-14)
        back = pack_packmol._quaternions(m)
        np.testing.assert_allclose(np.abs((back * q).sum(1)), 1, atol=1e-14)

    def test_overlaps_are_found(self):
        x = np.array([[0, 0, 0], [0, 0, 2.5e-3]])
        q = np.tile([1.0, 0, 0, 0], (2, 1))
        depth, pairs = pack_shapes.overlaps(PLATE, x, q)
        self.assertAlmostEqual(depth / R, 0.5)
        self.assertEqual(set(map(tuple, pairs.tolist())), {(0, 1)})

    def test_volume(self):
        v = {"sphere_radius": R, "clumps": 1, "layer_spacing": R, "volume": "sum"}
        ball = 4 / 3 * math.pi * R**3
        self.assertAlmostEqual(particle_volume(v) / ball, 14, places=12)
        # two spheres a radius apart: 27/16 of one
        self.assertAlmostEqual(particle_volume({**v, "volume": "union"}) / ball, 7 * 27 / 16, places=12)
        # against points thrown at random
        p = np.random.default_rng(1).uniform(-1, 1, (400000, 3)) * [3.1 * R, 3.1 * R, 1.6 * R]
        d = np.min([((p - c)**2).sum(1) for c in PLATE.centres], axis=0)
        found = (d < R * R).mean() * 8 * 3.1 * 3.1 * 1.6 * R**3
        self.assertAlmostEqual(found / particle_volume({**v, "volume": "union"}), 1, delta=0.01)


class MethodTest(unittest.TestCase):

    def check(self, shape, x, q, count, tube=TUBE):
        self.assertEqual(x.shape, (count, 3))
        np.testing.assert_allclose(np.linalg.norm(q, axis=1), 1, atol=1e-12)
        self.assertEqual(pack_shapes.overlaps(shape, x, q)[0], 0)
        self.assertLessEqual(tube.beyond(shape.spheres(x, q), shape.radius).max(), 1e-6 * R)

    @pytest.mark.long
    def test_random(self):
        for shape, fraction in ((SPHERE, 0.01), (SPHERE, 0.25), (PLATE, 0.01), (PLATE, 0.15)):
            with self.subTest(spheres=len(shape.centres), solid_fraction=fraction):
                n = number(shape, fraction)
                x, q = pack_random.place(shape, n, TUBE, 1, quiet)
                self.check(shape, x, q, n)
                self.assertEqual(brute(shape, x, q), 0)

    @pytest.mark.long
    def test_expansion(self):
        for shape, fraction in ((SPHERE, 0.01), (SPHERE, 0.45), (PLATE, 0.06), (PLATE, 0.40)):
            with self.subTest(spheres=len(shape.centres), solid_fraction=fraction):
                n = number(shape, fraction)
                x, q = pack_expansion.place(shape, n, TUBE, 1, quiet, fraction)
                self.check(shape, x, q, n)

    def test_packmol(self):
        for shape, fraction in ((SPHERE, 0.10), (PLATE, 0.10)):
            with self.subTest(spheres=len(shape.centres), solid_fraction=fraction), \
                    tempfile.TemporaryDirectory() as folder:
                n = number(shape, fraction)
                kinds = ["a", "b", "b"] * n
                kinds = kinds[:n]
                x, q = pack_packmol.place(shape, kinds, TUBE, 1, quiet, folder)
                self.check(shape, x, q, n)
                with open(os.path.join(folder, "packmol.log"), encoding="utf-8") as f:
                    self.assertIn("Success!", f.read())
                # its own coordinates, kind by kind, are those of the places
                rows = np.loadtxt(os.path.join(folder, "packmol.xyz"), skiprows=2, usecols=(1, 2, 3)) * R
                order = np.argsort(kinds, kind="stable")
                np.testing.assert_allclose(shape.spheres(x[order], q[order]), rows, atol=2e-6 * R)

    @pytest.mark.long
    def test_seeds(self):
        n = number(PLATE, 0.08)
        places = {
            "random": lambda s: pack_random.place(PLATE, n, TUBE, s, quiet),
            "expansion": lambda s: pack_expansion.place(PLATE, n, TUBE, s, quiet, 0.08),
            "packmol": lambda s: pack_packmol.place(PLATE, ["a"] * n, TUBE, s, quiet, self.folder)}
        for method, place in places.items():
            with self.subTest(method=method), tempfile.TemporaryDirectory() as self.folder:
                one, again, other = place(1), place(1), place(2)
                np.testing.assert_array_equal(one[0], again[0])
                np.testing.assert_array_equal(one[1], again[1])
                self.assertGreater(np.abs(one[0] - other[0]).max(), R)

    def test_directions_are_even(self):
        # the plates' axes: no direction preferred, on average of their squares
        tube = pack_shapes.Tube(0.02, 0.1)
        n = number(PLATE, 0.12, tube)
        with tempfile.TemporaryDirectory() as folder:
            found = {"random": pack_random.place(PLATE, n, tube, 5, quiet),
                     "expansion": pack_expansion.place(PLATE, n, tube, 5, quiet, 0.12),
                     "packmol": pack_packmol.place(PLATE, ["a"] * n, tube, 5, quiet, folder)}
        for method, (_, q) in found.items():
            with self.subTest(method=method):
                axis = pack_shapes.rotations(q)[:, :, 2]
                np.testing.assert_allclose((axis**2).mean(axis=0), 1 / 3, atol=4 * math.sqrt(4 / 45 / n))

    @pytest.mark.long
    def test_not_packed(self):
        with mock.patch.object(pack_random, "_IN_VAIN", 8000), self.assertRaises(pack_shapes.NotPacked) as e:
            pack_random.place(PLATE, number(PLATE, 0.45), TUBE, 1, quiet)
        self.assertTrue(0.15 < 0.45 * e.exception.share < 0.35)
        with mock.patch.object(pack_expansion, "_STEPS", 300), self.assertRaises(pack_shapes.NotPacked) as e:
            pack_expansion.place(SPHERE, number(SPHERE, 0.75), TUBE, 1, quiet, 0.75)
        self.assertTrue(0.45 < 0.75 * e.exception.share < 0.65)
        with mock.patch.object(pack_packmol, "_LOOPS", 2), tempfile.TemporaryDirectory() as folder, \
                self.assertRaises(pack_shapes.NotPacked) as e:
            pack_packmol.place(PLATE, ["a"] * number(PLATE, 0.50), TUBE, 1, quiet, folder)
        self.assertTrue(0.15 < 0.50 * e.exception.share < 0.45)

    def test_a_tube_too_narrow(self):
        narrow = pack_shapes.Tube(1.2 * R, 0.04)
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        for place in (lambda: pack_random.place(PLATE, 1, narrow, 1, quiet),
                      lambda: pack_packmol.place(PLATE, ["a", "a"], narrow, 1, quiet, folder),
                      lambda: pack_random.place(SPHERE, 1, pack_shapes.Tube(0.5 * R, 0.04), 1, quiet)):
            with self.assertRaises(pack_shapes.NotPacked) as e:
                place()
            self.assertEqual(e.exception.share, 0)


class FilesTest(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        # a store of its own
        patch = mock.patch.object(cache, "TOP", self.folder)
        patch.start()
        self.addCleanup(patch.stop)
        self.out = os.path.join(self.folder, "run")
        os.mkdir(self.out)

    def values(self, name="clump-half", **changes):
        case = Case(name)
        for key, value in changes.items():
            case.set(key, str(value))
        return {**case.values, **resolve(case.values)}

    def write(self, v):
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            report = packing.write(self.out, v)
        return report, said.getvalue()

    def test_clumps_from_a_solid_fraction(self):
        v = self.values(clumps="solid_fraction", solid_fraction=0.04, fill_height=0.1, illite_share=0.25, seed=3)
        report, said = self.write(v)
        self.assertEqual(said.count("\n"), 1)
        self.assertIn("solid fraction 0.04", said)
        self.assertAlmostEqual(report["solid_fraction"], 0.04, delta=4e-4)
        self.assertEqual((report["method"], report["seed"], report["overlap"], report["beyond_tube"]),
                         ("random", 3, 0, 0))
        with open(os.path.join(self.out, "packing.json"), encoding="utf-8") as f:
            self.assertEqual(json.load(f), report)
        kinds, x, q = packing.read_places(os.path.join(self.out, "packing.places"))
        self.assertEqual(len(kinds), report["count"])
        self.assertEqual(kinds.count("ill"), round(0.25 * report["count"]))
        shape = packing.shape_of(v)
        self.assertLess(pack_shapes.overlaps(shape, x, q)[0], 1e-12)
        self.assertLess(shape.spheres(x, q)[:, 2].max(), 0.1 - R)
        with open(os.path.join(self.out, "packing.liggghts"), encoding="utf-8") as f:
            self.assertIn("fix put all insert/placed file packing.places templates ill kao\n", f.read())

    def test_spheres_and_the_store(self):
        v = self.values("sphere-half", solid_fraction=0.02)
        first, _ = self.write(v)
        with open(os.path.join(self.out, "packing.places"), encoding="utf-8") as f:
            rows = f.read()
        self.assertTrue(all(len(r.split()) == 4 for r in rows.splitlines()[2:]))
        with mock.patch.object(packing, "_place", side_effect=AssertionError("packed again")):
            again, said = self.write(v)
        self.assertEqual(first, again)
        self.assertIn("kept from before", said)

    def test_packmol_leaves_its_words(self):
        report, _ = self.write(self.values(packing="packmol", clumps=20))
        self.assertEqual(report["method"], "packmol")
        for name in ("packmol.inp", "packmol.log", "packmol.xyz", "ill.xyz", "kao.xyz"):
            self.assertTrue(os.path.isfile(os.path.join(self.out, "packmol", name)), name)

    @pytest.mark.long
    def test_refusal(self):
        v = self.values(clumps="solid_fraction", solid_fraction=0.5, tube_radius=0.01, tube_height=0.03)
        with mock.patch.object(pack_random, "_IN_VAIN", 8000), self.assertRaisesRegex(
                CaseError, r"^clumps = \d+, solid_fraction = 0\.[45]\d*: packing = random reached 0\.[123]\d* at most "
                           r"\(none of the last \d+ places tried was free\); take less, or packing = expansion$"):
            self.write(v)
        self.assertFalse(os.path.exists(os.path.join(self.out, "packing.places")))
        self.assertEqual([n for n in os.listdir(os.path.join(self.folder, "build", "packings"))
                          if not n.endswith(".lock")], [])

    def test_packmol_missing(self):
        with mock.patch.object(pack_packmol, "PROGRAM", "no-such-packmol"), \
                self.assertRaisesRegex(CaseError, "Debian's package packmol has it"):
            self.write(self.values(packing="packmol", clumps=20))

    def test_to_look_at(self):
        v = self.values(clumps=10)
        report, _ = self.write(v)
        s = pack_main.points(self.out, v)
        self.assertEqual(len(s["x"]), 140)
        pack_main.draw(self.out, v, report)
        for name in ("packing.png", "packing.vtu"):
            self.assertGreater(os.path.getsize(os.path.join(self.out, name)), 5000)


class CommandTest(unittest.TestCase):

    def test_folders_that_are_taken(self):
        with tempfile.TemporaryDirectory() as out:
            def put(*names):
                for name in names:
                    open(os.path.join(out, name), "w", encoding="utf-8").close()
            os.makedirs(os.path.join(out, "packmol"))  # of a packing that failed
            pack_main._clear(out)
            put("packing.json", "packing.places", "packing.png")
            pack_main._clear(out)
            self.assertFalse(os.path.exists(os.path.join(out, "packing.png")))
            put("case.txt")
            with self.assertRaisesRegex(CaseError, "is the folder of a run"):
                pack_main._clear(out)
        with tempfile.TemporaryDirectory() as out:
            put("packing.places", "notes")
            with self.assertRaisesRegex(CaseError, "other things than a packing"):
                pack_main._clear(out)

    def test_wrong_words(self):
        for words, says in ((["clump-half", "--set", "packing=tight"], "packing = tight: must be one of"),
                            (["clump-halve"], "did you mean 'clump-half'?"),
                            (["clump-half", "--set", "seed"], "--set seed: must have the form KEY=VALUE"),
                            (["clump-half", "--out", os.path.join(TOP, "cases")], "holds other things than a packing")):
            run = subprocess.run([os.path.join(TOP, "cases", "pack"), "--no-setup", *words],
                                 capture_output=True, text=True, timeout=60)
            self.assertEqual(run.returncode, 2)
            self.assertIn(says, run.stderr)
            self.assertEqual(run.stderr.count("\n"), 1)


if __name__ == "__main__":
    unittest.main()
