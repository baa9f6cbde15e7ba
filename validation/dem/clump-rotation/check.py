# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A clump's free rotation, a collision of two and their Coulomb work, exact solutions."""

import glob
import os

import numpy as np

from validation.lib.checks import plots
from validation.lib.checks.coupled import dem
from validation.lib.checks.reference import table

TITLE = "a clump's free rotation, collision and Coulomb work against exact solutions"
COULOMB = 8.9875517873681764e9


def frames(folder, name):
    """Rows of each dump, and its step."""
    for path in sorted(glob.glob(os.path.join(folder, "DEM", name + ".*.dump"))):
        yield int(path.split(".")[-2]), np.loadtxt(path, skiprows=9)


class Body:
    """A clump from its spheres: r [m] their radii, density [kg/m3]."""

    def __init__(self, rows, r, density):
        m = density * 4 / 3 * np.pi * r**3
        self.x, self.w, self.m = rows[:, 2:5], rows[0, 8:11], m.sum()
        self.centre = m @ self.x / self.m
        self.v = m @ rows[:, 5:8] / self.m
        d = self.x - self.centre
        self.inertia = sum(mi * (di @ di * np.eye(3) - np.outer(di, di)) + 0.4 * mi * ri**2 * np.eye(3)
                           for mi, di, ri in zip(m, d, r))
        self.momentum = self.m * self.v
        self.spin = self.inertia @ self.w + np.cross(self.centre, self.momentum)
        self.energy = 0.5 * self.m * self.v @ self.v + 0.5 * self.w @ self.inertia @ self.w


def rotation(folder):
    """Time, spin and axes of the cross; the axes are known from its spheres' places."""
    t, w, axes = [], [], []
    for step, rows in frames(folder, "cross"):
        x = rows[:, 1:4]
        e = np.array([(x[0] - x[1]) / 8**0.5, (x[2] - x[3]) / 2, np.zeros(3)])
        e[2] = np.cross(e[0], e[1])
        t.append(step)
        axes.append(e)
        w.append(e @ rows[0, 7:10])
    return np.array(t) * 1e-3, np.array(w), np.array(axes)


def free_rotation(checks):
    ref = table("torque_free_triaxial_formula")
    folder = dem("clump-rotation", "clump-rotation", scene="rotation")
    t, w, axes = rotation(folder)
    wanted = np.stack([ref[f"omega{k}_rad_per_s"] for k in (1, 2, 3)], axis=1)
    size = np.linalg.norm(wanted[-1])
    checks.equal("free rotation: number of times compared", len(t), len(wanted))
    checks.at_most("free rotation: error of omega at the end, over omega", np.linalg.norm(w[-1] - wanted[-1]) / size,
                   1e-3)
    checks.at_most("free rotation: largest error of omega, over omega", np.abs(w - wanted).max() / size, 1e-3)
    q = np.stack([ref[f"q{k}"] for k in range(4)], axis=1)
    turned = np.array([turn(x) for x in q])
    checks.at_most("free rotation: largest error of the axes [rad]", np.abs(turned - axes).max(), 2e-3)
    inertia = np.array([1, 2, 3])
    checks.at_most("free rotation: change of energy", np.abs((w**2 @ inertia) / 2.08 - 1).max(), 1e-5)
    checks.at_most("free rotation: change of angular momentum",
                   np.abs(np.sqrt((w**2 @ inertia**2) / 4.24) - 1).max(), 1e-5)
    wrong = rotation(dem("clump-rotation", "clump-rotation-thick", scene="rotation", radius=0.3))[1]
    checks.at_least("a cross of thick spheres, other moments: error of omega",
                    np.linalg.norm(wrong[-1] - wanted[-1]) / size, 1e-2)
    series = []
    fine = ref["time_s"]
    for k in range(3):
        series += [(f"omega {k + 1}", t, w[:, k], "dots"), (None, fine, wanted[:, k], "dashed")]
    checks.picture(plots.compare(os.path.join(folder, "omega.png"), series, "time [s]", "spin, body axes [rad/s]",
                                 "Torque-free body of moments 1, 2, 3; dashed: torque_free_triaxial_formula"))


def turn(q):
    """Rows: the body's axes in space, of a unit quaternion, scalar first."""
    a, v = q[0], q[1:]
    K = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    return (np.eye(3) + 2 * a * K + 2 * K @ K).T


def collision(checks):
    folder = dem("clump-rotation", "clump-collision", scene="collision")
    radii = [np.array([1e-3, 1e-3]), np.array([1e-3, 1e-3, 8e-4])]
    states, closest = [], (1, None)
    for step, rows in frames(folder, "pair"):
        pair = [Body(rows[rows[:, 1] == b + 1], radii[b], 2600) for b in (0, 1)]
        states.append((step, pair))
        gap = np.linalg.norm(pair[1].x[0] - pair[0].x[0])
        if gap < closest[0]:
            closest = (gap, len(states) - 1)
    A, B = states[0][1]
    C, D = states[-1][1]

    # exact: the state at contact, from the one before it in free flight over the rest
    a0, b0 = states[closest[1]][1]
    n = b0.x[0] - a0.x[0]
    n /= np.linalg.norm(n)
    before = states[closest[1] - 2][1]
    ra, rb = (p.x[0] + s * 1e-3 * n - p.centre for p, s in zip((a0, b0), (1, -1)))
    approach = n @ (before[1].v + np.cross(before[1].w, rb) - before[0].v - np.cross(before[0].w, ra))
    yielding = sum(1 / p.m + n @ np.cross(np.linalg.solve(p.inertia, np.cross(r, n)), r)
                   for p, r in ((a0, ra), (b0, rb)))
    J = -2 * approach / yielding * n
    checks.at_most("collision: velocity along the normal before it [m/s]", approach, -0.5)
    after = states[closest[1] + 2][1]
    for name, was, now, r, s in (("doublet", before[0], after[0], ra, -1), ("triangle", before[1], after[1], rb, 1)):
        v = was.v + s * J / was.m
        w = was.w + np.linalg.solve(was.inertia, np.cross(r, s * J))
        checks.at_most(f"collision: {name}, error of its velocity over the approach",
                       np.linalg.norm(now.v - v) / -approach, 1e-3)
        checks.at_most(f"collision: {name}, error of its spin over the change",
                       np.linalg.norm(now.w - w) / np.linalg.norm(w - was.w), 5e-3)
    P = np.linalg.norm(A.momentum + B.momentum)
    checks.at_most("collision: change of momentum",
                   np.linalg.norm(C.momentum + D.momentum - A.momentum - B.momentum) / P, 1e-12)
    L = np.linalg.norm(A.spin) + np.linalg.norm(B.spin)
    checks.at_most("collision: change of angular momentum", np.linalg.norm(C.spin + D.spin - A.spin - B.spin) / L, 1e-6)
    checks.close("collision, restitution 1: energy [J]", C.energy + D.energy, A.energy + B.energy, 1e-3)
    lossy = [[Body(rows[rows[:, 1] == b + 1], radii[b], 2600).energy for b in (0, 1)]
             for _, rows in frames(dem("clump-rotation", "clump-collision-damped", scene="collision", damping=1e6),
                                   "pair")]
    checks.at_least("collision, damped springs: share of the energy that is lost",
                    1 - sum(lossy[-1]) / sum(lossy[0]), 1e-2)
    time = [s * 1e-3 for s, _ in states]
    checks.picture(plots.compare(
        os.path.join(folder, "energy.png"),
        [("doublet", time, [1e6 * p[0].energy for _, p in states], "line"),
         ("triangle", time, [1e6 * p[1].energy for _, p in states], "line"),
         ("both", time, [1e6 * (p[0].energy + p[1].energy) for _, p in states], "dashed"),
         ("both, damped springs", time, [1e6 * sum(e) for e in lossy], "dots")],
        "time [us]", "kinetic energy [uJ]", "A triangle flies at a doublet at rest, restitution 1"))


def coulomb(checks):
    folder = dem("clump-rotation", "clump-coulomb", scene="coulomb")
    r = np.full(14, 1e-3)
    t, kinetic, potential, P, L, least = [], [], [], [], [], 1
    for step, rows in frames(folder, "pair"):
        one, other = (rows[rows[:, 1] == b] for b in (1, 2))
        q1, q2 = (np.where(x[:, 11] == 1, 3.93e-10, -3.93e-10) for x in (one, other))
        gap = np.linalg.norm(one[:, None, 2:5] - other[None, :, 2:5], axis=2)
        least = min(least, gap.min())
        pair = [Body(x, r, 2600) for x in (one, other)]
        t.append(step * 1e-5)
        kinetic.append(sum(p.energy for p in pair))
        potential.append(COULOMB * (q1[:, None] * q2[None, :] / gap).sum())
        P.append(sum(p.momentum for p in pair))
        L.append(sum(p.spin for p in pair))
    kinetic, potential, P, L = map(np.array, (kinetic, potential, P, L))
    exchanged = np.ptp(potential)
    checks.at_least("Coulomb: least distance of two spheres over their diameter", least / 2e-3, 1)
    checks.at_least("Coulomb: energy that changes hands, over the kinetic at the start", exchanged / kinetic[0], 0.1)
    checks.at_most("Coulomb: change of kinetic and potential energy, over what changes hands",
                   np.ptp(kinetic + potential) / exchanged, 1e-6)
    checks.at_most("Coulomb: change of momentum", np.linalg.norm(P - P[0], axis=1).max() / np.linalg.norm(P[0]), 1e-11)
    checks.at_most("Coulomb: change of angular momentum",
                   np.linalg.norm(L - L[0], axis=1).max() / np.linalg.norm(L[0]), 1e-10)
    checks.at_least("Coulomb, the work left out: change of energy over what changes hands",
                    np.ptp(kinetic) / exchanged, 0.5)
    checks.picture(plots.compare(
        os.path.join(folder, "energy.png"),
        [("kinetic", t, 1e9 * kinetic, "line"), ("potential", t, 1e9 * potential, "line"),
         ("sum", t, 1e9 * (kinetic + potential), "dashed")],
        "time [s]", "energy [nJ]", "A charged plate of illite and one of kaolinite pass each other"))


def run(checks):
    free_rotation(checks)
    collision(checks)
    coulomb(checks)
