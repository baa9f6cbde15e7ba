# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Density and viscosity of water at atmospheric pressure, 0 to 60 C.

Temperatures in C, of any shape; ValueError outside 0 ... 60 C.
"""

import argparse
import sys

import numpy as np

#: Range of temperature [C] that is taken.
RANGE = (0.0, 60.0)


def _checked(temperature):
    t = np.asarray(temperature, dtype=float)
    if not np.all((t >= RANGE[0]) & (t <= RANGE[1])):
        raise ValueError(f"temperature = {temperature} should lie between "
                         f"{RANGE[0]:g} and {RANGE[1]:g} C")
    return t


def density(temperature):
    """Density of air-free water [kg/m3].

    Kell (1975), J. Chem. Eng. Data 20, 97-105: a polynomial of degree 5 over
    one of degree 1, good to 1e-3 kg/m3 between 0 and 60 C.
    """
    t = _checked(temperature)
    top = np.polynomial.polynomial.polyval(
        t, [999.83952, 16.945176, -7.9870401e-3, -46.170461e-6,
            105.56302e-9, -280.54253e-12])
    return top / (1.0 + 16.879850e-3 * t)


def dynamic_viscosity(temperature):
    """Dynamic viscosity [Pa s].

    IAPWS SR6-08 (2011), liquid water at 0.1 MPa (Patek, Hruby, Klomfar,
    Souckova, Harvey 2009, J. Phys. Chem. Ref. Data 38, 21-29), good to 1 %:
    1e-6 sum a_i (T/300 K)^b_i.
    """
    x = (_checked(temperature) + 273.15) / 300.0
    a = (280.68, 511.45, 61.131, 0.45903)
    b = (-1.9, -7.7, -19.6, -40.0)
    return 1e-6 * sum(ai * x**bi for ai, bi in zip(a, b))


def kinematic_viscosity(temperature):
    """Kinematic viscosity [m2/s], dynamic_viscosity/density."""
    return dynamic_viscosity(temperature) / density(temperature)


def main(arguments=None):
    """`python3 -m theory.water 21.5`: density, viscosities."""
    parser = argparse.ArgumentParser(
        prog="theory.water", description="Density and viscosity of water.")
    parser.add_argument("temperature", type=float, help="temperature [C]")
    t = parser.parse_args(arguments).temperature
    try:
        print(f"rho {density(t):.3f} kg/m3  mu {dynamic_viscosity(t):.5e} Pa s"
              f"  nu {kinematic_viscosity(t):.5e} m2/s at {t:g} C")
    except ValueError as error:
        print(f"theory.water: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
