# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""One-dimensional large-strain consolidation under self-weight.

Gibson, England and Hussey (1967), Geotechnique 17, 261-273, in the material
coordinate z, the height of solids below [m]. With e the void ratio, dx = (1 + e)
dz, Darcy's law and the balance of forces leave

    de/dt = -dq/dz,   q = M(e) (w + ds/dz),   M = kappa/(mu (1 + e)),

q the fluid's flux relative to the solids, w the buoyant weight of a volume of
solids [N/m3], s(e) the effective stress [Pa]. Below the floor q = 0; at the top
s = load. Where s(e) = 0, in a suspension looser than its gel point, this is
Kynch's equation; with small strains Terzaghi's.

Finite volumes in z. The mobility of a face is the mean of its two cells' where
stresses lead, and that of the cell below, from where Kynch's waves come, where
weight does (by the cell's Peclet number). In time scipy's BDF, implicit, its
step and order chosen for the tolerance.
"""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp
from scipy.sparse import diags


def _within(e, most):
    """Void ratios as powers take them, also where the solver tries one below 0."""
    return np.clip(e, 1e-3, most)


@dataclass(frozen=True)
class PowerLaws:
    """The usual laws: e = A (s + Z)^-B, kappa = C e^D.

    a, b, z   A, B, and Z [Pa]: at the gel point, e = A Z^-B, there is no stress
    c, d      C [m2], D
    viscosity of the fluid [Pa s]
    """

    a: float
    b: float
    z: float
    c: float
    d: float
    viscosity: float

    @property
    def gel(self):
        """Void ratio from which on there is no stress."""
        return self.a * self.z**-self.b

    def void_ratio(self, stress):
        """e of the effective stress [Pa]."""
        return self.a * (np.maximum(stress, 0.0) + self.z)**-self.b

    def stress(self, e):
        """Effective stress [Pa] of the void ratio."""
        return np.where(e < self.gel, (_within(e, self.gel) / self.a)**(-1.0 / self.b) - self.z, 0.0)

    def stiffness(self, e):
        """-ds/de [Pa]."""
        held = _within(e, self.gel)
        return np.where(e < self.gel, (held / self.a)**(-1.0 / self.b) / (self.b * held), 0.0)

    def permeability(self, e):
        """kappa [m2]."""
        return self.c * _within(e, np.inf)**self.d

    def mobility(self, e):
        """kappa/(mu (1 + e)) [m2/(Pa s)]."""
        return self.permeability(e) / (self.viscosity * (1.0 + e))

    def steepness(self, e):
        """d(log mobility)/de."""
        return self.d / e - 1.0 / (1.0 + e)


@dataclass(frozen=True)
class Consolidation:
    """Void ratios over time.

    times  shape (m,) [s]
    z      shape (k + 1,): faces of the cells, solids below [m]
    e      shape (m, k)
    """

    times: np.ndarray
    z: np.ndarray
    e: np.ndarray

    @property
    def faces(self):
        """Heights [m] of the faces, shape (m, k + 1)."""
        steps = (1.0 + self.e) * np.diff(self.z)
        return np.concatenate([np.zeros((len(self.times), 1)), np.cumsum(steps, axis=1)], axis=1)

    @property
    def heights(self):
        """Of the top [m], shape (m,)."""
        return self.faces[:, -1]

    def height_below(self, share):
        """Height [m] below which that share of the solids lies, shape (m,)."""
        wanted = share * self.z[-1]
        return np.array([np.interp(wanted, self.z, row) for row in self.faces])

    def interface(self, quantile=0.98, radius=0.0):
        """The upper interface [m] as fix settling/curve reads it, shape (m,)."""
        upper, lower = self.height_below(quantile), self.height_below(quantile - 0.1)
        return upper + (upper - lower) * (1 - quantile) / 0.1 + radius

    def mean_height(self):
        """Of the solids [m], shape (m,)."""
        middles = 0.5 * (self.faces[:, 1:] + self.faces[:, :-1])
        return middles @ np.diff(self.z) / self.z[-1]


def _fluxes(laws, e, steps, weight, load):
    """q at the faces, shape (k + 1,); 0 at the floor."""
    stress, mobility = laws.stress(e), laws.mobility(e)
    gap = 0.5 * (steps[1:] + steps[:-1])
    stiff = 0.5 * (laws.stiffness(e)[1:] + laws.stiffness(e)[:-1])
    steep = 0.5 * np.abs(laws.steepness(e)[1:] + laws.steepness(e)[:-1])
    # the cell's Peclet number is weight gap steep/stiff; above 2 the middle would swing
    below = 1.0 - np.minimum(1.0, 2.0 * stiff / np.maximum(weight * gap * steep, 1e-300))
    face = 0.5 * (1 + below) * mobility[:-1] + 0.5 * (1 - below) * mobility[1:]
    inner = face * (weight + np.diff(stress) / gap)
    # towards the top's own void ratio, as far as there is stress
    top = mobility[-1] * (weight + (load - stress[-1]) / (0.5 * steps[-1]))
    if load > 0.0 or stress[-1] > 0.0:
        top *= 0.5 * (1.0 + laws.mobility(laws.void_ratio(load)) / mobility[-1])
    return np.concatenate([[0.0], inner, [top]])


def solve(laws, z, start, times, weight, load=0.0, tolerance=1e-6):
    """Consolidation from the void ratios `start`, shape (k,), in cells with faces z, shape (k + 1,) [m of solids].

    laws    with stress, stiffness, mobility, steepness of e, and void_ratio of a stress
    times   shape (m,), rising, the first that of `start` [s]
    weight  buoyant weight of a volume of solids [N/m3]; load: effective stress on the top [Pa]
    ValueError on what does not fit together.
    """
    z, start, times = (np.asarray(a, dtype=float) for a in (z, start, times))
    if z.size != start.size + 1 or np.any(np.diff(z) <= 0) or start.size < 3:
        raise ValueError(f"{z.size} faces, which should rise, and {start.size} void ratios: should be one more face")
    if np.any(start <= 0) or np.any(np.diff(times) <= 0) or weight < 0 or load < 0:
        raise ValueError("void ratios should be positive, times rise, weight and load not be negative")
    steps = np.diff(z)

    def rate(_, e):
        return -np.diff(_fluxes(laws, e, steps, weight, load)) / steps

    k = start.size
    found = solve_ivp(rate, (times[0], times[-1]), start, "BDF", times, rtol=tolerance, atol=tolerance,
                      jac_sparsity=diags([np.ones(k - 1), np.ones(k), np.ones(k - 1)], [-1, 0, 1]))
    if found.status:
        raise ValueError(f"no solution: {found.message}")
    return Consolidation(times, z, found.y.T)


def at_rest(laws, z, weight, load=0.0):
    """Void ratios in the middles of the cells when all excess pore pressure is gone, shape (k,)."""
    z = np.asarray(z, dtype=float)
    return laws.void_ratio(load + weight * (z[-1] - 0.5 * (z[1:] + z[:-1])))


def time_of(times, heights, final, share=0.9):
    """When that share of the fall from the first height to the final one is done [s]; None where it is not."""
    done = (heights[0] - np.asarray(heights)) / (heights[0] - final)
    if not np.any(done >= share):
        return None
    k = int(np.argmax(done >= share))
    if k == 0:
        return float(times[0])
    return float(np.interp(share, done[k - 1:k + 1], times[k - 1:k + 1]))


def terzaghi(factor, terms=200):
    """Degree of consolidation by Terzaghi's series, of the time factor c_v t/H^2: one side drained, excess pressure
    even at the start."""
    m = (2 * np.arange(terms) + 1) * np.pi / 2
    t = np.asarray(factor, dtype=float)[..., None]
    return 1.0 - np.sum(2.0 / m**2 * np.exp(-m**2 * t), axis=-1)
