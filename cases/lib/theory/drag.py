# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Drag laws as the coefficient beta/(1 - n) of model A, in kg/(m3 s).

The force on a sphere of volume V is F_D = V coefficient (u - v), with the
interstitial fluid velocity u; the pressure gradient force is a force of its
own. A sphere alone in Stokes flow has 18 mu/d2. Every law is a pure function

    law(n, slip, d, nu, rho) -> coefficient, arrays that broadcast

n     void fraction, 0 < n <= 1
slip  abs(u - v), interstitial [m/s]
d     sphere diameter [m]
nu    kinematic viscosity of the fluid [m2/s]
rho   density of the fluid [kg/m3]

Where a source gives F = drag proper/(3 pi mu d U) with the superficial slip
U = n slip, the coefficient is n F 18 mu/d2; where its F holds the share of
the pressure gradient too, it is n^2 F 18 mu/d2.
"""

import difflib

import numpy as np


def reynolds(n, slip, d, nu):
    """Reynolds number n slip d/nu of the superficial slip (Eq. 9)."""
    return n * slip * d / nu


def stokes(d, nu, rho):
    """Coefficient of a single sphere in Stokes flow, 18 mu/d2 [kg/(m3 s)]."""
    return 18.0 * nu * rho / d**2


def sphere(re, newton_cd):
    """C_D Re/24 of Schiller and Naumann (1933), Z. Ver. Dtsch. Ing. 77,
    318-320 (Eq. 10), with the constant newton_cd above Re = 1000."""
    re = np.asarray(re, dtype=float)
    return np.where(re > 1000.0, newton_cd * re / 24.0,
                    1.0 + 0.15 * np.minimum(re, 1000.0) ** 0.687)


def ergun(n, slip, d, nu, rho):
    """Ergun (1952), Chem. Eng. Prog. 48, 89-94: Eq. 8 below n = 0.8."""
    re = reynolds(n, slip, d, nu)
    return nu * rho / (d**2 * n) * (150.0 * (1.0 - n) + 1.75 * re)


def wen_yu(n, slip, d, nu, rho, exponent=-2.7, newton_cd=0.43):
    """Wen and Yu (1966), Chem. Eng. Prog. Symp. Ser. 62, 100-111: Eq. 8
    from n = 0.8 on with the paper's exponent and C_D above Re = 1000."""
    re = reynolds(n, slip, d, nu)
    return stokes(d, nu, rho) * n**exponent * sphere(re, newton_cd)


def wen_yu_everywhere(n, slip, d, nu, rho):
    """Wen and Yu's law as the solver's WenYu has it: n^-2.65 at any n,
    C_D = 0.44 above Re = 1000."""
    return wen_yu(n, slip, d, nu, rho, -2.65, 0.44)


def ergun_wen_yu(n, slip, d, nu, rho):
    """Eqs 8 to 10 to the letter, with their jump at n = 0.8."""
    return np.where(n < 0.8, ergun(n, slip, d, nu, rho),
                    wen_yu(n, slip, d, nu, rho))


def ergun_wen_yu_blended(n, slip, d, nu, rho, width=0.1):
    """Eqs 8 to 10, one branch passing into the other over `width` in n
    about n = 0.8 by 10 x^3 - 15 x^4 + 6 x^5."""
    x = np.clip((n - 0.8) / width + 0.5, 0.0, 1.0)
    s = x**3 * (10.0 - 15.0 * x + 6.0 * x**2)
    return ((1.0 - s) * ergun(n, slip, d, nu, rho)
            + s * wen_yu(n, slip, d, nu, rho))


def schiller_naumann(n, slip, d, nu, rho):
    """A sphere alone whatever n (Schiller and Naumann 1933): Re holds the
    interstitial slip, C_D = 0.44 above Re = 1000."""
    return stokes(d, nu, rho) * sphere(slip * d / nu + 0.0 * n, 0.44)


def gidaspow(n, slip, d, nu, rho):
    """Gidaspow (1994), Multiphase Flow and Fluidization, Academic Press:
    Ergun below n = 0.8, Wen and Yu with n^-2.65 and C_D = 0.44 above
    Re = 1000 otherwise; jumps at n = 0.8."""
    return np.where(n < 0.8, ergun(n, slip, d, nu, rho),
                    wen_yu(n, slip, d, nu, rho, -2.65, 0.44))


def di_felice(n, slip, d, nu, rho):
    """Di Felice (1994), Int. J. Multiphase Flow 20, 153-159."""
    re = reynolds(n, slip, d, nu)
    x = 1.5 - np.log10(np.maximum(re, 1e-30))
    chi = 3.7 - 0.65 * np.exp(-0.5 * x**2)
    return (0.75 * nu * rho / d**2 * (0.63 * np.sqrt(re) + 4.8) ** 2
            * n ** (1.0 - chi))


def beetstra(n, slip, d, nu, rho):
    """Beetstra, van der Hoef, Kuipers (2007), AIChE J. 53, 489-501, one
    particle size; F is the drag proper."""
    phi = np.maximum(1.0 - n, 0.0)
    re = np.maximum(reynolds(n, slip, d, nu), 1e-12)
    f0 = 10.0 * phi / n**2 + n**2 * (1.0 + 1.5 * np.sqrt(phi))
    f_re = (0.413 * re / (24.0 * n**2)
            * (1.0 / n + 3.0 * n * phi + 8.4 * re**-0.343)
            / (1.0 + 10.0 ** (3.0 * phi) * re ** (-0.5 - 2.0 * phi)))
    return stokes(d, nu, rho) * n * (f0 + f_re)


def koch_hill(n, slip, d, nu, rho):
    """Hill, Koch, Ladd (2001), J. Fluid Mech. 448, 213-241 and 243-278;
    F holds the share of the pressure gradient."""
    phi = np.maximum(1.0 - n, 0.0)
    re = reynolds(n, slip, d, nu)
    log_phi = np.log(np.maximum(phi, 1e-300))
    dilute = ((1.0 + 3.0 * np.sqrt(phi / 2.0) + 135.0 / 64.0 * phi * log_phi
               + 16.14 * phi)
              / (1.0 + 0.681 * phi - 8.48 * phi**2 + 8.16 * phi**3))
    f0 = np.where(phi < 0.4, dilute, 10.0 * phi / n**3)
    f3 = 0.0673 + 0.212 * phi + 0.0232 / n**5
    return stokes(d, nu, rho) * n**2 * (f0 + 0.5 * f3 * re)


def stokes_law(n, slip, d, nu, rho):
    """Stokes's drag on a sphere alone, whatever n and Re."""
    return stokes(d, nu, rho) + 0.0 * n * slip


def syamlal_obrien(n, slip, d, nu, rho):
    """Syamlal and O'Brien (1987), DOE/METC/94-1004, with V_r of Garside and
    Al-Dibouni (1977); Re holds the interstitial slip."""
    re = slip * d / nu
    a = n**4.14
    b = np.where(n <= 0.85, 0.8 * n**1.28, n**2.65)
    x = 0.06 * re
    vr = 0.5 * (a - x + np.sqrt(x**2 + 2.0 * x * (2.0 * b - a) + a**2))
    return (0.75 * n * nu * rho / d**2 / vr**2
            * (0.63 * np.sqrt(re) + 4.8 * np.sqrt(vr)) ** 2)


#: The solver's names of the laws (dragModel in couplingProperties).
LAWS = {
    "ergunWenYu": ergun_wen_yu,
    "ergunWenYuBlended": ergun_wen_yu_blended,
    "SchillerNaumann": schiller_naumann,
    "Gidaspow": gidaspow,
    "DiFelice": di_felice,
    "Beetstra": beetstra,
    "KochHill": koch_hill,
    "WenYu": wen_yu_everywhere,
    "Ergun": ergun,
    "Stokes": stokes_law,
    "SyamlalOBrien": syamlal_obrien,
}

#: Solid fractions at which a law jumps.
JUMPS = {"ergunWenYu": (0.2,), "Gidaspow": (0.2,), "KochHill": (0.4,)}


def law(name_or_function):
    """The law of that name, or the function given. ValueError lists the
    names and the nearest one when there is none."""
    if callable(name_or_function):
        return name_or_function
    if name_or_function not in LAWS:
        near = difflib.get_close_matches(str(name_or_function), LAWS, 1, 0.0)
        raise ValueError(
            f"dragModel {name_or_function} is not known; nearest is {near[0]},"
            f" known are {' '.join(sorted(LAWS))}")
    return LAWS[name_or_function]


def balance_slip(drag_law, n, d, nu, rho, drho, g=9.81):
    """Interstitial slip [m/s] at which drag carries a uniform suspension.

    The dynamic pressure gradient of the mixture takes (1 - n) of the buoyant
    weight, drag the rest: coefficient(n, slip) slip = n drho g. Solved by
    bisection in log(slip), to 1e-14. n of any shape; drho = rho_p - rho > 0
    [kg/m3]. Where C_D jumps (Re = 1000) the slip at the change of sign is
    given.
    """
    coefficient = law(drag_law)
    n = np.asarray(n, dtype=float)
    if np.any(n <= 0.0) or np.any(n > 1.0):
        raise ValueError(f"n = {n} should be above 0 and at most 1")
    for name, value in (("d", d), ("nu", nu), ("rho", rho), ("drho", drho),
                        ("g", g)):
        if not value > 0.0:
            raise ValueError(f"{name} = {value} should be positive")
    weight = n * drho * g
    tiny = 1e-12 * nu / d

    def excess(log_slip):
        slip = np.exp(log_slip)
        return coefficient(n, slip, d, nu, rho) * slip - weight

    high = np.log(1.01 * weight / coefficient(n, tiny, d, nu, rho))
    while np.any(excess(high) < 0.0):
        high = np.where(excess(high) < 0.0, high + 0.5, high)
    low = high - 1.0
    while np.any(excess(low) > 0.0):
        low = np.where(excess(low) > 0.0, low - 1.0, low)
    for _ in range(60):
        middle = 0.5 * (low + high)
        above = excess(middle) > 0.0
        high = np.where(above, middle, high)
        low = np.where(above, low, middle)
    return np.exp(0.5 * (low + high))


def terminal_velocity(d, rho_p, rho_f, mu, g=9.81, drag_law="SchillerNaumann"):
    """Terminal velocity [m/s] of a single sphere, downwards positive, by a
    drag law at n = 1; d [m] a number, densities [kg/m3], mu [Pa s]."""
    drho = rho_p - rho_f
    if drho == 0.0:
        return 0.0
    slip = balance_slip(drag_law, 1.0, d, mu / rho_f, rho_f, abs(drho), g)
    return float(np.sign(drho) * slip)
