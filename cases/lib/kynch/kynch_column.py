# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Kynch's theory of a case's column: no number in it is fitted to a curve."""

import math

from cases.lib.case.errors import CaseError
from cases.lib.theory import drag
from cases.lib.theory.flux import DragLawFlux, RichardsonZaki, rz_exponent
from cases.lib.theory.kynch import Kynch
from cases.lib.theory.startup import startup

#: Solid fraction of a bed of spheres poured into the half-size tube, for
#: choosing how long to run; a comparison takes that of its own runs.
POURED = 0.525


def refuse(name, values):
    """CaseError unless the particles are free equal spheres without charges."""
    if "spheres" not in values or "sphere_radius" not in values:
        raise CaseError(f"case {name}: its particles are not free equal spheres, for which alone Kynch's theory "
                        "with the drag law's flux stands; take sphere-half or a case like it")
    if values.get("charge", 0):
        raise CaseError(f"case {name}: charge = {values['charge']} C: must be 0 for Kynch's theory, which has no "
                        "charges")
    if values["drag"] not in drag.LAWS:
        raise CaseError(f"case {name}: drag = {values['drag']}: of this law the theory has no formula; known are "
                        + ", ".join(sorted(drag.LAWS)))


class Column:
    """Theory of a column with the values of a case, words resolved to numbers.

    law, rz    flux of the running drag law, and of Richardson and Zaki with the
               same terminal velocity and its exponent without the wall's part
    kynch, kynch_rz  the exact solutions of the two
    start      theory.startup: how the suspension gets up to its speed
    """

    def __init__(self, values, phi_m, count=4000):
        self.phi_0, self.height, self.phi_m = values["solid_fraction"], values["fill_height"], phi_m
        if not self.phi_0 < phi_m < 1:
            raise CaseError(f"solid_fraction = {self.phi_0:.4g}: must be below that of the bed, {phi_m:.4g}")
        self.d = 2 * values["sphere_radius"]
        nu = values["viscosity"] / values["fluid_density"]
        if not values["density"] > values["fluid_density"]:
            raise CaseError(f"density = {values['density']} kg/m3: must be above fluid_density = "
                            f"{values['fluid_density']} kg/m3 for spheres to settle")
        try:
            self._solve(values, nu, phi_m, count)
        except ValueError as e:  # what theory asks of its arguments
            raise CaseError(str(e)) from None

    def _solve(self, values, nu, phi_m, count):
        self.law = DragLawFlux(values["drag"], self.d, values["density"], values["fluid_density"], nu, phi_m=phi_m)
        self.v_t = float(self.law.velocity(0.0))
        self.re_t = self.v_t * self.d / nu
        self.rz = RichardsonZaki(self.v_t, float(rz_exponent(self.re_t)), phi_m)
        self.kynch = Kynch(self.law, self.phi_0, self.height, count)
        self.kynch_rz = Kynch(self.rz, self.phi_0, self.height, count)
        self.start = startup(self.law, self.phi_0, values["density"])

    def late(self, t):
        """Times [s] that Kynch's column, at full speed at once, has when this
        one, which starts from rest, has the times t [s]."""
        import numpy as np
        s = self.start
        return np.where(t > s.t[-1], t - s.lag, np.interp(t, s.t, s.fall) / s.velocity)

    def waves(self):
        """The solution in words, one line a wave."""
        k = self.kynch
        lines = []
        for where, waves in (("from the top", k.top_waves), ("from the bottom", k.bottom_waves)):
            for w in waves:
                speed = (f"{1e3 * w.speed_high:.2f} mm/s" if w.kind == "shock" else
                         f"{1e3 * w.speed_high:.2f} to {1e3 * w.speed_low:.2f} mm/s")
                lines.append(f"  {where:<17}{w.kind:<7}solid fraction {w.phi_low:.4f} to {w.phi_high:.4f}, "
                             f"upwards at {speed}")
        lines.append(f"  they meet at {k.t_c:.4f} s, {1e3 * k.y_meet:.2f} mm; all is packed at "
                     + (f"{k.t_end:.4f} s" if math.isfinite(k.t_end) else "no finite time")
                     + f", {1e3 * k.final_height:.2f} mm")
        return "\n".join(lines)


def enough(values):
    """A simulated time [s] after which the column rests, in steps of 0.05 s, and
    of the coupling interval."""
    column = Column(values, max(POURED, 0.5 * (1 + values["solid_fraction"])
                                if values["solid_fraction"] >= 0.9 * POURED else POURED), 1000)
    k = column.kynch
    last = k.t_end if math.isfinite(k.t_end) else 2 * k.t_c
    wanted = 0.05 * math.ceil(20 * (1.3 * (last + column.start.lag)))
    interval = values["dem_step"] * values["coupling_steps"]
    return float(f"{interval * math.ceil(wanted / interval - 1e-6):.12g}")
