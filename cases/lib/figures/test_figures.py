# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of cases/figures: curves of the user, time scale, what is drawn."""

import json
import os
import tempfile
import types
import unittest

import numpy as np

from cases.lib.case.casefile import Case
from cases.lib.case.errors import CaseError
from cases.lib.figures import fig_samples, fig_snapshots, fig_stages, figures, labcurve, print_figure


def made_run(folder, case, knee=0.6, rest=0.05, end=64.0, seed=1):
    """A run folder with a made-up curve: a straight fall, then a slow one."""
    values = Case(case)
    v = {**values.values, **values.derive(1, 1), "end": end, "seed": seed}
    t = np.linspace(0.0, end, 1600)
    z = np.interp(t, [0, knee, 0.5 * end, end], [v["fill_height"], rest, 0.8 * rest, 0.78 * rest])
    z += 2e-5 * np.random.default_rng(seed).standard_normal(t.size)
    os.makedirs(folder)
    np.savetxt(os.path.join(folder, "settling.csv"), np.column_stack([t, z, 0.5 * z]), delimiter=",",
               header="time_s,interface_m,mean_height_m", comments="")
    with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as f:
        json.dump({"case": case, "settings": v, "reynolds_max": 800.0, "max_overlap_over_d": 0.02,
                   "particles": 14 * v["clumps"]}, f)
    return figures.Made.read(folder)


class Folder(unittest.TestCase):

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.at = lambda *names: os.path.join(place.name, *names)
        self.options = types.SimpleNamespace(quick=False, long=False, data={}, out=self.at("out"))


class LabCurveTest(Folder):

    def write(self, name, days, height):
        with open(self.at(name), "w", encoding="utf-8") as f:
            f.write("days,height_mm\n" + "".join(f"{a},{b}\n" for a, b in zip(days, height)))
        return self.at(name)

    def test_sample_of_a_file(self):
        days = np.linspace(0, 20, 15)
        path = self.write("my_RP07A.csv", days, 300 - 10 * days)
        other = self.write("curve.csv", days, 300 - 10 * days)
        found = labcurve.read([path, f"RP-15A={other}"])
        self.assertEqual(sorted(found), ["rp-07a", "rp-15a"])
        self.assertAlmostEqual(found["rp-07a"].y[-1], 1 / 3)
        self.assertFalse(found["rp-07a"].made_up)
        for words, says in (([other], "which sample"), (["rp-7=" + other], "which sample"),
                            ([path, path], "a second curve for rp-07a"), (["rp-07a=" + other + "x"], "is not there")):
            with self.assertRaisesRegex(CaseError, says):
                labcurve.read(words)

    def test_time_scale_is_found_again(self):
        run = made_run(self.at("run"), "rp-07a")
        t, z = run.curve["time_s"], run.curve["interface_m"]
        for scale in (3.3e5, 9.49e5, 2.1e6):
            days = np.linspace(0, 10 * scale / 86400, 40)
            curve = labcurve.Curve(days, np.interp(days * 86400 / scale, t, z) / run.values["fill_height"], "", False)
            found, off = labcurve.time_scale(run, curve)
            self.assertAlmostEqual(found / scale, 1.0, delta=2e-3)
            self.assertLess(off, 1e-3)


class DrawnTest(Folder):

    def check(self, number, module, made):
        fig, caption = module.draw(number, made, self.options)
        self.assertGreaterEqual(print_figure.smallest_text(fig), print_figure.SMALLEST)
        path = print_figure.save(fig, self.at("out"), f"figure-{number}", caption)
        image = print_figure.plt.imread(path)
        self.assertGreaterEqual(image.shape[1], 170 / 25.4 * 200)
        for ending in (".pdf", ".txt"):
            self.assertGreater(os.path.getsize(path[:-4] + ending), 100)
        return caption

    def test_stages(self):
        run = made_run(self.at("run"), "clump-half")
        caption = self.check(8, fig_stages, {"curve": run})
        self.assertIn("64 s = 703 days", caption)
        self.assertRegex(caption, "(two|three) stages")

    def test_samples(self):
        made = {}
        for k, sample in enumerate(labcurve.SAMPLES):
            made[sample] = made_run(self.at(sample), sample, knee=0.5 + 0.05 * k)
            made[sample + " made up"] = made_run(self.at(sample + "-m"), sample, knee=0.5 + 0.05 * k, end=11.84,
                                                 seed=1001)
        self.assertEqual(set(made), set(fig_samples.wanted(11, self.options)))
        caption = self.check(10, fig_samples, made)
        for sample in labcurve.SAMPLES:
            self.assertIn(sample.upper(), caption)
        self.assertIn("MADE-UP", self.check(11, fig_samples, made))
        self.options.data = {s: labcurve.made_up(made[s], 130.0) for s in labcurve.SAMPLES}
        for s in labcurve.SAMPLES:
            self.options.data[s] = labcurve.Curve(self.options.data[s].days, self.options.data[s].y, "data: x.csv",
                                                  False)
        self.assertEqual(set(labcurve.SAMPLES), set(fig_samples.wanted(11, self.options)))
        self.assertNotIn("MADE-UP", self.check(11, fig_samples, made))

    def test_every_run_asked_for_is_one_that_its_case_takes(self):
        for quick, long in ((False, False), (True, False), (False, True)):
            self.options.quick, self.options.long = quick, long
            for number, (_, name) in figures.FIGURES.items():
                for case, changes in figures.importlib.import_module(name).wanted(number, self.options).values():
                    one = Case(case)
                    for key, value in changes.items():
                        one.set(key, str(value))
                    self.assertGreater(one.derive(1, 1)["steps"], 0)

    def test_runs_are_shared(self):
        self.options.quick = True
        self.assertEqual(fig_samples.wanted(10, self.options)["rp-07a"],
                         fig_snapshots.wanted(6, self.options)["column"])


class ChosenTest(unittest.TestCase):

    def test_numbers(self):
        self.assertEqual(figures.chosen([]), list(figures.FIGURES))
        self.assertEqual(figures.chosen(["10", "fig2", "2"]), [2, 10])
        with self.assertRaisesRegex(CaseError, "unknown figure '12'"):
            figures.chosen(["12"])


if __name__ == "__main__":
    unittest.main()
