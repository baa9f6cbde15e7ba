# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Added mass: single spheres from rest, and dense suspensions in a closed column,
against the equations of motion with the drag law that runs."""

import os

import numpy as np
from scipy.integrate import solve_ivp

from cases.lib.theory import drag
from validation.lib.checks import coupled, plots

TITLE = "added mass: density ratios 0.001 to 8, spheres alone and at a solid fraction of 0.3"

G, RHO, CM = 9.81, 1000.0, 0.5
RATIOS = {"v10": 10.0, "v500": 500.0, "v2000": 2000.0, "v8000": 8000.0}


def alone(t, rho_p, cm=CM):
    """Velocity [m/s] of a sphere of 1 mm in 0.1 Pa s, in a cell of 40 mm."""
    d, mu = 1e-3, 0.1
    n = 1 - np.pi / 6 * d**3 / 0.04**3

    def rate(_, v):
        k = float(drag.ergun_wen_yu(n, abs(v[0]), d, mu / RHO, RHO))
        return [((RHO - rho_p) * G - k * v[0]) / (rho_p + cm * RHO)]
    return solve_ivp(rate, (0, t[-1]), [0.0], t_eval=t, rtol=1e-9, atol=1e-13).y[0]


def suspension(t, rho_p, phi, cm=CM):
    """Velocity [m/s] of spheres of 2 mm in water in a closed column: what rises,
    (1 - n) v, comes down as n U. With the pressure taken out of both equations

        (rho_p + rho (1 - n)/n + Cm rho/n^2) dv/dt = (rho - rho_p) g - k v/n^2."""
    d, mu, n = 2e-3, 8.94e-4, 1 - phi

    def rate(_, v):
        k = float(drag.ergun_wen_yu(n, abs(v[0]) / n, d, mu / RHO, RHO))
        return [((RHO - rho_p) * G - k * v[0] / n**2) / (rho_p + RHO * phi / n + cm * RHO / n**2)]
    return solve_ivp(rate, (0, t[-1]), [0.0], t_eval=t, rtol=1e-9, atol=1e-13).y[0]


def column(where, density, forces, steps, *more):
    words = [w for s in ("top=wall", "stagger=1", "across_z=23", "dem_step=1e-5", "end=0.02", f"density={density}",
                         f"forces={forces}", f"coupling_steps={steps}", *more) for w in ("--set", s)]
    folder = coupled.finished("lattice-scene", os.path.join("added-mass", where), "--no-pictures", *words)
    m = coupled.columns(os.path.join(folder, "DEM", "means.csv"))
    return folder, np.array(m["t"]), np.array(m["v_middle"])


def run(checks):
    lines = []
    folder = coupled.finished("added-mass", os.path.join("added-mass", "alone"), "--no-pictures")
    m = coupled.columns(os.path.join(folder, "DEM", "speeds.csv"))
    t = np.array(m["t"])
    for key, rho_p in RATIOS.items():
        v, exact = np.array(m[key]), alone(t, rho_p)
        worst = np.abs(v - exact).max() / np.abs(exact).max()
        checks.at_most(f"density ratio {rho_p / RHO:g}: largest error of v(t) over v at the end", float(worst), 0.01)
        checks.close(f"density ratio {rho_p / RHO:g}: acceleration at the start [m/s2]", v[0] / t[0], exact[0] / t[0],
                     0.01)
        lines += [(f"alone, {rho_p / RHO:g}", t, v / exact[-1], "line"), (None, t, exact / exact[-1], "dashed")]
    checks.at_most("largest residual of the ledger of momentum", coupled.summary(folder)["max_momentum_residual"],
                   1e-10)

    with_it, phi = "pressureGradient+buoyancy+addedMass", 4 / 3 * np.pi * 1e-9 / 2.4e-3**3
    dense = []
    for name, density, forces, cm, gate in (("heavy", 2600, with_it, CM, 0.01),
                                            ("heavy-without", 2600, "pressureGradient+buoyancy", 0.0, 0.01),
                                            ("light-2", 100, with_it, CM, 0.01)):
        folder, t, v = column(name, density, forces, 2 if name == "light-2" else 10)
        exact = suspension(t, density, phi, cm)
        worst = float(np.abs(v - exact).max() / np.abs(exact).max())
        checks.at_most(f"solid fraction 0.3, ratio {density / RHO:g}{'' if cm else ', without added mass'}: "
                       "largest error of v(t)", worst, gate)
        dense += [(f"ratio {density / RHO:g}, Cm {cm:g}", t, v, "line"), (None, t, exact, "dashed")]
    errors = {2: worst}
    for steps in (4, 8):
        folder, t, v = column(f"light-{steps}", 100, with_it, steps)
        exact = suspension(t, 100, phi)
        errors[steps] = float(np.abs(v - exact).max() / np.abs(exact).max())
    checks.close("ratio 0.1: order of the error in the coupling interval", np.log2(errors[8] / errors[2]) / 2, 1.0, 0.2)
    folder, t, v = column("lightest", 1, with_it, 20)
    checks.at_most("ratio 0.001: largest speed, over the end's", float(np.abs(v).max() / suspension(t, 1, phi)[-1]),
                   1.05)
    checks.close("ratio 0.001: speed at the end [m/s]", v[-1], suspension(t, 1, phi)[-1], 0.02)
    # G of Foam::particleSums::follow is four times the inertia there
    packed = ("spacing=2.1e-3", "size_x=0.0168", "size_y=0.0168", "size_z=0.0504")
    phi_packed = 4 / 3 * np.pi * 1e-9 / 2.1e-3**3
    fast = np.abs(column("packed", 1, with_it, 20, *packed)[2]).max()
    checks.at_most("ratio 0.001 at a solid fraction of 0.45: largest speed, over the end's",
                   float(fast / suspension(t, 1, phi_packed)[-1]), 1.1)
    dense += [("ratio 0.001, Cm 0.5", t, v, "line"), (None, t, suspension(t, 1, phi), "dashed")]

    where = os.path.join(coupled.RUNS, "added-mass")
    checks.picture(plots.compare(os.path.join(where, "alone.png"), lines, "t [s]", "v over v at the end",
                                 "spheres alone, by density ratio; dashed: equation of motion"))
    checks.picture(plots.compare(os.path.join(where, "dense.png"), dense, "t [s]", "v [m/s]",
                                 "closed column, solid fraction 0.3; dashed: equation of motion"))
