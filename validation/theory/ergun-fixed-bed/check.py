# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure drop and onset of fluidisation of a uniform bed against Ergun's equation."""

import os

import numpy as np

from validation.lib.checks import coupled, fields, plots, reference

TITLE = "uniform bed of porosity 0.451: pressure drop and u_mf against Ergun"

_FLOOR, _LAYER = 2, 12          # cells below the bed; of 1.3 mm in the table's 15.6 mm
_RHO, _WEIGHT = 10.0, 167.0913  # kg/m3; buoyant weight of 15.6 mm of bed [Pa]
_UMF = 0.014509                 # where Ergun's drop is that [m/s]


def _drops(folder):
    """Inlet velocity [m/s] and drop over 15.6 mm inside of the bed [Pa], by time."""
    t, _, inlet = fields.inlet(folder)
    cells = len(fields.centres(folder))
    rows = []
    for time, at in fields.times(folder):
        if time > 0:
            p = fields.field(at, "p", cells)
            first = _FLOOR + 4
            rows.append((np.interp(time, t, inlet), _RHO * (p[first] - p[first + _LAYER])))
    return np.array(rows).T


def _free(speed):
    """Time and mean upward velocity of the bed's inner spheres, let go under a
    steady flow; by its end they drift as fast as the flow lets them."""
    folder = coupled.finished("fixed-bed-scene", f"ergun-fixed-bed/free-{speed:.6f}", "--end", "0.008",
                              *_set(held=0, velocity_from=speed, velocity_to=speed, start_velocity=speed))
    rise = coupled.columns(os.path.join(folder, "DEM", "rise.csv"))
    return rise["time_s"], rise["velocity_m_per_s"]


def _set(**values):
    return [w for k, x in values.items() for w in ("--set", f"{k}={x}")]


def run(checks):
    law = reference.table("ergun_fixedbed_formula")
    folder = coupled.finished("fixed-bed-scene", "ergun-fixed-bed/ramp")
    speed, drop = _drops(folder)
    for u, dp in zip(law["U_m_per_s"], law["dp_Pa"]):
        k = int(np.argmin(abs(speed - u)))
        checks.close(f"drop at {u:.3f} m/s [Pa]", drop[k] * u / speed[k], dp, 0.02)
    onset = float(np.interp(_WEIGHT, drop, speed))
    checks.close("u_mf, where the drop is the buoyant weight [m/s]", onset, _UMF, 0.03)

    low, high = _free(0.97 * _UMF), _free(1.03 * _UMF)
    checks.at_most("let go at 0.97 u_mf: velocity upwards after 8 ms [m/s]", low[1][-1], -1e-4)
    checks.at_least("let go at 1.03 u_mf: the same [m/s]", high[1][-1], 1e-4)

    where = os.path.join(coupled.RUNS, "ergun-fixed-bed")
    checks.picture(plots.compare(
        os.path.join(where, "drop.png"),
        [("Ergun", law["U_m_per_s"], law["dp_Pa"], "dashed"), ("clayFoam", speed, drop, "dots"),
         ("buoyant weight", [0, 0.02], [_WEIGHT, _WEIGHT], "line")],
        "superficial velocity [m/s]", "drop over 15.6 mm [Pa]", "held bed, porosity 0.451"))
    checks.picture(plots.compare(
        os.path.join(where, "free.png"),
        [("0.97 u_mf", *low, "line"), ("1.03 u_mf", *high, "line")],
        "time [s]", "mean velocity, upwards [m/s]", "the same spheres, let go"))
