# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Exact batch sedimentation of a uniform suspension for any flux.

Kynch (1952), Trans. Faraday Soc. 48, 166-176: phi_t - f(phi)_z = 0 on
0 < z < H, with phi = phi_0 at the start, clear fluid above, a packed bed of
phi_m and f = 0 on the bottom.

The solids volume per area below z, M(z, t), has M_t = f(M_z). It starts
concave in z, so that Hopf's second formula (Hopf 1965, J. Math. Mech. 14,
951-973; Bardi and Evans 1984, Nonlinear Anal. 8, 1373-1381) gives the entropy
solution for every continuous flux, convex or not:

    M(z, t) = min over phi of  phi z + t f(phi) + H max(phi_0 - phi, 0)

and phi(z, t) is the phi at the minimum. Upper interface and bed follow as

    interface(t) = max over phi of  H min(1, phi_0/phi) - t f/phi
    bed(t) = min over phi of  (t f + H max(phi_0 - phi, 0))/(phi_m - phi)

The waves that leave bottom and top are those of the lower convex hull of f
over (phi_0, phi_m) and (0, phi_0). A flux that jumps counts with the lower
side at the jump.
"""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq


@dataclass(frozen=True)
class Wave:
    """One piece of a centred wave, speeds upwards positive [m/s].

    kind      "shock" or "fan"
    phi_low   solid fraction at its upper side
    phi_high  solid fraction at its lower side
    speed_high, speed_low  speeds of upper and lower side, equal for a shock
    """

    kind: str
    phi_low: float
    phi_high: float
    speed_high: float
    speed_low: float


@dataclass(frozen=True)
class Line:
    """A straight characteristic or shock to draw, from (t[0], z[0]) to
    (t[1], z[1]) [s, m]; kind "uniform", "fan" or "shock"; phi on it, for a
    shock below it."""

    kind: str
    t: tuple
    z: tuple
    phi: float


def lower_hull(x, y):
    """Indices of the lower convex hull of points, x rising, shape (m,)."""
    keep = []
    for k in range(len(x)):
        while len(keep) > 1:
            i, j = keep[-2], keep[-1]
            if ((y[j] - y[i]) * (x[k] - x[i])
                    < (y[k] - y[i]) * (x[j] - x[i])):
                break
            keep.pop()
        keep.append(k)
    return np.array(keep)


def hull_waves(phi, f):
    """Waves of the lower convex hull of f over phi, from the lowest phi (the
    uppermost wave) on. Hull points that are neighbours among many samples
    make a fan, others bound a shock."""
    if len(phi) < 2:
        return []
    hull = lower_hull(phi, f)
    speed = -np.diff(f[hull]) / np.diff(phi[hull])
    # a straight piece of fewer steps than this is a fan as sampled
    fan = np.diff(hull) <= 3 if len(phi) > 100 else np.diff(hull) < 0
    waves, k = [], 0
    while k < len(speed):
        end = k + 1
        while fan[k] and end < len(speed) and fan[end]:
            end += 1
        # one short step alone at a shock's foot is its rounding
        kind = "fan" if end - k > 2 else "shock"
        ends = speed[k], speed[end - 1]
        if kind == "fan":
            # chords carry the slope of their middles: on to the fan's ends
            x, s = phi[hull[k:end + 1]], speed[k:end]
            middle = 0.5 * (x[1:] + x[:-1])
            ends = (s[0] + (s[1] - s[0]) * (x[0] - middle[0])
                    / (middle[1] - middle[0]),
                    s[-1] + (s[-1] - s[-2]) * (x[-1] - middle[-1])
                    / (middle[-1] - middle[-2]))
        waves.append(Wave(kind, float(phi[hull[k]]), float(phi[hull[end]]),
                          float(ends[0]), float(ends[1])))
        k = end
    if len(waves) > 1:
        span = 1e-3 * (phi[-1] - phi[0])
        waves = [w for w in waves
                 if w.kind == "fan" or w.phi_high - w.phi_low > span] or waves
    return waves


class Kynch:
    """Batch sedimentation of a column.

    flux    object of theory.flux
    phi_0   initial solid fraction, 0 < phi_0 < flux.phi_m
    height  initial height H of the suspension [m]
    count   samples of the flux over (0, phi_m); the error of interface and
            bed goes with 1/count^2
    """

    def __init__(self, flux, phi_0, height, count=4000):
        if not 0.0 < phi_0 < flux.phi_m:
            raise ValueError(f"phi_0 = {phi_0} should lie between 0 and "
                             f"phi_m = {flux.phi_m}")
        if not height > 0.0:
            raise ValueError(f"height = {height} should be positive")
        self.flux_law, self.phi_0 = flux, float(phi_0)
        self.height, self.phi_m = float(height), flux.phi_m
        self.phi, self.f = flux.nodes(count, extra=[phi_0])
        start = int(np.argmin(np.abs(self.phi - phi_0)))
        #: waves from the bottom and from the top, uppermost first
        self.bottom_waves = hull_waves(self.phi[start:], self.f[start:])
        self.top_waves = hull_waves(self.phi[:start + 1], self.f[:start + 1])
        self._start = self.height * np.maximum(self.phi_0 - self.phi, 0.0)

    # -- waves -----------------------------------------------------------

    @property
    def wave_type(self):
        """Wave from the bottom: "shock", "fan" or "compound"."""
        kinds = {wave.kind for wave in self.bottom_waves}
        if kinds == {"fan"}:
            return "fan"
        return "shock" if len(self.bottom_waves) == 1 else "compound"

    @property
    def interface_speed(self):
        """Speed of the upper interface at the start, downwards [m/s]."""
        return -self.top_waves[0].speed_high

    @property
    def bed_wave_speed(self):
        """Speed of the fastest wave from the bottom, upwards [m/s]."""
        return self.bottom_waves[0].speed_high

    @property
    def t_c(self):
        """Time [s] at which the fastest wave from the bottom first meets the
        wave from the top: no suspension of phi_0 is left from then on."""
        return self.height / (self.bed_wave_speed
                              - self.top_waves[-1].speed_low)

    @property
    def y_meet(self):
        """Height of that meeting [m]."""
        return self.bed_wave_speed * self.t_c

    @property
    def final_height(self):
        """Height of the packed bed at the end, phi_0 H/phi_m [m]."""
        return self.phi_0 * self.height / self.phi_m

    @property
    def t_end(self):
        """Time [s] at which all is packed; inf when it takes for ever
        (f and f' both vanish at phi_m)."""
        phi = self.phi[1:-1]
        fall = (self.height * np.minimum(1.0, self.phi_0 / phi)
                - self.final_height)
        with np.errstate(divide="ignore"):
            needed = fall * phi / self.f[1:-1]
        close = self.phi_m - np.array([1e-3, 1e-5]) * self.phi_m
        near = (self.phi_m - close) / np.maximum(self.flux_law(close), 1e-300)
        return np.inf if near[1] > 3.0 * near[0] else float(np.max(needed))

    # -- the solution ----------------------------------------------------

    def solids_below(self, z, t):
        """M(z, t) [m], solids volume per area below z, and phi(z, t). z
        shape (m,) [m], t one time >= 0 [s]."""
        z = np.clip(np.atleast_1d(np.asarray(z, dtype=float)), 0.0, None)
        base = t * self.f + self._start
        solids, phi = np.empty_like(z), np.empty_like(z)
        for part in np.array_split(np.arange(z.size), 1 + z.size // 500):
            values = base + z[part, None] * self.phi
            best = np.argmin(values, axis=1)
            solids[part] = values[np.arange(part.size), best]
            phi[part] = self.phi[best]
        return solids, phi

    def profile(self, z, t):
        """Solid fraction phi(z, t), z shape (m,) [m], t one time [s]. In a
        fan it is right to the sample distance phi_m/count."""
        return self.solids_below(z, t)[1]

    def interface(self, t):
        """Height [m] of the upper interface at times t [s], any shape."""
        phi, f = self.phi[1:-1], self.f[1:-1]
        start = self.height * np.minimum(1.0, self.phi_0 / phi)
        best = self._extreme(t, lambda part: np.max(
            start - part[:, None] * (f / phi), axis=1))
        return np.maximum(best, self.final_height)

    def bed(self, t):
        """Height [m] up to which phi = phi_m at times t [s], any shape."""
        gap = self.phi_m - self.phi[:-1]
        best = self._extreme(t, lambda part: np.min(
            (part[:, None] * self.f[:-1] + self._start[:-1]) / gap, axis=1))
        return np.minimum(best, self.final_height)

    def mean_height(self, t, points=1000):
        """Mean height [m] of the solids at times t [s], any shape: by parts,
        (H M(H) - integral of M dz)/M(H) with `points` even steps in z."""
        def mean(part):
            z = np.linspace(0.0, self.height, points + 1)
            total = self.phi_0 * self.height
            dz = self.height / points
            out = []
            for time in part:
                m = self.solids_below(z, time)[0]
                out.append(self.height
                           - dz * (np.sum(m) - 0.5 * (m[0] + m[-1])) / total)
            return np.array(out)
        return self._extreme(t, mean)

    @staticmethod
    def _extreme(t, function):
        """function over flat parts of the times, shape of t kept."""
        t = np.asarray(t, dtype=float)
        if np.any(t < 0.0):
            raise ValueError(f"t = {np.min(t)} should not be negative")
        flat = t.ravel()
        parts = np.array_split(flat, 1 + flat.size // 500)
        return np.concatenate([function(p) for p in parts]).reshape(t.shape)

    # -- for drawing -----------------------------------------------------

    def fan_trajectory(self, count=200):
        """(t, z, phi), each shape (m,): where the upper interface meets the
        characteristics of fans from the bottom. By the solids balance
        phi_0 H = t (f - phi f'), z = -f' t along phi; empty without a fan.
        It holds while the interface is a single shock to clear fluid."""
        fans = [w for w in self.bottom_waves if w.kind == "fan"]
        if not fans:
            return np.empty(0), np.empty(0), np.empty(0)
        phi = np.concatenate([
            np.linspace(w.phi_low, w.phi_high, count + 2)[1:-1] for w in fans])
        slope = self.flux_law.slope(phi)
        t = self.phi_0 * self.height / (self.flux_law(phi) - phi * slope)
        return t, -slope * t, phi

    def characteristics(self, uniform=12, fan=12):
        """Lines for the (t, z) plane: `uniform` characteristics of phi_0, at
        most `fan` of every fan, and the shocks from the bottom, each until
        it meets a shock or the interface."""
        lines, slope = [], float(self.flux_law.slope(self.phi_0))
        top, low = self.top_waves[-1].speed_low, self.bed_wave_speed
        for z0 in (np.arange(uniform) + 0.5) / uniform * self.height:
            # -slope lies between the speeds of the two waves or on one
            ends = [self.t_c]
            if -slope - top > 1e-9 * abs(top):
                ends.append((self.height - z0) / (-slope - top))
            if low + slope > 1e-9 * abs(top):
                ends.append(z0 / (low + slope))
            t = min(ends)
            lines.append(Line("uniform", (0.0, t), (z0, z0 - slope * t),
                              self.phi_0))
        for wave in self.bottom_waves:
            phi = ([wave.phi_high] if wave.kind == "shock" else
                   np.linspace(wave.phi_low, wave.phi_high, fan))
            speed = ([wave.speed_low] if wave.kind == "shock" else
                     -self.flux_law.slope(phi))
            for p, s in zip(phi, speed):
                t = self._meets_interface(max(float(s), 0.0))
                lines.append(Line(wave.kind, (0.0, t), (0.0, s * t), float(p)))
        return lines

    def _meets_interface(self, speed):
        """Time at which a front z = speed t meets the upper interface."""
        def gap(t):
            return float(self.interface(t)) - speed * t

        high = self.t_c
        while gap(high) > 1e-12 * self.height and high < 1e6 * self.t_c:
            high *= 2.0
        return high if gap(high) > 0 else brentq(gap, 0.0, high, rtol=1e-12)
