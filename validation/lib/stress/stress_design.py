# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The runs of the stability map: a designed sample of scenes.

Three parts: single axes from a plain scene, corners of groups of axes, and a
Latin hypercube over all of them at once. A point is a dict of what AXES and
WORDS name; scene() makes the numbers of a case of it.
"""

import itertools
import math

import numpy as np
from scipy.stats import qmc

# ranges; all on a logarithmic scale
AXES = {
    "diameter": (1e-5, 1e-2),         # of a sphere [m]
    "density_ratio": (0.5, 8.0),      # solid over fluid
    "viscosity": (1e-6, 1.0),         # [Pa s]
    "solids": (1e-3, 0.6),            # solid fraction by volume
    "stiffness": (1e2, 5e6),          # [N/m]
    "step_ratio": (0.01, 1.5),        # DEM step over the limit of a particle at rest in a corner
    "interval_ratio": (1e-3, 1e4),    # coupling interval over the drag's relaxation time
    "charge_factor": (0.1, 30.0),     # charge over the paper's, at equal force over weight
    "cell": (1.5, 10.0),              # cell over diameter
    "jump": (0.5, 50.0),              # inlet velocity over the terminal one
}
# these are 0 in the share of the sample that is given
_OFTEN_ZERO = {"charge_factor": 0.6, "jump": 0.6}
WORDS = {
    "shape": ("spheres", "clumps"),
    "drag": ("ergunWenYu", "ergunWenYuBlended", "SchillerNaumann", "Gidaspow", "DiFelice", "Beetstra", "KochHill"),
    "scheme": ("exactOverlap", "divided", "centre", "exactOverlap+diffusion", "centre+diffusion"),
    "model": ("A", "B"),
    "overlap": ("yes", "no"),
    "sides": ("wall", "cyclic", "slip"),
}
PLAIN = {"diameter": 2e-3, "density_ratio": 2.6, "viscosity": 1e-3, "solids": 0.1, "stiffness": 1e3,
         "step_ratio": 0.5, "interval_ratio": 0.05, "charge_factor": 0.0, "cell": 3.0, "jump": 0.0,
         "shape": "spheres", "drag": "ergunWenYu", "scheme": "exactOverlap", "model": "A", "overlap": "yes",
         "sides": "wall"}

FLUID = 1000.0          # [kg/m3]
GRAVITY = 9.81          # [m/s2]
RESTITUTION = 0.3
# limit of a particle at rest in a corner over that of one contact, at that
# restitution (liggghts-fix/doc/contact_limit.md)
RESTING = {"spheres": 0.256, "clumps": 0.061}
PAPER_CHARGE = 3.93e-10  # [C] of a sphere of PAPER_DIAMETER
PAPER_DIAMETER = 2e-3   # [m]
COULOMB = 8.9875517873681764e9  # [N m2/C2]
_MOST_STEPS, _MOST_CELLS = 20000, 1500
_MOST_PER_INTERVAL, _OF_GRAINS = 2000, 8000  # DEM steps; of grains of micrometres
_EXCHANGES = 40


def single_axes(count=7):
    """One axis at a time, each from its least to its greatest value."""
    found = []
    for shape in WORDS["shape"]:
        base = {**PLAIN, "shape": shape}
        for key, (low, high) in AXES.items():
            for value in np.geomspace(low, high, count):
                found.append({**base, key: float(value)})
        for key, words in WORDS.items():
            found += [{**base, key: w} for w in words if w != base[key] and key != "shape"]
    # micrometre grains, where the interval is thousands of relaxation times
    for ratio in np.geomspace(1, 1e4, count):
        found.append({**PLAIN, "diameter": 1e-5, "viscosity": 1.0, "step_ratio": 0.9, "stiffness": 1e2,
                      "interval_ratio": float(ratio)})
    return found


def corners():
    """Least and greatest of the axes that meet in one limit."""
    groups = (("density_ratio", "interval_ratio", "solids"), ("stiffness", "step_ratio", "charge_factor"),
              ("cell", "solids", "jump"), ("viscosity", "diameter", "density_ratio"))
    found = []
    for keys in groups:
        for values in itertools.product(*(AXES[k] for k in keys)):
            found.append({**PLAIN, **dict(zip(keys, values))})
    return found


def latin(count, seed=5):
    """All axes and words at once: a Latin hypercube, shuffled for low discrepancy."""
    keys, words = list(AXES), list(WORDS)
    draws = qmc.LatinHypercube(len(keys) + len(words) + len(_OFTEN_ZERO), seed=seed,
                               optimization="random-cd").random(count)
    found = []
    for row in draws:
        point = {}
        for key, u in zip(keys, row):
            low, high = AXES[key]
            point[key] = float(low * (high / low)**u)
        for key, u in zip(words, row[len(keys):]):
            point[key] = WORDS[key][min(int(u * len(WORDS[key])), len(WORDS[key]) - 1)]
        for (key, share), u in zip(_OFTEN_ZERO.items(), row[len(keys) + len(words):]):
            if u < share:
                point[key] = 0.0
        found.append(point)
    return found


def grains(count):
    """Small grains in thick fluids: intervals of up to 1e4 relaxation times."""
    narrow = {"diameter": (1e-5, 1e-4), "viscosity": (1e-2, 1.0), "stiffness": (1e2, 3e3), "step_ratio": (0.2, 0.95),
              "interval_ratio": (1.0, 1e4)}
    found = latin(count, seed=6)
    for p in found:
        for key, (low, high) in narrow.items():
            a, b = AXES[key]
            u = math.log(p[key] / a) / math.log(b / a)
            p[key] = float(low * (high / low)**u)
    return found


def design(count=None):
    """The points in the order they are run; count: only so many, of all parts."""
    parts = [single_axes(), corners(), latin(128), grains(48)]
    if count is None:
        return unique([p for part in parts for p in part])
    total = sum(len(p) for p in parts)
    few = []
    for part in parts:
        share = max(1, round(count * len(part) / total))
        few += [part[i] for i in np.linspace(0, len(part) - 1, min(share, len(part))).astype(int)]
    return unique(few)[:count]


def unique(points):
    seen, found = set(), []
    for p in points:
        key = repr(sorted(p.items()))
        if key not in seen:
            seen.add(key)
            found.append(p)
    return found


def terminal_velocity(d, density, viscosity):
    """Of a sphere in still fluid by Schiller and Naumann [m/s], by bisection in
    the velocity's logarithm; never 0."""
    weight = math.pi / 6 * d**3 * max(abs(density - FLUID), 1e-3 * FLUID) * GRAVITY
    low, high = 1e-15, 1e3
    for _ in range(200):
        v = math.sqrt(low * high)
        re = FLUID * v * d / viscosity
        cd = 24 / re * (1 + 0.15 * re**0.687) if re < 1000 else 0.44
        if cd * math.pi / 8 * d * d * FLUID * v * v > weight:
            high = v
        else:
            low = v
    return v


def contact_limit(stiffness, mass):
    """Largest step [s] of one head-on contact of two like particles, with the
    damping of cases/common/contacts.liggghts: k dt2/(2 m) + c dt/m < 1."""
    c = 2 * math.sqrt(0.5 * mass * stiffness) / math.sqrt(1 + (math.pi / math.log(RESTITUTION))**2)
    # of the reduced mass m/2: k dt2/(4 m/2) + c dt/(2 m/2) = 1
    return (-c + math.sqrt(c * c + 2 * mass * stiffness)) / stiffness


def scene(p):
    """The case's values and what the bounds need, of a point."""
    d, density = p["diameter"], p["density_ratio"] * FLUID
    sphere = math.pi / 6 * d**3
    one = sphere * (14 if p["shape"] == "clumps" else 1)
    mass = density * one
    limit = contact_limit(p["stiffness"], mass) * RESTING[p["shape"]]
    step = float(f"{p['step_ratio'] * limit:.4g}")
    relaxation = density * d * d / (18 * p["viscosity"])
    v = terminal_velocity(d, density, p["viscosity"])
    inlet = p["jump"] * v
    box = layout(p, d, one)

    # DEM steps an interval: what the ratio asks for, and a run can afford
    courant = 20 * p["cell"] * d / max(inlet, v)
    wanted = min(p["interval_ratio"] * relaxation, courant)
    every = min(max(1, round(wanted / step)), _OF_GRAINS if d < 3e-5 and not p["charge_factor"] else _MOST_PER_INTERVAL)
    exchanges = max(10, min(_EXCHANGES, _MOST_STEPS // every))
    scheme, _, smoothing = p["scheme"].partition("+")
    values = {
        "shape": p["shape"], "sphere_radius": d / 2, "density": density, "particle_mass": mass,
        "viscosity": p["viscosity"], "stiffness": p["stiffness"], "dem_step": step, "coupling_steps": every,
        "end": float(f"{step * every * exchanges:.12g}"), "drag": p["drag"], "void_fraction": scheme,
        "smoothing": smoothing or "none", "bandwidth": 3 * d, "model": p["model"], "overlap": p["overlap"],
        "sides": p["sides"], "bottom": "inlet" if inlet else "wall", "inlet_velocity": inlet,
        "charge": p["charge_factor"] * PAPER_CHARGE * (d / PAPER_DIAMETER)**2.5,
        "cutoff": min(6 * d, 0.5 * box["values"]["size_x"]),
        "particles": len(box["places"]), **box["values"]}
    return {"values": values, "places": box["places"], "solids": box["solids"], "mass": mass, "terminal": v,
            "interval_ratio": step * every / relaxation, "exchanges": exchanges}


def _clump_pitch(d):
    return 3.05 * d, 1.55 * d  # 3 d wide, 1.5 d high


def layout(p, d, one):
    """A box, its cells, and the particles on a lattice, jittered where there is room."""
    cell = p["cell"] * d
    clumps = p["shape"] == "clumps"
    least = 6.2 * d if clumps else 4 * d
    for count in (16, 12, 8, 6, 4) if clumps else (200, 120, 60, 32, 20, 12, 8, 4):
        space = count * one / p["solids"]
        across = max(1, math.ceil(max(least, (space / 1.5)**(1 / 3)) / cell - 1e-9))
        width = across * cell
        sites, pitch = _lattice(p, d, one, width, count)
        top = max(z for _, _, z in sites) + (0.8 if clumps else 0.55) * d
        up = max(2, math.ceil(1.3 * top / cell))
        if across * across * up <= _MOST_CELLS:
            break
    tall = pitch[2] * len({z for _, _, z in sites})
    share = (1 if clumps else 0.5) * one / (pitch[0] * pitch[1] * pitch[2])
    rng = np.random.default_rng(11)
    slack = _slack(p, pitch, d)
    places = []
    for i, at in enumerate(sites):
        at = [a + 0.25 * s * (2 * rng.random() - 1) for a, s in zip(at, slack)]
        if not clumps:  # in the box
            at = [min(max(a, 0.505 * d), w - 0.505 * d) if axis == 2 or p["sides"] != "cyclic" else a % w
                  for axis, (a, w) in enumerate(zip(at, (width, width, up * cell)))]
        places.append((i % 2, at))
    values = {"size_x": width, "size_y": width, "size_z": up * cell, "cells_x": across, "cells_y": across,
              "cells_z": up}
    return {"values": values, "places": places, "solids": min(share, len(sites) * one / (width * width * tall))}


def _slack(p, pitch, d):
    """Room [m] to each side of a particle, by axis."""
    if p["shape"] == "clumps":
        wide, high = 3 * d, 1.5 * d
        return pitch[0] - wide, pitch[1] - wide, pitch[2] - high
    x, y, z = pitch
    near = min(math.hypot(x, y), math.hypot(x, z), 2 * x, 2 * z)
    return 3 * (max(0.0, near - d) / 3,)


def _lattice(p, d, one, width, count):
    """Sites of a lattice of that many particles, and its pitches: face-centred
    for spheres (every second site of a grid), a plain grid for flat clumps."""
    clumps, cyclic = p["shape"] == "clumps", p["sides"] == "cyclic"
    if clumps:
        wide, high = _clump_pitch(d)
        ideal = max((one / p["solids"])**(1 / 3), wide)
        along = max(1, int(width / ideal + 1e-9))
        x = width / along
        z = max(one / (p["solids"] * x * x), high)
        start, up, every = 0.5 * x, 0.8 * d + 0.5 * (z - high), 1
    else:
        ideal = (one / (2 * p["solids"]))**(1 / 3)
        edge = 0.55 * d
        if cyclic:
            along = max(2, 2 * int(width / ideal / 2))
            x, start = width / along, 0.25 * width / along
        else:
            along = max(2, int((width - 2 * edge) / ideal) + 1)
            x, start = (width - 2 * edge) / (along - 1), edge
        z = one / (2 * p["solids"] * x * x)
        z = max(z, math.sqrt(max(0.0, (1.005 * d)**2 - x * x)), 0.503 * d)
        up, every = edge + 0.1 * z, 2
    sites, layer = [], 0
    while len(sites) < count:
        for i in range(along):
            for j in range(along):
                if (i + j + layer) % every == 0 and len(sites) < count:
                    sites.append((start + i * x, start + j * x, up + layer * z))
        layer += 1
    return sites, (x, x, z)
