# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""How a uniform suspension gets up to its settling velocity.

Kynch lets it fall at v(phi) from the start. Both phases have inertia, though:
in a closed column phi v = n u upwards, so that the momentum balances of model
A, less each other's pressure gradient, leave one equation

    (rho_p + rho_f phi/n) dv/dt = (rho_p - rho_f) g - coefficient slip/n,
    slip = v/n,

whose rest is the balance that the flux of the drag law stands for. Added mass
is left out, as in the solver. An interface that starts like this runs behind
Kynch's by the lag, the integral of 1 - v/v(phi) over time.
"""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp


@dataclass(frozen=True)
class Startup:
    """From rest to the settling velocity.

    velocity  v(phi) at the end [m/s]
    lag       integral of 1 - v/velocity [s]
    settled   time [s] from which on v is within 1 % of it
    t, fall   shape (m,): times [s] and the way fallen by then [m]
    """

    velocity: float
    lag: float
    settled: float
    t: np.ndarray
    fall: np.ndarray


def startup(flux, phi, rho_p, within=0.01):
    """Startup of a suspension of solid fraction phi, 0 < phi < flux.phi_m.

    flux   a theory.flux.DragLawFlux
    rho_p  density of the particles [kg/m3]
    """
    if not 0.0 < phi < flux.phi_m:
        raise ValueError(f"phi = {phi} should lie between 0 and phi_m = "
                         f"{flux.phi_m}")
    if not rho_p > 0.0:
        raise ValueError(f"rho_p = {rho_p} should be positive")
    n = 1.0 - phi
    final = float(flux.free_velocity(np.asarray(phi)))
    inertia = rho_p + flux.rho_f * phi / n
    scale = inertia * final / (flux.drho * flux.g)

    def rate(_, state):
        slip = max(state[0], 0.0) / n
        drag = float(flux.law(n, slip, flux.d, flux.nu, flux.rho_f)) * slip
        return [(flux.drho * flux.g - drag / n) / inertia, state[0]]

    t = np.linspace(0.0, 12.0 * scale, 2401)
    # not a stiff solver's choice: the drag law may jump with the slip
    found = solve_ivp(rate, (0.0, t[-1]), [0.0, 0.0], "RK45", t, rtol=1e-8,
                      atol=1e-10 * final, max_step=0.05 * scale)
    v, fall = found.y
    slow = np.flatnonzero(v < (1.0 - within) * final)
    return Startup(final, float(t[-1] - fall[-1] / final),
                   float(t[slow[-1] + 1]) if slow[-1] + 1 < t.size
                   else float("inf"), t, fall)
