# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Batch flux functions: solids falling through a closed column.

A flux is an object with

    velocity(phi)    hindered settling velocity v [m/s], 0 from phi_m on
    flux(phi)        phi v(phi) [m/s], volume of solids per area and time
    phi_m            packed limit: the flux is zero there and above
    name             one line for captions
    jumps            solid fractions where the flux jumps
    nodes(count, extra)  sample points and values for kynch

phi of any shape, 0 <= phi <= 1. The column is closed, so that the volume
flux of solids and fluid together is zero: v = n slip.
"""

import numpy as np

from cases.lib.theory import drag


def rz_exponent(re_t):
    """Exponent n(Re_t) of v = v_t (1 - phi)^n: Richardson and Zaki (1954),
    Trans. Inst. Chem. Eng. 32, 35-53, without the wall terms, in pieces:
    4.65 to Re 0.2; 4.35 Re^-0.03 to 1; 4.45 Re^-0.1 to 500; 2.39."""
    re_t = np.asarray(re_t, dtype=float)
    if np.any(re_t < 0.0):
        raise ValueError(f"re_t = {re_t} should not be negative")
    re = np.maximum(re_t, 1e-30)
    return np.select([re_t <= 0.2, re_t <= 1.0, re_t <= 500.0],
                     [4.65 + 0.0 * re, 4.35 * re**-0.03, 4.45 * re**-0.1],
                     2.39)


def garside_exponent(re_t):
    """Exponent n(Re_t) of Garside and Al-Dibouni (1977), Ind. Eng. Chem.
    Process Des. Dev. 16, 206-214: (5.1 - n)/(n - 2.7) = 0.1 Re_t^0.9."""
    re_t = np.asarray(re_t, dtype=float)
    if np.any(re_t < 0.0):
        raise ValueError(f"re_t = {re_t} should not be negative")
    x = 0.1 * re_t**0.9
    return (5.1 + 2.7 * x) / (1.0 + x)


#: Exponent laws by name.
EXPONENTS = {"RichardsonZaki": rz_exponent,
             "GarsideAlDibouni": garside_exponent}


class Flux:
    """Common part: the packed limit and the sample points."""

    jumps = ()

    def __init__(self, phi_m, name):
        if not 0.0 < phi_m <= 1.0:
            raise ValueError(
                f"phi_m = {phi_m} should be above 0 and at most 1")
        self.phi_m = float(phi_m)
        self.name = name

    def free_velocity(self, phi):
        """Settling velocity [m/s] without regard to the packed limit."""
        raise NotImplementedError

    def velocity(self, phi):
        """Hindered settling velocity [m/s], 0 at and above phi_m. Raises
        ValueError for phi outside 0 ... 1."""
        phi = np.asarray(phi, dtype=float)
        if np.any(phi < 0.0) or np.any(phi > 1.0):
            raise ValueError("phi should lie between 0 and 1, here "
                             f"{np.min(phi)} ... {np.max(phi)}")
        packed = phi >= self.phi_m
        return np.where(packed, 0.0,
                        self.free_velocity(np.where(packed, 0.0, phi)))

    def flux(self, phi):
        """Batch flux phi v(phi) [m/s]."""
        return np.asarray(phi, dtype=float) * self.velocity(phi)

    __call__ = flux

    def slope(self, phi, step=1e-6):
        """df/dphi [m/s] by differences that stay within (0, phi_m)."""
        phi = np.asarray(phi, dtype=float)
        low = np.maximum(phi - step, 0.0)
        high = np.minimum(phi + step, self.phi_m * (1.0 - 1e-12))
        return (self.flux(high) - self.flux(low)) / (high - low)

    def nodes(self, count=4000, extra=()):
        """(phi, f) of shape (m,), phi rising from 0 to phi_m with f = 0 at
        both ends: `count` even steps, and the points of `extra`. At a jump f
        is the lower of the two sides, which is the one that the exact
        solution uses."""
        points = [np.linspace(0.0, self.phi_m, count + 1),
                  np.asarray(self.jumps, dtype=float),
                  np.asarray(extra, dtype=float)]
        return self._values(np.concatenate(points))

    def _values(self, points):
        phi = np.unique(points[(points >= 0.0) & (points <= self.phi_m)])
        near = np.diff(phi) < 1e-12
        phi = phi[np.concatenate([[True], ~near])]
        f = self.flux(phi)
        for jump in self.jumps:
            at = np.abs(phi - jump) < 1e-9
            sides = self.flux(np.clip([jump - 1e-9, jump + 1e-9], 0.0, 1.0))
            f[at] = np.min(sides)
        f[0] = f[-1] = 0.0
        return phi, f


class RichardsonZaki(Flux):
    """f = phi v_t (1 - phi)^n up to phi_m.

    v_t       terminal velocity of one particle [m/s]
    exponent  n itself, or a name of EXPONENTS with re_t given
    """

    def __init__(self, v_t, exponent=4.65, phi_m=0.6, re_t=None):
        if not v_t > 0.0:
            raise ValueError(f"v_t = {v_t} should be positive")
        if isinstance(exponent, str):
            if exponent not in EXPONENTS:
                raise ValueError(f"exponent {exponent} is not known; known "
                                 f"are {' '.join(sorted(EXPONENTS))}")
            if re_t is None:
                raise ValueError(f"exponent {exponent} needs re_t, the "
                                 "Reynolds number v_t d/nu")
            exponent = EXPONENTS[exponent](re_t)
        if not exponent >= 0.0:
            raise ValueError(f"exponent = {exponent} should not be negative")
        super().__init__(phi_m, f"Richardson-Zaki n = {float(exponent):.3g}")
        self.v_t = float(v_t)
        self.exponent = float(exponent)

    def free_velocity(self, phi):
        return self.v_t * (1.0 - phi) ** self.exponent


class DragLawFlux(Flux):
    """The flux that a drag law implies in a closed column: no fitted number.

    Balance of a sphere (drag.balance_slip) and no net volume flux,
    v = n slip, at the law's own finite Reynolds number.

    drag_law   a name of drag.LAWS, or a function law(n, slip, d, nu, rho)
    d          sphere diameter [m]
    rho_p, rho_f   densities of particle and fluid [kg/m3], rho_p > rho_f
    nu         kinematic viscosity of the fluid [m2/s]
    """

    def __init__(self, drag_law, d, rho_p, rho_f, nu, g=9.81, phi_m=0.6):
        named = isinstance(drag_law, str)
        super().__init__(phi_m, drag_law if named else drag_law.__name__)
        if phi_m >= 1.0:
            raise ValueError(f"phi_m = {phi_m} should be below 1: a drag law "
                             "needs fluid between the particles")
        self.law = drag.law(drag_law)
        self.jumps = drag.JUMPS.get(drag_law, ()) if named else ()
        if not rho_p > rho_f:
            raise ValueError(f"rho_p = {rho_p} should be above rho_f = {rho_f}")
        self.d, self.nu, self.rho_f = float(d), float(nu), float(rho_f)
        self.drho, self.g = float(rho_p - rho_f), float(g)

    def slip(self, phi):
        """Interstitial slip [m/s] of the uniform suspension."""
        return drag.balance_slip(self.law, 1.0 - np.asarray(phi, dtype=float),
                                 self.d, self.nu, self.rho_f, self.drho,
                                 self.g)

    def free_velocity(self, phi):
        return (1.0 - phi) * self.slip(phi)

    def reynolds(self, phi):
        """Reynolds number n slip d/nu of the superficial slip."""
        return drag.reynolds(1.0 - np.asarray(phi), self.slip(phi), self.d,
                             self.nu)


class TabulatedFlux(Flux):
    """A flux given by points, straight lines between them.

    phi, f   shape (m,), m >= 2; phi rising from above or at 0, f >= 0 [m/s].
    A point (0, 0) is put before the first and the flux drops to zero at
    phi_m, by default the last phi given.
    """

    def __init__(self, phi, f, phi_m=None, name="tabulated"):
        phi, f = np.array(phi, dtype=float), np.array(f, dtype=float)
        if phi.ndim != 1 or phi.shape != f.shape or phi.size < 2:
            raise ValueError(f"phi and f should be two lists of equal length, "
                             f"2 or more, here {phi.shape} and {f.shape}")
        if np.any(np.diff(phi) <= 0.0) or phi[0] < 0.0 or phi[-1] > 1.0:
            raise ValueError("phi should rise, from 0 or above to 1 at most")
        if np.any(f < 0.0) or not np.all(np.isfinite(f)):
            raise ValueError(f"f = {f} should be finite and not negative")
        super().__init__(phi[-1] if phi_m is None else phi_m, name)
        if self.phi_m > phi[-1]:
            raise ValueError(f"phi_m = {phi_m} should be at most the last phi,"
                             f" {phi[-1]}")
        if phi[0] > 0.0:
            phi, f = np.append(0.0, phi), np.append(0.0, f)
        elif f[0] != 0.0:
            raise ValueError(f"f = {f[0]} at phi = 0 should be 0")
        self.table = phi, f

    def free_velocity(self, phi):
        points, values = self.table
        first = values[1] / points[1]
        safe = np.maximum(phi, 1e-300)
        return np.where(phi < points[1], first,
                        np.interp(phi, points, values) / safe)

    def nodes(self, count=4000, extra=()):
        """As Flux.nodes, with the points of the table alone (and `extra`):
        between them the flux is a straight line. Just below phi_m one point
        keeps the drop to zero where it is."""
        points = np.concatenate([self.table[0], np.asarray(extra, dtype=float),
                                 [self.phi_m, self.phi_m * (1.0 - 1e-9)]])
        return self._values(points)
