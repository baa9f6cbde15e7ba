# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Two charges: circular and eccentric orbits, a fall to contact, a flight apart."""

import os

import numpy as np

from validation.lib.checks import coupled, plots, reference

TITLE = "two charges: orbits, fall and flight"
COULOMB = 8.9875517873681764e9


def track(where, row, v, other, time, steps, rows=400, **more):
    """Distance vector, velocity difference, times and the energies [J]."""
    folder = coupled.dem("coulomb-orbit", "coulomb-orbit/" + where, m=repr(row["m"]), q=repr(row["q"]),
                         eps=repr(row["eps"]), other=repr(other), r0=repr(row["r0"]), diameter=repr(row["s"]),
                         v=repr(v), dt=repr(time / steps), steps=steps, every=max(1, steps // rows),
                         cutoff=repr(8 * row["r0"]), **more)
    t = {k: np.array(x) for k, x in coupled.columns(os.path.join(folder, "DEM", "trajectory.csv")).items()}
    apart = np.array([t["x2"] - t["x1"], t["y2"] - t["y1"]])
    rate = np.array([t["vx2"] - t["vx1"], t["vy2"] - t["vy1"]])
    kinetic = 0.5 * row["m"] * (t["vx1"] ** 2 + t["vy1"] ** 2 + t["vx2"] ** 2 + t["vy2"] ** 2)
    return apart, rate, t["time_s"], kinetic + COULOMB * row["q"] * other / row["eps"] / np.hypot(*apart)


def run(checks):
    r = reference.table("coulomb_two_body_formula")
    curves = []
    for k in range(len(r["m_kg"])):
        row = {"m": r["m_kg"][k], "q": r["q_C"][k], "eps": r["eps_r"][k], "r0": r["r0_m"][k], "s": r["contact_m"][k]}
        name = f"{row['m']:.3g} kg, {row['q']:.3g} C, eps_r {row['eps']:g}"
        T, v = r["T_circular_s"][k], r["v_each_circular_m_per_s"][k]
        for kind, start, steps in (("circular", v, 8000), ("eccentric", v * np.sqrt(2 / 3), 20000)):
            # from the far end of an ellipse of axis a: v2 = (2/r - 1/a)
            period = T * (1 if kind == "circular" else (2 - start ** 2 / v ** 2) ** -1.5)
            apart, rate, time, energy = track(f"{kind}-{k}", row, start, -row["q"], 1.02 * period, steps)
            angle = np.unwrap(np.arctan2(apart[1], apart[0]))
            checks.close(f"{name}, {kind}: period [s]", np.interp(2 * np.pi, angle, time), period, 1e-3)
            turn = time <= period
            checks.close(f"{name}, {kind}: energy after an orbit [J]", energy[turn][-1], energy[0], 1e-6)
            if k == 0:
                curves += [(kind, apart[0] / row["r0"], apart[1] / row["r0"], "line")]
                a = 1 / (2 - start ** 2 / v ** 2)
                e = 1 / a - 1
                phi = np.linspace(0, 2 * np.pi, 60)
                radius = a * (1 - e * e) / (1 - e * np.cos(phi))
                curves += [(f"{kind}, exact", radius * np.cos(phi), radius * np.sin(phi), "dots")]
        # from rest to contact, and 5 r0 apart
        close = row["s"] / row["r0"]
        fall = T / (2 * np.pi * np.sqrt(2)) * (np.arccos(np.sqrt(close)) + np.sqrt(close * (1 - close)))
        apart, rate, time, energy = track(f"fall-{k}", row, 0.0, -row["q"], 1.001 * fall, 10000, rows=10000)
        distance = np.hypot(*apart)
        n = np.flatnonzero(distance <= row["s"])[0]
        at = [distance[n], distance[n - 1]]
        checks.close(f"{name}, fall: time to contact [s]", np.interp(row["s"], at, [time[n], time[n - 1]]), fall, 1e-3)
        speed = -rate[0] / 2
        checks.close(f"{name}, fall: speed of each at contact [m/s]", np.interp(row["s"], at, [speed[n], speed[n - 1]]),
                     r["v_each_at_contact_m_per_s"][k], 1e-3)
        apart, rate, time, energy = track(f"flight-{k}", row, 0.0, row["q"], 0.5 * T, 8000)
        reached = np.hypot(*apart)[-1]
        checks.close(f"{name}, flight: speed of each far away [m/s]",
                     np.hypot(*rate)[-1] / 2 / np.sqrt(1 - row["r0"] / reached),
                     r["v_each_infinity_repulsive_m_per_s"][k], 1e-3)
        checks.close(f"{name}, flight: energy [J]", energy[-1], energy[0], 1e-6)
    checks.picture(plots.compare(os.path.join(coupled.RUNS, "coulomb-orbit", "orbits.png"), curves,
                                 "x/r0", "y/r0", "one charge seen from the other"))
