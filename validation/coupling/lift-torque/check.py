# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Lift and torque on a sphere: in plane shear in three planes, and spinning in a
fluid at rest, against the laws' own equations of motion."""

import os

import numpy as np
from scipy.integrate import solve_ivp

from validation.lib.checks import coupled, plots

TITLE = "lift and torque on one sphere, three shear planes, against Saffman-Mei, Rubinow-Keller and Kirchhoff"

D, RHO_P, RHO, MU, SHEAR, SPEED, SPIN = 1e-3, 2000.0, 1000.0, 0.1, 100.0, 0.2, 2000.0
NU, MASS = MU / RHO, RHO_P * np.pi / 6 * D**3
RATE = 60 * MU / (RHO_P * D**2)  # of the spin: pi mu d^3 over m d^2/10

# flow: axis along which it streams, axis along which it grows, axis of its vorticity with the sign
PLANES = {"xz": (0, 2, 1, 1), "yx": (1, 0, 2, 1), "zy": (2, 1, 0, 1)}


def drag(v):
    re = np.linalg.norm(v) * D / NU
    return -3 * np.pi * MU * D * (1 + 0.15 * re**0.687) * v


def saffman(v, w, mei):
    """6.46 mu a^2 sqrt(|w|/nu) s, with Mei's factor for Re <= 40."""
    s = -v
    speed, curl = np.linalg.norm(s), np.linalg.norm(w)
    re, beta = speed * D / NU, 0.5 * D * curl / speed
    g = 0.3314 * np.sqrt(beta)
    f = (1 - g) * np.exp(-re / 10) + g if mei else 1.0
    return 6.46 * MU * (D / 2)**2 * np.sqrt(curl / NU) * f * np.cross(s, w / curl)


def rubinow_keller(v, w):
    return np.pi * (D / 2)**3 * RHO * np.cross(w, v)


def marched(t, v0, w0, curl, lift):
    """Velocity and spin at times t."""
    def rate(_, y):
        v, w = y[:3], y[3:]
        return np.concatenate([(drag(v) + lift(v, w)) / MASS, RATE * (curl / 2 - w)])
    found = solve_ivp(rate, (0, t[-1]), np.concatenate([v0, w0]), t_eval=t, rtol=1e-9, atol=1e-12)
    return found.y[:3], found.y[3:]


def motion(where, *settings):
    words = [w for s in settings for w in ("--set", s)]
    folder = coupled.finished("lift-torque", os.path.join("lift-torque", where), "--no-pictures", *words)
    m = {k: np.array(c) for k, c in coupled.columns(os.path.join(folder, "DEM", "motion.csv")).items()}
    return m["t"], np.array([m["vx"], m["vy"], m["vz"]]), np.array([m["wx"], m["wy"], m["wz"]])


def run(checks):
    lines = []
    for plane, (along, across, about, sign) in PLANES.items():
        v0, curl = np.zeros(3), np.zeros(3)
        v0[along], curl[about] = -SPEED, sign * SHEAR
        t, v, w = motion(plane, f"shear={plane}", f"speed_{'xyz'[along]}={-SPEED}")
        rv, rw = marched(t, v0, np.zeros(3), curl, lambda v, w: saffman(v, curl, True))
        checks.true(f"plane {plane}: a sphere that lags is lifted towards the faster fluid", v[across][-1] > 0)
        checks.close(f"plane {plane}: lift's velocity at 2 ms [m/s]", v[across][-1], rv[across][-1], 0.01)
        checks.close(f"plane {plane}: its rise at the start [m/s2]", v[across][0] / t[0], rv[across][0] / t[0], 0.01)
        checks.true(f"plane {plane}: the sphere turns with the fluid", w[about][-1] * sign > 0)
        checks.close(f"plane {plane}: spin at 2 ms [rad/s]", w[about][-1], rw[about][-1], 0.005)
        slope = np.polyfit(t[t < 6e-4], np.log(1 - w[about][t < 6e-4] / (sign * SHEAR / 2)), 1)[0]
        checks.close(f"plane {plane}: rate of the spin-up [1/s]", -slope, RATE, 0.005)
        # in the plane of the flow nothing points out of it
        checks.at_most(f"plane {plane}: other components over these", float(
            np.abs(v[about]).max() / np.abs(v[across]).max() +
            np.abs(np.delete(w, about, axis=0)).max() / np.abs(w[about]).max()), 1e-9)
        if plane == "xz":
            lines += [("lift, Saffman-Mei", t, v[across], "line"), (None, t, rv[across], "dashed")]

    # in a fluid at rest: Magnus lift while the spin decays
    for axis in range(3):
        v0, w0 = np.zeros(3), np.zeros(3)
        v0[axis], w0[(axis + 1) % 3] = SPEED, SPIN
        t, v, w = motion(f"spin-{'xyz'[axis]}", "shear=still", "forces=pressureGradient+magnus+torque",
                         f"speed_{'xyz'[axis]}={SPEED}", f"spin_{'xyz'[(axis + 1) % 3]}={SPIN}",
                         "coupling_steps=1", "end=1e-3")
        rv, rw = marched(t, v0, w0, np.zeros(3), lambda v, w: oesterle(v, w))
        side = (axis + 2) % 3
        checks.close(f"moving along {'xyz'[axis]}, spin about {'xyz'[(axis + 1) % 3]}: Magnus lift's velocity [m/s]",
                     v[side][-1], rv[side][-1], 0.01)
        checks.close("  spin left after 0.5 ms, of exp(-1.5)", w[(axis + 1) % 3][np.argmin(abs(t - 5e-4))] / SPIN,
                     np.exp(-RATE * 5e-4), 0.005)
        if axis == 0:
            lines += [("lift, Magnus, backwards", t, -v[side], "line"), (None, t, -rv[side], "dashed")]
    checks.picture(plots.compare(os.path.join(coupled.RUNS, "lift-torque", "lift.png"), lines, "t [s]",
                                 "sideways velocity [m/s]", "sideways motion; dashed: the law's own equation"))


def oesterle(v, w):
    """Rubinow and Keller's lift with Oesterle and Bui Dinh's coefficient."""
    re, spin = np.linalg.norm(v) * D / NU, np.linalg.norm(w) * D**2 / NU
    c = 0.45 + (spin / re - 0.45) * np.exp(-0.05684 * spin**0.4 * re**0.3)
    return rubinow_keller(v, w) * c * re / spin
