# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Scaling between prototype particles and the larger ones of the model.

Eqs 14 to 16: in Stokes flow the terminal velocity goes with d2, so that over
the same distance the prototype takes (d_m/d_p)2 times as long. The paper then
uses 9.49e5, found by laying its curves over measured ones, in place of 1e6.

Eq. 14 holds at Re well below 1. The model's particles are far above that:
`report` says so, and by how much. Their terminal velocity with Schiller and
Naumann's drag gives the ratio of times that single particles really have.
"""

import argparse
import sys
from dataclasses import dataclass

#: Calibrated ratio of times T_p/T_m of the paper's section 4.2.3.
CALIBRATED = 9.49e5

DAY = 86400.0


def stokes_velocity(d, rho_p, rho_f, mu, g=9.81):
    """Terminal velocity of Eq. 14, (rho_p - rho_f) d2 g/(18 mu) [m/s]."""
    return (rho_p - rho_f) * d**2 * g / (18.0 * mu)


@dataclass(frozen=True)
class Side:
    """A particle alone in its fluid, model's or prototype's.

    name        for messages
    d           sphere diameter [m]
    stokes      terminal velocity of Eq. 14 [m/s]
    terminal    with Schiller-Naumann drag [m/s]
    re_stokes, re   Reynolds numbers d v/nu of the two
    """

    name: str
    d: float
    stokes: float
    terminal: float
    re_stokes: float
    re: float

    @property
    def stokes_error(self):
        """Part by which Eq. 14 overestimates the terminal velocity."""
        return self.stokes / self.terminal - 1.0

    @property
    def warning(self):
        """Plain words when Eq. 14 is off by more than 5 %, else ""."""
        if self.stokes_error <= 0.05:
            return ""
        return (f"{self.name}: Re = {self.re:.3g} is not Stokes flow; Eq. 14 "
                f"gives {self.stokes:.3g} m/s, Schiller-Naumann "
                f"{self.terminal:.3g} m/s, so Eq. 14 is "
                + (f"{100.0 * self.stokes_error:.0f} % too fast"
                   if self.stokes_error < 1.0 else
                   f"{1.0 + self.stokes_error:.1f} times too fast"))


@dataclass(frozen=True)
class Scaling:
    """Prototype and model in the same fluid, over the same distance.

    d_model, d_prototype  sphere diameters [m]
    rho_p, rho_f          densities of particle and fluid [kg/m3]
    mu                    dynamic viscosity [Pa s]
    factor                ratio of times T_p/T_m; None: (d_m/d_p)2
    The defaults are the paper's. ValueError names a setting out of range.
    """

    d_model: float = 2e-3
    d_prototype: float = 2e-6
    rho_p: float = 2600.0
    rho_f: float = 1000.0
    mu: float = 8.94e-4
    g: float = 9.81
    factor: float = None

    def __post_init__(self):
        for name in ("d_model", "d_prototype", "rho_p", "rho_f", "mu", "g"):
            value = getattr(self, name)
            if not 0.0 < value < float("inf"):
                raise ValueError(f"{name} = {value} should be positive")
        if self.rho_p <= self.rho_f:
            raise ValueError(f"rho_p = {self.rho_p} should be above rho_f = "
                             f"{self.rho_f} for particles to settle")
        if self.factor is not None and not self.factor > 0.0:
            raise ValueError(f"factor = {self.factor} should be positive")

    def _side(self, name, d):
        from cases.lib.theory import drag  # numpy: lists of cases and keys go without it

        stokes = stokes_velocity(d, self.rho_p, self.rho_f, self.mu, self.g)
        real = drag.terminal_velocity(d, self.rho_p, self.rho_f, self.mu,
                                      self.g)
        per_speed = self.rho_f * d / self.mu
        return Side(name, d, stokes, real, stokes * per_speed,
                    real * per_speed)

    @property
    def model(self):
        """The model's particle, a Side."""
        return self._side("model", self.d_model)

    @property
    def prototype(self):
        """The prototype's particle, a Side."""
        return self._side("prototype", self.d_prototype)

    @property
    def stokes_ratio(self):
        """u_m/u_p = T_p/T_m = (d_m/d_p)2 of Eqs 15 and 16."""
        return (self.d_model / self.d_prototype) ** 2

    @property
    def terminal_ratio(self):
        """u_m/u_p = T_p/T_m of single particles with Schiller-Naumann."""
        return self.model.terminal / self.prototype.terminal

    @property
    def time_ratio(self):
        """The T_p/T_m in use: factor, or that of Eq. 16."""
        return self.stokes_ratio if self.factor is None else self.factor

    def to_prototype(self, time):
        """Prototype time [s] of a model time [s], any shape."""
        return time * self.time_ratio

    def to_model(self, time):
        """Model time [s] of a prototype time [s], any shape."""
        return time / self.time_ratio

    def velocity_to_prototype(self, velocity):
        """Prototype velocity [m/s] of a model velocity, same distances."""
        return velocity / self.time_ratio

    def velocity_to_model(self, velocity):
        """Model velocity [m/s] of a prototype velocity, same distances."""
        return velocity * self.time_ratio

    @property
    def warnings(self):
        """Plain words, a list: where Eq. 14 does not hold and what the ratio
        of times then is."""
        words = [side.warning for side in (self.model, self.prototype)
                 if side.warning]
        if words:
            words.append(
                f"ratio of times: {self.terminal_ratio:.3g} by single "
                f"particles' terminal velocities, {self.stokes_ratio:.3g} by "
                f"Eq. 16, {self.time_ratio:.3g} in use")
        return words

    def report(self):
        """Table of both sides and the warnings, as text."""
        model, prototype = self.model, self.prototype
        rows = [("", "model", "prototype"),
                ("diameter [m]", model.d, prototype.d),
                ("Stokes velocity, Eq. 14 [m/s]", model.stokes,
                 prototype.stokes),
                ("Re with it", model.re_stokes, prototype.re_stokes),
                ("Schiller-Naumann velocity [m/s]", model.terminal,
                 prototype.terminal),
                ("Re with it", model.re, prototype.re)]

        def cell(v):
            return v if isinstance(v, str) else f"{v:.4g}"

        lines = [f"{a:<34}{cell(b):>12}{cell(c):>12}" for a, b, c in rows]
        lines.append(f"{'T_p/T_m, Eq. 16':<34}{self.stokes_ratio:>12.4g}")
        lines.append(f"{'T_p/T_m in use':<34}{self.time_ratio:>12.4g}")
        return "\n".join(lines + ["warning: " + w for w in self.warnings])


def diameter_of_model(d_prototype, ratio):
    """Diameter [m] of the model's particle for T_p/T_m = ratio by Eq. 16."""
    if not ratio > 0.0:
        raise ValueError(f"ratio = {ratio} should be positive")
    return d_prototype * ratio**0.5


def main(arguments=None, paper=Scaling(), prog="theory.scaling"):
    """`python3 -m theory.scaling --help`, with `paper` for the defaults.
    Returns 0, or 2 on bad input."""
    parser = argparse.ArgumentParser(
        prog=prog, allow_abbrev=False, description="Velocities, Reynolds "
        "numbers and times of prototype and model particles (Eqs 14 to 16).")
    add = parser.add_argument
    model = parser.add_mutually_exclusive_group()
    model.add_argument("--d-model", type=float, metavar="M",
                       help=f"model's diameter [m] ({paper.d_model:g})")
    model.add_argument("--ratio", type=float, metavar="R",
                       help="take the model's diameter that gives T_p/T_m = R "
                       "by Eq. 16")
    for name, unit, what in (("d_prototype", "M", "prototype's diameter [m]"),
                             ("rho_p", "R", "particles' density [kg/m3]"),
                             ("rho_f", "R", "fluid's density [kg/m3]"),
                             ("mu", "MU", "dynamic viscosity [Pa s]"),
                             ("g", "G", "gravity [m/s2]")):
        add("--" + name.replace("_", "-"), type=float, metavar=unit,
            default=getattr(paper, name),
            help=f"{what} ({getattr(paper, name):g})")
    ratio = parser.add_mutually_exclusive_group()
    ratio.add_argument("--factor", type=float, default=paper.factor,
                       metavar="F", help="T_p/T_m to use for times and "
                       "velocities, in place of Eq. 16's")
    ratio.add_argument("--calibrated", action="store_const", dest="factor",
                       const=CALIBRATED, help=f"the paper's {CALIBRATED:g}")
    for option, metavar, what in (
            ("model-time", "S", "model time [s] to turn into prototype days"),
            ("prototype-days", "D", "prototype time [d] to turn into model "
             "seconds"),
            ("model-speed", "V", "model velocity [m/s] to turn into the "
             "prototype's, mm/d"),
            ("prototype-speed", "V", "prototype velocity [mm/d] to turn into "
             "the model's, m/s")):
        add("--" + option, type=float, action="append", default=[],
            metavar=metavar, help=what)
    a = parser.parse_args(arguments)
    try:
        if a.ratio is not None:
            a.d_model = diameter_of_model(a.d_prototype, a.ratio)
        scaling = Scaling(paper.d_model if a.d_model is None else a.d_model,
                          a.d_prototype, a.rho_p, a.rho_f, a.mu, a.g, a.factor)
    except ValueError as error:
        print(f"{prog}: {error}", file=sys.stderr)
        return 2
    print(scaling.report())
    per_day = 1e3 * DAY
    for values, words, convert in (
            (a.model_time, "model {:g} s = prototype {:.4g} d",
             lambda t: scaling.to_prototype(t) / DAY),
            (a.prototype_days, "prototype {:g} d = model {:.4g} s",
             lambda t: scaling.to_model(t * DAY)),
            (a.model_speed, "model {:g} m/s = prototype {:.4g} mm/d",
             lambda v: scaling.velocity_to_prototype(v) * per_day),
            (a.prototype_speed, "prototype {:g} mm/d = model {:.4g} m/s",
             lambda v: scaling.velocity_to_model(v / per_day))):
        for value in values:
            print(words.format(value, convert(value)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
