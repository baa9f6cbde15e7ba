# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Large-strain consolidation against Terzaghi's series, the linear form of Gibson, Schiffman and Cargill (1981,
Can. Geotech. J. 18, 280-293) and its exact solution, rest, and Kynch's limit."""

from dataclasses import dataclass

import numpy as np
import pytest
from scipy.optimize import brentq

from cases.lib.theory import gibson


@dataclass(frozen=True)
class Linear:
    """s = modulus (e0 - e), one mobility."""

    e0: float
    modulus: float
    m: float

    def void_ratio(self, stress):
        return self.e0 - stress / self.modulus

    def stress(self, e):
        return self.modulus * (self.e0 - e)

    def stiffness(self, e):
        return np.full_like(e, self.modulus)

    def mobility(self, e):
        return np.full_like(np.asarray(e, dtype=float), self.m)

    def steepness(self, e):
        return np.zeros_like(e)


@dataclass(frozen=True)
class Exponential:
    """e = (e00 - end) exp(-rate s) + end and g = -mobility ds/de one number: Gibson's equation is linear then,
    u_t = g u_zz - g rate weight u_z of u = e - end."""

    e00: float
    end: float
    rate: float
    g: float

    def void_ratio(self, stress):
        return (self.e00 - self.end) * np.exp(-self.rate * stress) + self.end

    def stress(self, e):
        return -np.log((e - self.end) / (self.e00 - self.end)) / self.rate

    def stiffness(self, e):
        return 1.0 / (self.rate * (e - self.end))

    def mobility(self, e):
        return self.g * self.rate * (e - self.end)

    def steepness(self, e):
        return 1.0 / (e - self.end)


def exact(laws, length, weight, z, times, terms=400):
    """u = e - end of the linear form: even at the start, e00 at the top, no flux at the floor; shape (m, k).

    With u = exp(beta z) w, beta = rate weight/2, w falls by exp(-g (nu^2 + beta^2) t) in sin(nu (length - z)),
    tan(nu length) = -nu/beta; at rest u = u0 exp(-2 beta (length - z)).
    """
    beta, u0 = 0.5 * laws.rate * weight, laws.e00 - laws.end
    roots = np.array([brentq(lambda x: np.sin(x) * beta * length + x * np.cos(x), (k + 0.5) * np.pi + 1e-9,
                             (k + 1) * np.pi + (0 if k else 0) - 1e-12) for k in range(terms)]) / length
    x = np.linspace(0, length, 40001)
    apart = u0 * (1 - np.exp(-2 * beta * (length - x))) * np.exp(-beta * x)
    found = np.tile(u0 * np.exp(-2 * beta * (length - z)), (len(times), 1))
    for nu in roots:
        shape = np.sin(nu * (length - x))
        part = np.trapezoid(apart * shape, x) if hasattr(np, "trapezoid") else np.trapz(apart * shape, x)
        part /= 0.5 * length - np.sin(2 * nu * length) / (4 * nu)
        found += part * np.exp(-laws.g * (nu**2 + beta**2) * times)[:, None] * (
            np.exp(beta * z) * np.sin(nu * (length - z)))[None, :]
    return found


def test_terzaghis_table():
    # Terzaghi, Theoretical Soil Mechanics (1943): T = 0.197 and 0.848 for 50 and 90 %
    assert gibson.terzaghi(np.array([0.0, 0.197, 0.848])) == pytest.approx([0, 0.5, 0.9], abs=1.1e-3)


def test_terzaghis_limit():
    laws = Linear(1.0, 1e6, 1e-12)
    length, load = 0.1, 100.0
    z = np.linspace(0, length, 101)
    # c_v = M modulus
    factors = np.array([0.0, 0.02, 0.05, 0.197, 0.4, 0.848, 2.0])
    times = factors * length**2 / (laws.m * laws.modulus)
    run = gibson.solve(laws, z, np.full(100, 1.0), times, 0.0, load, tolerance=1e-9)
    part = (run.heights[0] - run.heights) / (length * load / laws.modulus)
    assert part == pytest.approx(gibson.terzaghi(factors), abs=2e-3)


LAWS = Exponential(e00=9.0, end=3.0, rate=0.02, g=1e-8)
LENGTH, WEIGHT = 0.01, 15700.0  # rate weight length = 3.1: the bottom ends at 3.26


def error(cells, tolerance=1e-8):
    """Largest error of the void ratio's mean over each cell, over the change at the floor."""
    z = np.linspace(0, LENGTH, cells + 1)
    times = np.array([0.0, 200.0, 800.0, 2000.0])
    run = gibson.solve(LAWS, z, np.full(cells, LAWS.e00), times, WEIGHT, tolerance=tolerance)
    middles = 0.5 * (z[1:] + z[:-1])
    return np.max(np.abs(run.e[1:] - LAWS.end - exact(LAWS, LENGTH, WEIGHT, middles, times[1:]))) / 6.0


def test_gibsons_linear_form_and_order():
    errors = [error(n) for n in (20, 40, 80)]
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert errors[-1] < 1e-3
    assert np.all(orders > 1.7), (errors, orders)


CLAY = gibson.PowerLaws(a=12.0, b=0.2, z=1.0, c=2e-10, d=2.5, viscosity=0.28)


def test_laws_are_each_others_inverse():
    e = np.linspace(3.0, 11.9, 2000)
    assert CLAY.void_ratio(CLAY.stress(e)) == pytest.approx(e, rel=1e-12)
    assert -np.gradient(CLAY.stress(e), e)[1:-1] == pytest.approx(CLAY.stiffness(e)[1:-1], rel=2e-2)
    assert np.gradient(np.log(CLAY.mobility(e)), e)[1:-1] == pytest.approx(CLAY.steepness(e)[1:-1], rel=2e-2)
    assert CLAY.stress(np.array([12.1, 20.0])).tolist() == [0, 0] and CLAY.stiffness(np.array([13.0]))[0] == 0


def test_comes_to_rest_under_its_weight():
    length, weight = 0.0095, 15696.0
    z = np.linspace(0, length, 61)
    run = gibson.solve(CLAY, z, np.full(60, 11.9), np.array([0.0, 2000.0]), weight)
    rest = gibson.at_rest(CLAY, z, weight)
    assert run.e[-1] == pytest.approx(rest, rel=1e-4)
    # the integral of 1 + A (w y + Z)^-B over the solids y above
    a, b, zero = CLAY.a, CLAY.b, CLAY.z
    height = length + a * ((weight * length + zero)**(1 - b) - zero**(1 - b)) / (weight * (1 - b))
    assert run.heights[-1] == pytest.approx(height, rel=2e-3)
    assert run.heights[-1] < run.heights[0]


def test_kynchs_limit():
    """Looser than its gel point a suspension falls at M(e) weight, and its lower part forms a bed."""
    length, weight, start = 0.0095, 15696.0, 14.7
    z = np.linspace(0, length, 121)
    speed = float(CLAY.mobility(np.array([start]))[0]) * weight
    times = np.linspace(0, 0.03 / speed, 7)
    run = gibson.solve(CLAY, z, np.full(120, start), times, weight)
    assert (run.heights[0] - run.heights)[1:] == pytest.approx(speed * times[1:], rel=1e-6)
    assert run.e[-1][0] < CLAY.gel and np.all(run.e[-1] <= start + 1e-6)
    assert np.all(np.diff(run.e[-1]) > -1e-6)  # denser below, without swings
    assert run.e[-1][-1] == pytest.approx(start)


def test_waves_do_not_swing():
    """A looser layer below a denser one, both without stress: the step between them stays within its two values."""
    z = np.linspace(0, 0.0095, 121)
    start = np.where(z[1:] < 0.004, 20.0, 13.0)
    run = gibson.solve(CLAY, z, start, np.array([0.0, 40.0]), 15696.0)
    above = run.e[-1][60:]
    assert np.all(above > 13 - 1e-3) and np.all(above < 20 + 1e-3) and np.any(np.abs(above - 13) > 1)


def test_readings():
    z = np.linspace(0, 1, 11)
    run = gibson.Consolidation(np.array([0.0]), z, np.full((1, 10), 4.0))
    assert run.heights[0] == pytest.approx(5) and run.height_below(0.5)[0] == pytest.approx(2.5)
    assert run.interface(0.98, 1e-3)[0] == pytest.approx(5.001) and run.mean_height()[0] == pytest.approx(2.5)
    assert gibson.time_of([0, 1, 2], [10, 6, 5.0], 5.0) == pytest.approx(1.5)
    assert gibson.time_of([0, 1], [10, 9], 5.0) is None


def test_refused():
    z = np.linspace(0, 1, 5)
    for faces, start, times in ((z, [1, 1, 1], [0, 1]), (z[::-1], [1] * 4, [0, 1]), (z, [1, 1, 1, -1], [0, 1]),
                                (z, [1] * 4, [1, 0])):
        with pytest.raises(ValueError, match="should"):
            gibson.solve(CLAY, faces, start, times, 1.0)
