# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A column of touching spheres in an upward flow: drop, compression, onset."""

import os

import numpy as np

from validation.lib.checks import coupled, fields, plots, reference

TITLE = "column of 100 touching spheres: pressure drop, compression and u_mf"
LONG = True

_RHO, _LENGTH = 1000.0, 0.1  # kg/m3, m
# the superficial velocities between which the column leaves the plate [m/s]
_ONSET = {"Ergun": (0.0160, 0.0165, 0.016337), "DiFelice": (0.0185, 0.0190, 0.018691)}


def _run(name, *settings):
    folder = coupled.finished("umf-column", f"umf-column/{name}", *[w for x in settings for w in ("--set", x)])
    return folder, {k: np.array(v) for k, v in coupled.columns(os.path.join(folder, "DEM", "places.csv")).items()}


def run(checks):
    law = reference.table("cpl_column_umf_formula")
    u = law["U_superficial_m_per_s"]
    rest = abs(law["top_displacement_Ergun_m"][0])
    drops, heads = [], []
    for drag, (low, high, onset) in _ONSET.items():
        folder, places = _run(drag, f"drag={drag}")
        t, p, _ = fields.inlet(folder)
        use = (u > 0.001) & (u < 0.015) & (np.round(1e3 * u) % 2 == 0)
        ends = np.round(1e3 * u[use]) / 20 + 0.099  # of the steps of 2 mm/s, 0.1 s each
        dp = np.interp(ends, t, _RHO * p)
        wanted = law[f"dpdz_{drag}_Pa_per_m"] * _LENGTH
        checks.at_most(f"{drag}: drop, largest relative error", float(np.max(abs(dp / wanted[use] - 1))), 0.02)
        head = np.interp(ends, places["time_s"], places["head_m"])
        sunk = law[f"top_displacement_{drag}_m"]
        checks.at_most(f"{drag}: top sphere's place, largest error over that at rest",
                       float(np.max(abs(head - sunk[use])) / rest), 0.02)
        feet = []
        for speed in (low, high):
            _, still = _run(f"{drag}-{speed:g}", f"drag={drag}", "end=0.3", f"velocity_from={speed}",
                            f"velocity_to={speed}", f"start_velocity={speed}")
            feet.append(still["foot_m"][-1])
        checks.true(f"{drag}: rests on the plate at {low:g} m/s", feet[0] < 0, f"{feet[0]:.3g} m", "below 0")
        checks.true(f"{drag}: has left the plate at {high:g} m/s", feet[1] > 0, f"{feet[1]:.3g} m", "above 0")
        # where the drop of the steps reaches the buoyant weight, drawn on as Ergun's form a U + b U2
        a, b = np.linalg.lstsq(np.column_stack([u[use], u[use]**2]), dp, rcond=None)[0]
        weight = 8475.23158 * _LENGTH
        checks.close(f"{drag}: u_mf from the steps [m/s]", (np.sqrt(a * a + 4 * b * weight) - a) / (2 * b), onset, 0.03)
        drops += [(f"{drag}, law", u, wanted, "dashed"), (drag, u[use], dp, "dots")]
        heads += [(f"{drag}, theory", u[use], sunk[use] * 1e3, "dashed"), (drag, u[use], head * 1e3, "dots")]
    where = os.path.join(coupled.RUNS, "umf-column")
    checks.picture(plots.compare(os.path.join(where, "drop.png"), drops, "superficial velocity [m/s]",
                                 "pressure drop [Pa]", "column of 100 touching spheres"))
    checks.picture(plots.compare(os.path.join(where, "head.png"), heads, "superficial velocity [m/s]",
                                 "displacement of the top sphere [mm]", "column of 100 touching spheres"))
