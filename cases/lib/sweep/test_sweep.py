# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The grid, the table and the picture of a sweep, with made-up curves."""

import contextlib
import csv
import io
import json
import os
import sys
import tempfile
import textwrap
import unittest
from unittest import mock

import pytest

from cases.lib.case import program
from cases.lib.case.casefile import Case
from cases.lib.case.errors import CaseError
from cases.lib.run import runkey, runs
from cases.lib.sweep import sweep

# argv: folder, charge, seed; stages whose slopes [m/s] follow from the charge
SCRIPT = textwrap.dedent("""
    import os, sys
    folder, charge, seed = sys.argv[1], float(sys.argv[2]) * 1e10, int(sys.argv[3])
    if charge > 8:
        sys.exit("ERROR: particles fly")
    os.makedirs(folder)
    knots = [(0, 0.15), (1, 0.05 + 0.005 * charge), (4, 0.03), (7, 0.027 + 1e-4 * seed)]
    with open(os.path.join(folder, "settling.csv"), "w") as f:
        f.write("time_s,interface_m\\n")
        for i in range(351):
            t = i * 0.02
            a, b = next((a, b) for a, b in zip(knots, knots[1:]) if t <= b[0])
            f.write(f"{t},{a[1] + (b[1] - a[1]) * (t - a[0]) / (b[0] - a[0])}\\n")
    with open(os.path.join(folder, "summary.json"), "w") as f:
        f.write('{"complete": true}')
    """)


class SweepTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.top, self.made = folder.name, []
        store = runs.Store

        def stand_in(*_, **more):
            def command(name, changes, out):
                self.made.append(changes)
                return [sys.executable, "-c", SCRIPT, out, str(changes["charge"]), str(changes.get("seed", 1))]
            return store(os.path.join(self.top, "runs"), tell=lambda line: None, command=command, **more)
        for patch in (mock.patch.object(runkey, "programs", lambda: {}), mock.patch.object(runs, "Store", stand_in)):
            patch.start()
            self.addCleanup(patch.stop)

    def sweep(self, *words):
        out = os.path.join(self.top, "out")
        said, errors = io.StringIO(), io.StringIO()
        with mock.patch.object(sys, "argv", ["sweep", "clump-half", "--out", out, *words]), \
                contextlib.redirect_stdout(said), contextlib.redirect_stderr(errors):
            status = program.guarded(sweep.main, "cases/sweep")
        return status, said.getvalue(), errors.getvalue(), out

    @pytest.mark.long
    def test_table_json_and_picture(self):
        status, said, _, out = self.sweep("--set", "charge=2e-10,4e-10", "--set", "end=7", "--seeds", "2")
        self.assertEqual(status, 0)
        with open(os.path.join(out, "sweep.json"), encoding="utf-8") as f:
            found = json.load(f)
        self.assertEqual(found["varied"], ["charge"])
        self.assertEqual([(p["parameters"]["charge"], p["parameters"]["seed"]) for p in found["points"]],
                         [("2e-10", "1"), ("2e-10", "2"), ("4e-10", "1"), ("4e-10", "2")])
        for p in found["points"]:
            q, seed = 1e10 * float(p["parameters"]["charge"]), int(p["parameters"]["seed"])
            s = p["stages"]
            self.assertEqual(s["count"], 3)
            for slope, (low, high), truth in zip(
                    s["slopes_m_per_s"], s["slopes_ci"],
                    (-0.1 + 0.005 * q, -(0.02 + 0.005 * q) / 3, -(0.003 - 1e-4 * seed) / 3)):
                self.assertAlmostEqual(slope, truth, delta=0.03 * abs(truth))
                self.assertLessEqual(low, high)
            self.assertAlmostEqual(s["breaks_s"][0], 1, delta=0.02)
            self.assertAlmostEqual(p["interface_end_m"], 0.027 + 1e-4 * seed)
            self.assertTrue(os.path.isdir(p["folder"]))
            self.assertGreater(p["wall_s"], 0)
        with open(os.path.join(out, "sweep.csv"), encoding="utf-8", newline="") as f:
            rows = list(csv.DictReader(f))
        self.assertEqual(len(rows), 4)
        self.assertAlmostEqual(float(rows[0]["slope_1_m_per_s"]), -0.09, delta=0.002)
        self.assertEqual(rows[3]["stages"], "3")
        with open(os.path.join(out, "sweep.png"), "rb") as f:
            self.assertEqual(f.read(4), b"\x89PNG")
        self.assertIn("slope 2", said)

        # all are there now; a further value costs its own runs only
        self.assertEqual(len(self.made), 4)
        self.sweep("--set", "charge=2e-10,4e-10,3e-10", "--set", "end=7", "--seeds", "2")
        self.assertEqual(len(self.made), 6)

    def test_a_failed_point_does_not_stop_the_others(self):
        status, said, errors, out = self.sweep("--set", "charge=9e-10,1e-10")
        self.assertEqual(status, 1)
        self.assertIn("failed", said)
        self.assertIn("charge=9e-10 failed: ERROR: particles fly", errors)
        self.assertTrue(os.path.isfile(os.path.join(out, "sweep.png")))
        with open(os.path.join(out, "sweep.json"), encoding="utf-8") as f:
            bad, good = json.load(f)["points"]
        self.assertIn("particles fly", bad["error"])
        self.assertEqual((good["error"], good["stages"]["count"]), ("", 3))

    @pytest.mark.long
    def test_dry_run(self):
        self.sweep("--set", "charge=1e-10")
        said = self.sweep("--set", "charge=1e-10,2e-10", "--dry-run")[1]
        self.assertEqual([line.split("  ")[0] for line in said.splitlines()], ["there", "to run"])
        self.assertEqual(len(self.made), 1)

    def test_grid(self):
        made, varied, extra = sweep.points("clump-half", ["charge=1e-10,2e-10", "end=1", "friction=0.1,0.2,0.3"])
        self.assertEqual((len(made), varied, extra), (6, ["charge", "friction"], {}))
        self.assertEqual(made[1], {"charge": "1e-10", "end": "1", "friction": "0.2"})
        self.assertEqual(sweep.points("clump-half", ["seed=1,2"])[1], ["seed"])

    def test_every_key_of_the_requirement_changes_the_run(self):
        case = Case("clump-half")
        for key, value in (("charge", "1e-10"), ("cutoff", "0.006"), ("solids", "5"), ("friction", "0.1"),
                           ("stiffness", "500"), ("illite_share", "0.2")):
            made, _, extra = sweep.points("clump-half", [f"{key}={value}"])
            changed = Case("clump-half")
            for k, v in made[0].items():
                changed.set(k, v)
            self.assertNotEqual(changed.values[key], case.values[key])
            if key == "solids":  # the number of clumps has to follow
                self.assertEqual(extra, {"clumps": "solid_fraction"})
                self.assertLess(changed.derive(1, 1)["clumps"], 60)

    def test_guarded(self):
        def fails(error):
            def work():
                raise error
            return work
        for error, said in ((OSError("no room"), "x: no room"),
                            (FileNotFoundError(2, "not there", "f"), "x: f: not there"),
                            (CaseError("wrong"), "x: wrong")):
            errors = io.StringIO()
            with contextlib.redirect_stderr(errors):
                self.assertEqual(program.guarded(fails(error), "x"), 2)
            self.assertEqual(errors.getvalue(), said + "\n")
        with self.assertRaises(ValueError):  # a mistake of the program's own
            program.guarded(fails(ValueError("?")), "x")

    @pytest.mark.long
    def test_bad_input(self):
        for words, said in ((("--set", "charge"), "must have the form KEY=A,B,C"),
                            (("--set", "charge=1e-10,"), "must have the form KEY=A,B,C"),
                            (("--set", "charge=1e-10,1e-10"), "there twice"),
                            (("--set", "charg=1e-10"), "did you mean 'charge'"),
                            (("--set", "charge=1e-10,much"), "must be a number"),
                            (("--set", "seed=1,2", "--seeds", "2"), "take one of them"),
                            (("--set", "solids=5,7", "--set", "clumps=9"), "solids = 5 decides nothing"),
                            (("--set", "seed=2147483648"), "from 1 to 2147483647"),
                            (("--set", "charge=1e-10", "--seeds", "0"), "--seeds 0"),
                            (("--set", "charge=1e-10", "--jobs", "0"), "--jobs 0")):
            status, _, errors, _ = self.sweep(*words)
            self.assertEqual(status, 2)
            self.assertIn(said, errors)
            self.assertEqual(errors.count("\n"), 1)
        with self.assertRaisesRegex(CaseError, "at most 10000"):
            sweep.points("clump-half", ["seed=" + ",".join(map(str, range(1, 102))),
                                        "end=" + ",".join(map(str, range(1, 102)))])


if __name__ == "__main__":
    unittest.main()
