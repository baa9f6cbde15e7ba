# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Beds of touching grains on a cubic lattice whose drag is stiff for the coupling
interval: what they do by theory, and runs of stiff-bed-scene."""

import glob
import math
import os

import numpy as np

from validation.lib.checks import coupled, fields

GRAVITY, FLUID = 9.81, 1000.0
YOUNG, POISSON = 5e6, 0.45
LATTICE = math.pi / 6       # solid fraction of the cubic lattice
PER_DIAMETER = 1e-2         # DEM step over the diameter [s/m]


def ergun(n, slip, d, viscosity, fluid=FLUID):
    """Ergun's drag of model A on a sphere over its volume and slip [kg/(m3 s)],
    from the drop 150 mu (1-n)2/n3 U/d2 + 1.75 rho (1-n)/n3 U2/d with U = n slip."""
    u = n * slip
    gradient = 150 * viscosity * (1 - n)**2 / n**3 / d**2 + 1.75 * fluid * (1 - n) / n**3 * u / d
    return gradient * n * n / np.maximum(1 - n, 1e-9)


def wen_yu(n, slip, d, viscosity, fluid=FLUID):
    """Wen and Yu's, n^-2.7."""
    re = n * slip * d * fluid / viscosity
    return 18 * viscosity / d**2 * n**-2.7 * (1 + 0.15 * re**0.687)


def law(n, slip, d, viscosity):
    return np.where(n < 0.8, ergun(n, slip, d, viscosity), wen_yu(n, slip, d, viscosity))


class Bed:
    """A bed's figures."""

    def __init__(self, d, density=2650.0, viscosity=1e-3, across=4, layers=6):
        self.d, self.density, self.viscosity, self.across, self.layers = d, density, viscosity, across, layers
        self.volume = math.pi / 6 * d**3
        self.mass = density * self.volume
        # a seventh of Rayleigh's time, which goes with the root of the density
        self.step = float(f"{PER_DIAMETER * d * min(1.0, math.sqrt(density / 2650.0)):.3g}")

    @property
    def relaxation(self):
        """Mass over drag coefficient [s] in the lattice, without flow."""
        return self.density / ergun(1 - LATTICE, 0.0, self.d, self.viscosity)

    def steps(self, relaxations):
        """DEM steps of an interval of that many relaxation times."""
        return max(1, round(relaxations * self.relaxation / self.step))

    def onset(self):
        """Superficial velocity [m/s] at which Ergun's drop carries the lattice."""
        low, high = 0.0, 1.0
        for _ in range(100):
            u = 0.5 * (low + high)
            n = 1 - LATTICE
            drop = (150 * self.viscosity * (1 - n)**2 / n**3 / self.d**2 * u
                    + 1.75 * FLUID * (1 - n) / n**3 / self.d * u * u)
            low, high = (low, u) if drop > (self.density - FLUID) * GRAVITY * (1 - n) else (u, high)
        return low

    def compressions(self):
        """Of the contacts [m] of a column of grains by their own weight in the fluid,
        Hertz: F = 4/3 E* sqrt(R*) delta^(3/2); the one with the wall first."""
        stiff = 4 / 3 * YOUNG / (1 - POISSON**2) / 2
        carried = abs(self.density - FLUID) * GRAVITY * self.volume * np.arange(self.layers, 0, -1)
        radius = np.where(np.arange(self.layers) == 0, 0.5 * self.d, 0.25 * self.d)
        return (carried / stiff / np.sqrt(radius))**(2 / 3)

    def sunk(self):
        """How far each layer has moved towards its wall in the end [m], from the wall on."""
        return np.cumsum(self.compressions())

    def settling(self, to=1e-14):
        """Time [s] in which the column's small vibrations about its rest, as if it
        started there displaced by what it sinks, have come to a kinetic energy of
        `to` m g d a grain. Grains in a closed column meet K/n2 and, with
        their own mass, that of the fluid that makes way; contacts' own damping is
        left out. Twice that: exchanges that are as long as a vibration damp it less."""
        carried = abs(self.density - FLUID) * GRAVITY * self.volume * np.arange(self.layers, 0, -1)
        k = 1.5 * carried / self.compressions()
        matrix = np.diag(k + np.append(k[1:], 0)) - np.diag(k[1:], 1) - np.diag(k[1:], -1)
        stiff, modes = np.linalg.eigh(matrix)
        parts = modes.T @ self.sunk()
        drag = self.mass / self.relaxation / (1 - LATTICE)**2
        inertia = self.volume * (self.density + FLUID * LATTICE / (1 - LATTICE))
        unit = self.mass * GRAVITY * self.d * self.layers
        found = 0.0
        for c, part in zip(stiff, parts):
            # m s2 + drag s + c = 0: the slow root, and the largest speed
            root = drag * drag - 4 * inertia * c
            slow = 2 * c / (drag + math.sqrt(root)) if root > 0 else 0.5 * drag / inertia
            speed = abs(part) * (c / drag if root > 0 else math.sqrt(c / inertia))
            energy = 0.5 * self.mass * speed**2 / unit
            found = max(found, math.log(max(energy / to, 1.0)) / slow)
        return found


def run(where, bed, steps, end, **more):
    """A run of stiff-bed-scene, coupled every `steps`, for at least `end` [s]; its folder."""
    exchanges = max(1, math.ceil(end / (steps * bed.step) - 1e-9))
    d = bed.d
    values = {
        "across": bed.across, "layers": bed.layers, "size_x": bed.across * d, "size_y": bed.across * d,
        "size_z": 16 * d, "lid": 16 * d, "cells_x": max(1, bed.across // 2), "cells_y": max(1, bed.across // 2),
        "cells_z": 8, "sphere_radius": d / 2, "density": bed.density, "viscosity": bed.viscosity, "young": YOUNG,
        "poisson": POISSON, "dem_step": bed.step, "coupling_steps": steps, "end": exchanges * steps * bed.step, **more}
    words = [w for k, v in values.items() for w in ("--set", f"{k}={v if isinstance(v, str) else f'{v:.12g}'}")]
    return coupled.finished("stiff-bed-scene", where, "--no-pictures", *words, limit=3000)


def means(folder):
    return {k: np.array(v) for k, v in coupled.columns(os.path.join(folder, "DEM", "means.csv")).items()}


def places(folder):
    """Places of the grains [m], output by output, grain by grain: id order."""
    names = sorted(glob.glob(os.path.join(glob.escape(folder), "DEM", "spheres.*.dump")))
    return [np.loadtxt(name, skiprows=9)[:, 3:6] for name in names]


def rest(where, bed, relaxations, exchanges=0, light=False, **more):
    """A bed that is left to itself for the settling time, and at least so many
    exchanges. Gives kinetic energy over m g d a grain, the farthest a grain is
    beyond the way between where it began and where Hertz's column has it over d,
    and that of the mean height at the end."""
    steps = bed.steps(relaxations)
    interval = steps * bed.step
    bottom = (16 - bed.layers) * bed.d if light else 0.0
    folder = run(where, bed, steps, max(bed.settling(), exchanges * interval), bed_from=bottom, frames=5, **more)
    energy = means(folder)["energy"] / (bed.across**2 * bed.layers * bed.mass * GRAVITY * bed.d)
    began, *later = places(folder)
    layer = np.rint((began[:, 2] - bottom) / bed.d - 0.5).astype(int)
    sign, level = (1.0, bed.layers - 1 - layer) if light else (-1.0, layer)
    last = began.copy()
    last[:, 2] += sign * bed.sunk()[level]
    low, high = np.minimum(began, last), np.maximum(began, last)
    beyond = max(float(np.max(np.maximum(low - now, now - high))) for now in later)
    height = float(abs(later[-1][:, 2].mean() - last[:, 2].mean()))
    return {"energy": float(energy[-3:].max()), "moved": beyond / bed.d, "height": height / bed.d,
            "exchanges": len(energy), "relaxations": interval / bed.relaxation,
            "cfd": coupled.summary(folder)}


def drop(folder, bed, first, last):
    """Kinematic pressure drop [m2/s2] between the layers of cells first and last, of
    a bed that stands still, at the end: measured, and by the law from the cells' own
    n and U."""
    at, cells = fields.times(folder)[-1][1], fields.centres(folder)
    p, n = (fields.field(at, name, len(cells)) for name in ("p", "voidfraction"))
    u = fields.field(at, "U", len(cells))[:, 2]
    heights = np.unique(cells[:, 2].round(12))
    level = np.argmin(abs(cells[:, 2, None] - heights), axis=1)
    pull = (1 - n) * law(n, abs(u), bed.d, bed.viscosity) * u / FLUID
    height = heights[1] - heights[0]
    slope = [pull[level == k].sum() / n[level == k].sum() for k in range(first, last + 1)]
    by_law = height * (sum(slope) - 0.5 * (slope[0] + slope[-1]))
    return float(p[level == first].mean() - p[level == last].mean()), float(by_law)


def through(where, bed, relaxations, speed, intervals=10, held=0, frames=1, **more):
    """Flow at `speed` [m/s] up through a bed that a lid presses down, or that is
    held; measured drop and the law's, over all but its outermost layers of cells."""
    steps = bed.steps(relaxations)
    levels = bed.layers // 2
    folder = run(where, bed, steps, intervals * steps * bed.step, held=held, lid=bed.layers * bed.d, bottom="inlet",
                 top="open", sides="slip", inlet_velocity=speed, start_velocity=speed, frames=frames, **more)
    return (*drop(folder, bed, 1, levels - 2), folder)


def fluidised(where, relaxations, end=1.2):
    """Mean height over d, over the second half, of a bed of 1 mm grains in a thick
    fluid under 1.5 u_mf, and the most of a cell that a grain crossed in an interval."""
    bed = Bed(1e-3, viscosity=0.01, layers=8)
    steps, speed = bed.steps(relaxations), 1.5 * bed.onset()
    folder = run(where, bed, steps, end, bottom="inlet", top="open", sides="slip", inlet_velocity=speed,
                 start_velocity=speed)
    height, fastest = means(folder)["height"] / bed.d, means(folder)["fastest"]
    return float(height[len(height) // 2:].mean()), float(fastest.max() * steps * bed.step / (2 * bed.d))


def suspension(where, solids, relaxations, exchanges=40):
    """A block of spheres, none touching, in a closed box with periodic sides, its
    columns at heights of their own, so that what crosses the faces of cells is steady.
    Gives the velocity of its middle third, the law's n times slip, and the net
    volume flux there [m/s]."""
    d, viscosity, density, n = 1e-3, 1.0, 2650.0, 1 - solids
    spacing = (LATTICE / solids)**(1 / 3) * d
    step = float(f"{density / float(law(n, 0.0, d, viscosity)):.4g}")
    values = {
        "across_x": 8, "across_y": 8, "across_z": 24, "spacing": spacing, "stagger": 1, "size_x": 8 * spacing,
        "size_y": 8 * spacing, "size_z": 28 * spacing, "cells_x": 1, "cells_y": 1, "cells_z": 14, "bottom": "wall",
        "top": "wall", "sphere_radius": d / 2, "density": density, "fluid_density": FLUID, "viscosity": viscosity,
        "dem_step": step, "coupling_steps": relaxations, "end": exchanges * relaxations * step, "quiet_fluid": 0,
        "keep_mapping": 0, "tolerance": 1e-14, "stiffness": 1}
    words = [w for k, v in values.items() for w in ("--set", f"{k}={v if isinstance(v, str) else f'{v:.12g}'}")]
    folder = coupled.finished("lattice-scene", where, "--no-pictures", *words)
    found = coupled.columns(os.path.join(folder, "DEM", "means.csv"))["v_middle"][-1]
    expected = 0.0
    for _ in range(50):  # slip from n V beta' slip = weight in the mixture, force of pressure included
        expected = -n * n * (density - FLUID) * GRAVITY / float(law(n, abs(expected) / n, d, viscosity))
    at, cells = fields.times(folder)[-1][1], len(fields.centres(folder))
    share, u = fields.field(at, "voidfraction", cells)[4:8], fields.field(at, "U", cells)[4:8, 2]
    flow = float(np.mean(share * u) + (1 - share.mean()) * found)
    return found, expected, flow
