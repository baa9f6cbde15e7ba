# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Batch sedimentation against the tables, a Godunov solver and balances."""

import unittest

import numpy as np
import pytest

from cases.lib.theory import tables
from cases.lib.theory.flux import DragLawFlux, RichardsonZaki, TabulatedFlux
from cases.lib.theory.kynch import Kynch, lower_hull


def ramped(phi_m=0.6, ramp=0.02, exponent=4.65):
    """Richardson-Zaki with v_t = 1, falling to zero over the last `ramp`, as
    a table of 3000 straight pieces: a flux without a jump for Godunov."""
    phi = np.linspace(0.0, phi_m, 3001)
    f = phi * (1 - phi) ** exponent * np.clip((phi_m - phi) / ramp, 0.0, 1.0)
    return TabulatedFlux(phi, f)


def godunov(flux, phi_0, end, cells, minima=(), cfl=0.4):
    """phi in the cells of a column of height 1 at t = end, bottom first.

    Godunov's flux for phi_t = f_z with straight lines in the cells, limited by
    minmod (van Leer 1979, J. Comput. Phys. 32, 101-136), and Heun's steps. phi
    falls with z at all times, so that the flux through a face is the least f
    between the states at its sides: at one of them, or at one of the `minima`
    of f in between.
    """
    points = np.linspace(0.0, flux.phi_m, 20001)
    values = flux(points)
    fastest = np.max(np.abs(np.diff(values))) / points[1]
    steps = int(np.ceil(end * fastest * cells / cfl))
    ratio = end / steps * cells
    phi = np.full(cells, phi_0)
    through, half = np.zeros(cells + 1), np.zeros(cells)

    def change(phi):
        steep = np.diff(phi)
        # phi falls with z: both differences are negative or zero
        half[1:-1] = 0.5 * np.maximum(steep[1:], steep[:-1])
        below, above = (phi + half)[:-1], (phi - half)[1:]
        least = np.minimum(np.interp(below, points, values),
                           np.interp(above, points, values))
        for low in minima:
            inside = (above < low) & (below > low)
            least = np.where(inside, np.minimum(least, flux(low)), least)
        through[1:-1] = least
        return ratio * np.diff(through)

    for _ in range(steps):
        first = phi + change(phi)
        phi = 0.5 * (phi + first + change(first))
    return phi


class KynchTest(unittest.TestCase):

    def solids_differ(self, flux, phi_0, times, cells, minima=()):
        """Greatest difference of M(z, t) to Godunov's, over phi_0 H."""
        exact, worst = Kynch(flux, phi_0, 1.0), 0.0
        z = (np.arange(cells) + 1.0) / cells
        for t in times:
            found = np.cumsum(godunov(flux, phi_0, t, cells, minima)) / cells
            worst = max(worst, np.max(np.abs(
                found - exact.solids_below(z, t)[0])) / phi_0)
        return worst

    def test_formula_table(self):
        data = tables.read("kynch_batch_sedimentation_formula.csv")
        self.assertEqual(len(data["phi0"]), 5)
        for values in zip(*data.values()):
            row = dict(zip(data, values))
            k = Kynch(RichardsonZaki(1.0, 4.65, 0.6), row["phi0"], 1.0)
            self.assertEqual(k.wave_type, row["wave_type"])
            for got, column in (
                    (k.interface_speed, "V_upper_over_vt"),
                    (k.bed_wave_speed, "S_bed_over_vt"),
                    (k.t_c, "t_c_vt_over_H"), (k.y_meet, "y_meet_over_H"),
                    (k.final_height, "final_height_over_H"),
                    (k.bottom_waves[-1].phi_high, "phi_shock_end")):
                self.assertAlmostEqual(got / row[column], 1.0, delta=2e-5,
                                       msg=f"{column} at {row['phi0']}")

    def test_curves_table(self):
        data = tables.read("kynch_batch_sedimentation_curves.csv")
        cell = 1.0 / 4000.0
        for phi_0 in np.unique(data["phi0"]):
            part = {name: values[data["phi0"] == phi_0]
                    for name, values in data.items()}
            k = Kynch(RichardsonZaki(1.0, 4.65, 0.6), phi_0, 1.0)
            t = part["t_vt_over_H"]
            # the table's error: a cell until the meeting; then its settled
            # bed, and before that its bed's threshold, lag by a few cells
            upper = np.abs(k.interface(t) - part["y_upper_over_H"])
            self.assertLess(np.max(upper[t < k.t_c]), 1.5 * cell)
            self.assertLess(np.max(upper), 8 * cell, msg=f"{phi_0}")
            lower = k.bed(t) - part["y_packed_front_over_H"]
            self.assertLess(np.max(np.abs(lower)), 20 * cell, msg=f"{phi_0}")
            self.assertLess(np.max(np.abs(lower)), 0.02 * k.final_height
                            + 2 * cell, msg=f"{phi_0}")

    def check_godunov(self, flux, phi_0, parts, minima=()):
        """Difference small, and gone with the cells at about first order."""
        times = np.array(parts) * Kynch(flux, phi_0, 1.0).t_c
        coarse = self.solids_differ(flux, phi_0, times, 100, minima)
        fine = self.solids_differ(flux, phi_0, times, 400, minima)
        self.assertLess(fine, 5e-3, msg=f"{phi_0}")
        self.assertLess(fine, 0.4 * coarse, msg=f"{phi_0}")

    def test_against_godunov(self):
        # shock, then compound waves, before and after the meeting
        for phi_0 in (0.1, 0.3, 0.38):
            self.check_godunov(ramped(), phi_0, [0.5, 0.97, 1.02])

    def test_long_fan_against_godunov(self):
        flux = ramped(phi_m=0.95, ramp=0.05)
        self.check_godunov(flux, 0.3, [0.5, 1.2, 3.0])

    def test_velocity_that_rises_against_godunov(self):
        # v = f/phi is not monotone: a wave of several parts from the top too
        flux = TabulatedFlux([0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6],
                             [0.0, 0.03, 0.02, 0.09, 0.05, 0.04, 0.0])
        self.assertGreater(len(Kynch(flux, 0.35, 1.0).top_waves), 1)
        self.check_godunov(flux, 0.35, [0.5, 0.99, 1.5, 3.0], (0.2,))

    @pytest.mark.long
    def test_flux_that_jumps_against_godunov(self):
        # the paper's drag law jumps at phi = 0.2; for Godunov the jump is
        # spread over 0.002, in units of the Stokes velocity
        law = DragLawFlux("ergunWenYu", 1e-6, 1001.0, 1000.0, 1e-4)
        v_t = float(law.velocity(0.0))
        phi = np.linspace(0.0, 0.6, 301)
        spread = TabulatedFlux(
            phi, phi * law.velocity(phi) / v_t * np.clip((0.6 - phi) / 0.02,
                                                         0, 1))
        k, smooth = Kynch(law, 0.15, 1.0), Kynch(spread, 0.15, 1.0)
        self.assertAlmostEqual(k.interface_speed / v_t, 0.85**4.7, delta=1e-6)
        self.assertAlmostEqual(smooth.t_c / k.t_c / v_t, 1.0, delta=2e-3)
        self.check_godunov(spread, 0.15, [0.6, 1.05])

    def test_fan_trajectory(self):
        # the interface within the fan by the balance of solids
        for phi_0, phi_m in ((0.3, 0.6), (0.4, 0.6), (0.3, 0.9)):
            k = Kynch(RichardsonZaki(1.0, 4.65, phi_m), phi_0, 1.0)
            t, z, phi = k.fan_trajectory()
            self.assertEqual(len(phi), 200)
            np.testing.assert_allclose(k.interface(t), z, atol=1e-6)

    def test_interface_obeys_its_shock_condition(self):
        # dz/dt = -f/phi with the phi just below it: an ODE in its own right
        k = Kynch(RichardsonZaki(1.0, 4.65, 0.9), 0.3, 1.0)
        t = np.linspace(1.02 * k.t_c, 4.0 * k.t_c, 15)
        h = 1e-3
        speed = (k.interface(t + h) - k.interface(t - h)) / (2 * h)
        for time, found in zip(t, speed):
            phi = k.profile([k.interface(time) - 1e-6], time)
            self.assertAlmostEqual(found / -k.flux_law.velocity(phi)[0], 1.0,
                                   delta=2e-3)

    def test_tangents_of_compound_wave(self):
        # 4.65 phi^2 - 3.39 phi + 0.6 = 0: chord to (0.6, 0) touches f
        k = Kynch(RichardsonZaki(1.0, 4.65, 0.6), 0.3, 1.0)
        self.assertEqual([w.kind for w in k.bottom_waves],
                         ["shock", "fan", "shock"])
        root = np.max(np.roots([4.65, -3.39, 0.6]))
        self.assertAlmostEqual(k.bottom_waves[1].phi_high, root, delta=3e-4)
        exact = root * (1 - root) ** 4.65 / (0.6 - root)
        self.assertAlmostEqual(k.bottom_waves[2].speed_low / exact, 1.0,
                               delta=1e-6)
        f = Kynch(RichardsonZaki(1.0, 4.65, 1.0), 0.5, 1.0)
        self.assertEqual(f.wave_type, "fan")
        self.assertAlmostEqual(f.bed_wave_speed / (0.5**3.65 * 1.825), 1.0,
                               delta=1e-5)
        self.assertEqual(f.t_end, np.inf)

    @pytest.mark.long
    def test_balances_and_bounds(self):
        for phi_0 in (0.02, 0.3, 0.45):
            k = Kynch(RichardsonZaki(2e-3, 4.65, 0.6), phi_0, 0.15)
            self.assertEqual(float(k.interface(0.0)), 0.15)
            self.assertEqual(float(k.bed(0.0)), 0.0)
            self.assertAlmostEqual(float(k.mean_height(0.0)), 0.075)
            self.assertAlmostEqual(float(k.interface(k.t_c)), k.y_meet,
                                   delta=1e-8)
            t = np.linspace(0.0, 1.2 * k.t_end, 60)
            for function, sign in ((k.interface, -1), (k.mean_height, -1),
                                   (k.bed, 1)):
                self.assertTrue(np.all(sign * np.diff(function(t)) > -1e-9))
            self.assertTrue(np.all(k.interface(t) >= k.bed(t)))
            after, before = 1.001 * k.t_end, 0.99 * k.t_end
            self.assertAlmostEqual(float(k.bed(after)), k.final_height)
            self.assertAlmostEqual(float(k.interface(after)), k.final_height)
            self.assertGreater(k.interface(before) - k.bed(before), 1e-5)
            z = np.linspace(0.0, 0.15, 4001)
            for time in t[::7]:
                phi = k.profile(z, time)
                self.assertTrue(np.all(np.diff(phi) <= 0.0))
                total = np.sum(0.5 * (phi[1:] + phi[:-1])) * z[1]
                self.assertAlmostEqual(total / (phi_0 * 0.15), 1.0,
                                       delta=0.6 / 4000 / phi_0 * 3)
                mean = np.sum(0.5 * (phi * z)[1:] + 0.5 * (phi * z)[:-1])
                self.assertAlmostEqual(mean * z[1] / total
                                       / k.mean_height(time), 1.0, delta=5e-3)

    def test_lines_end_in_the_column(self):
        for phi_0 in (0.1, 0.3, 0.4):
            k = Kynch(RichardsonZaki(1.0, 4.65, 0.6), phi_0, 1.0)
            lines = k.characteristics(uniform=8, fan=5)
            kinds = [line.kind for line in lines]
            self.assertEqual(kinds.count("uniform"), 8)
            self.assertIn("shock", kinds)
            self.assertEqual(kinds.count("fan"), 0 if phi_0 == 0.1 else 5)
            for line in lines:
                self.assertGreater(line.t[1], 0.0)
                self.assertLessEqual(line.z[1],
                                     float(k.interface(line.t[1])) + 1e-9)
                self.assertGreaterEqual(line.z[1], -1e-12)
            for line in lines[:8]:
                # phi_0 holds all along the line
                middle = np.mean(line.t), np.mean(line.z)
                self.assertAlmostEqual(k.profile([middle[1]], middle[0])[0],
                                       phi_0)

    def test_hull(self):
        x = np.array([0.0, 1.0, 2.0, 3.0, 4.0])
        self.assertEqual(lower_hull(x, [0, 1, 0, 3, 1]).tolist(), [0, 2, 4])
        self.assertEqual(lower_hull(x, x**2).tolist(), [0, 1, 2, 3, 4])
        self.assertEqual(lower_hull(x, -x**2).tolist(), [0, 4])

    def test_bad_input(self):
        flux = RichardsonZaki(1.0)
        for phi_0, height, words in ((0.0, 1.0, "phi_0 = 0.0"),
                                     (0.7, 1.0, "phi_0 = 0.7"),
                                     (0.1, 0.0, "height = 0.0")):
            with self.assertRaisesRegex(ValueError, words):
                Kynch(flux, phi_0, height)
        with self.assertRaisesRegex(ValueError, "t = -1"):
            Kynch(flux, 0.1, 1.0).interface(-1.0)


if __name__ == "__main__":
    unittest.main()
