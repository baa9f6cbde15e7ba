# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""One sphere from rest, against formulas that others' tests use."""

import os

import numpy as np

from cases.lib.theory import drag
from validation.lib.checks import plots, single_sphere
from validation.lib.checks.coupled import RUNS
from validation.lib.checks.reference import table

TITLE = "one sphere from rest: CFDEM's settling test, CPL's Stokes column, Xiao and Sun's particle"
LONG = True
FREE = {"frames": 2, "curve_rows": 200, "self_disturbance": "latticeMemory"}


def _worst(checks, name, folder, t, v, gate=0.01):
    """Largest difference of the fall velocity from v over the largest v."""
    time, _, speed = single_sphere.path(folder)
    found = np.interp(t, time, -speed)
    checks.at_most(f"{name}: largest difference over the last velocity",
                   float(np.max(np.abs(found - v)) / v[-1]), gate)
    checks.close(f"{name}: last velocity", float(found[-1]), float(v[-1]), gate)
    return found


def run(checks):
    series = []

    ref = table("cfdem_settlingtest_formula")
    t = np.asarray(ref["time_s"])
    chosen = (t > 1e-3) & (t <= 0.15)
    for law, column in (("SchillerNaumann", "v_SN_m_per_s"), ("DiFelice", "v_DiFelice_m_per_s")):
        for form in ("A", "B"):
            folder = single_sphere.run(f"settling-formulas/cfdem-{law}-{form}", size_x=0.1, size_y=0.1, size_z=0.1,
                                       cells_x=10, cells_y=10, cells_z=10, sphere_radius=5e-5, density=3000,
                                       fluid_density=10, viscosity=1e-4, at_z=0.6, end=0.15, dem_step=1e-5,
                                       coupling_steps=100, drag=law, model=form, void_fraction="divided", **FREE)
            v = np.asarray(ref[column])[chosen]
            found = _worst(checks, f"CFDEM's test, {law}, model {form}", folder, t[chosen], v)
        series += [(f"{law}: formula", t[chosen], v, "dashed"), (law, t[chosen], found, "line")]

    ref = table("cpl_terminal_stokes_formula")
    for k, d in enumerate(np.asarray(ref["d_m"])):
        tau, last = ref["tau_s"][k], ref["v_terminal_Stokes_m_per_s"][k]
        folder = single_sphere.run(f"settling-formulas/stokes-{1e6 * d:.0f}um", size_x=2e-3, size_y=2e-3, size_z=2e-2,
                                   cells_x=2, cells_y=2, cells_z=20, sides="slip", sphere_radius=0.5 * float(d),
                                   density=2650, viscosity=1e-3, at_z=0.9, end=0.05, dem_step=1e-5, coupling_steps=50,
                                   drag="Stokes", **{**FREE, "self_disturbance": "none", "frozen_fluid": "yes"})
        time = np.linspace(2.5e-3, 0.05, 20)
        exact = last * (1 - np.exp(-time / tau))
        _worst(checks, f"Stokes, frozen, d {1e6 * d:.0f} um", folder, time, exact)
        _, z, _ = single_sphere.path(folder)
        checks.close(f"Stokes, frozen, d {1e6 * d:.0f} um: way in 0.05 s", float(z[0] - z[-1]),
                     float(ref["y_fall_at_0.05s_m"][k]), 0.01)

    # Xiao and Sun's particle, from rest in a stream without gravity
    d, rho_p, nu, stream = 8.3e-5, 2000.0, 1e-6, 0.05
    folder = single_sphere.run("settling-formulas/xiao-sun", size_x=4e-3, size_y=4e-3, size_z=4e-3, cells_x=10,
                               cells_y=10, cells_z=10, sides="slip", bottom="inlet", inlet_velocity=stream,
                               start_velocity=stream, gravity=0, sphere_radius=0.5 * d, density=rho_p, viscosity=1e-3,
                               at_z=0.3, end=0.006, dem_step=5e-6, coupling_steps=4, drag="SyamlalOBrien", rows=1200,
                               **{k: v for k, v in FREE.items() if k != "rows"})
    time, v = [0.0], [0.0]
    while time[-1] < 6e-3:
        def rate(u):
            return float(drag.syamlal_obrien(1.0, stream - u, d, nu, 1000.0)) * (stream - u) / rho_p
        h, u = 1e-6, v[-1]
        middle = u + 0.5 * h * rate(u)
        v.append(u + h * rate(middle))
        time.append(time[-1] + h)
    at = np.linspace(2e-4, 6e-3, 30)
    t, _, speed = single_sphere.path(folder)
    law = np.interp(at, time, v)
    found = np.interp(at, t, speed)
    checks.at_most("Xiao and Sun, SyamlalOBrien: largest difference over the stream's velocity",
                   float(np.max(np.abs(found - law)) / stream), 0.01)
    others = table("xiao_sun_single_particle_acceleration")
    who = np.array(others["series"])
    at, known = np.asarray(others["time_s"]), np.asarray(others["velocity_m_per_s"])
    mine = (who == "XiaoSun2011") & (at > 0)
    checks.close("Xiao and Sun 2011, digitised: last velocity", float(speed[-1]), float(known[mine][-1]), 0.02)
    checks.picture(plots.compare(os.path.join(RUNS, "settling-formulas", "xiao-sun.png"),
                                 [("coupled run", t, speed, "line"), ("law that runs", time, v, "dashed"),
                                  ("Xiao and Sun 2011", at[mine], known[mine], "dots")],
                                 "time / s", "velocity / (m/s)", "one particle from rest in a stream, SyamlalOBrien"))

    checks.picture(plots.compare(os.path.join(RUNS, "settling-formulas", "velocity.png"), series, "time / s",
                                 "fall velocity / (m/s)", "CFDEM's settling test: one sphere, d 0.1 mm, from rest"))
