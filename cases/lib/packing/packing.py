# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The particles' places at the start: chooses the method, writes packing.liggghts
and packing.places for LIGGGHTS, and a report, packing.json."""

import contextlib
import hashlib
import json
import math
import os
import random
import shutil
import time

import numpy as np

from cases.lib.case import cache
from cases.lib.case.errors import CaseError
from cases.lib.case.suspension import particle_volume
from cases.lib.packing import pack_box, pack_expansion, pack_packmol, pack_random, pack_shapes

METHODS = ("random", "packmol", "expansion")
CLUMPS, SPHERE = ("ill", "kao"), "grain"  # the input's fixes particletemplate/*
# what makes a packing another one, besides the sources
_KEYS = ("packing", "clumps", "spheres", "sphere_radius", "layer_spacing", "volume", "tube_radius",
         "fill_height", "seed", "illite_share", "size_x", "size_y", "size_z", "sides")


def write(folder, v):
    """Packs the particles of the case and gives the report. The values v hold
    numbers in place of words. A packing that was made before is taken again."""
    if v["packing"] not in METHODS:
        raise CaseError(f"packing = {v['packing']}: must be one of {', '.join(METHODS)}")
    _clear(folder)

    def make(part):
        try:
            _make(part, v)
        except CaseError:
            if os.path.isdir(os.path.join(part, "packmol")):  # what packmol said
                shutil.copytree(os.path.join(part, "packmol"), os.path.join(folder, "packmol"), dirs_exist_ok=True)
            raise

    kept = cache.fill("packings", _key(v), folder, make)
    with open(os.path.join(folder, "packing.json"), encoding="utf-8") as f:
        report = json.load(f)
    print(line(report) + (", kept from before" if kept else ""), flush=True)
    return report


def _clear(folder):
    """Takes away what an older packing left in the folder."""
    shutil.rmtree(os.path.join(folder, "packmol"), ignore_errors=True)
    for name in ("packing.liggghts", "packing.places", "packing.json"):
        with contextlib.suppress(FileNotFoundError):
            os.remove(os.path.join(folder, name))


def line(report):
    """The report in one line."""
    return (f"packing: {report['count']} {report['particles']} by {report['method']}, "
            f"solid fraction {report['solid_fraction']:.4g}, largest overlap {report['overlap']:.2g} d, "
            f"seed {report['seed']}, {report['seconds']:.1f} s")


def _key(v):
    values = {k: v[k] for k in _KEYS if k in v}
    sources = b""
    for module in (pack_shapes, pack_random, pack_packmol, pack_expansion, pack_box):
        with open(module.__file__, "rb") as f:
            sources += f.read()
    with open(__file__, "rb") as f:
        sources += f.read()
    return hashlib.sha256(repr(values).encode() + sources).hexdigest()[:16]


def shape_of(v):
    """The case's particle."""
    if "clumps" in v:
        return pack_shapes.plate(v["sphere_radius"], v["layer_spacing"])
    return pack_shapes.single(v["sphere_radius"])


def kinds_of(v):
    """The template of every particle: illite in the asked share, at random."""
    if "clumps" not in v:
        return [SPHERE] * int(v["spheres"])
    count = int(v["clumps"])
    illite = math.floor(count * v["illite_share"] + 0.5)
    kinds = [CLUMPS[0]] * illite + [CLUMPS[1]] * (count - illite)
    random.Random(v["seed"]).shuffle(kinds)
    return kinds


def _make(folder, v):
    """Packs, looks at what came out, writes the files."""
    shape, kinds = shape_of(v), kinds_of(v)
    what = "clumps" if "clumps" in v else "spheres"
    if not kinds:
        raise CaseError(f"{what} = {v[what]}: must be at least 1")
    if "tube_radius" not in v:
        _make_in_box(folder, v, kinds)
        return
    tube = pack_shapes.Tube(v["tube_radius"], v["fill_height"])
    solid_fraction = len(kinds) * particle_volume(v) / (math.pi * tube.radius**2 * tube.height)
    began = time.monotonic()
    try:
        x, q = _place(v["packing"], shape, kinds, tube, v["seed"], solid_fraction, _Progress(),
                      os.path.join(folder, "packmol"))
    except pack_shapes.NotPacked as e:
        raise CaseError(
            f"{what} = {len(kinds)}, solid_fraction = {solid_fraction:.4g}: packing = {v['packing']} reached "
            f"{e.share * solid_fraction:.4g} at most ({e}); "
            + ("take less" if v["packing"] == "expansion" else "take less, or packing = expansion")) from None
    report = {
        "method": v["packing"], "particles": what, "count": len(kinds), "seed": int(v["seed"]),
        "solid_fraction": solid_fraction,
        "overlap": pack_shapes.overlaps(shape, x, q)[0] / (2 * shape.radius),
        "beyond_tube": float(tube.beyond(shape.spheres(x, q), shape.radius).max()) / (2 * shape.radius),
        "seconds": round(time.monotonic() - began, 3)}
    with open(os.path.join(folder, "packing.json"), "w", encoding="utf-8") as f:
        json.dump(report, f, indent=2)
        f.write("\n")
    _write_places(folder, line(report), kinds, x, q, what)


def _make_in_box(folder, v, kinds):
    """Spheres in a case like box."""
    if v["packing"] != "expansion" or "clumps" in v:
        raise CaseError(f"packing = {v['packing']}: must be expansion, of spheres, in a box")
    size = [v["size_x"], v["size_y"], v["size_z"]]
    solid_fraction = len(kinds) * particle_volume(v) / math.prod(size)
    began = time.monotonic()
    try:
        x = pack_box.place(v["sphere_radius"], len(kinds), size, v["sides"] == "cyclic", int(v["seed"]), _Progress())
    except pack_shapes.NotPacked as e:
        raise CaseError(f"spheres = {len(kinds)}, solid_fraction = {solid_fraction:.4g}: {e}; take less") from None
    report = {"method": "expansion", "particles": "spheres", "count": len(kinds), "seed": int(v["seed"]),
              "solid_fraction": solid_fraction, "seconds": round(time.monotonic() - began, 3)}
    report["overlap"] = pack_box.overlap(x, v["sphere_radius"], size, v["sides"] == "cyclic")
    with open(os.path.join(folder, "packing.json"), "w", encoding="utf-8") as f:
        json.dump(report, f, indent=2)
        f.write("\n")
    _write_places(folder, line(report), kinds, x, None, "spheres")


def _place(method, shape, kinds, tube, seed, solid_fraction, say, folder):
    if method == "random":
        return pack_random.place(shape, len(kinds), tube, seed, say)
    if method == "expansion":
        return pack_expansion.place(shape, len(kinds), tube, seed, say, solid_fraction)
    return pack_packmol.place(shape, kinds, tube, seed, say, folder)


class _Progress:
    """Prints what is said to it, every five seconds."""

    def __init__(self):
        self.last = time.monotonic()

    def __call__(self, text):
        now = time.monotonic()
        if now - self.last > 5:
            self.last = now
            print(f"packing: {text}", flush=True)


def _write_places(folder, about, kinds, x, q, what):
    q = [None] * len(x) if q is None else q
    templates = CLUMPS if what == "clumps" else (SPHERE,)
    with open(os.path.join(folder, "packing.places"), "w", encoding="utf-8") as f:
        f.write(f"# {about}\n# template x y z" + (" q0 q1 q2 q3\n" if what == "clumps" else "\n"))
        for kind, centre, turn in zip(kinds, x, q):
            numbers = [*centre, *turn] if what == "clumps" else centre
            f.write(kind + "".join(f" {c:.15g}" for c in numbers) + "\n")
    with open(os.path.join(folder, "packing.liggghts"), "w", encoding="utf-8") as f:
        f.write("# This file is made by clayFoam: every particle in its place\n"
                f"fix put all insert/placed file packing.places templates {' '.join(templates)}\n")


def read_places(path):
    """Kinds, centres (N, 3) and rotations (N, 4) of a list that was written."""
    with open(path, encoding="utf-8") as f:
        rows = [r.split() for r in f if r.strip() and not r.startswith("#")]
    numbers = np.array([r[1:] for r in rows], dtype=float)
    q = numbers[:, 3:] if numbers.shape[1] == 7 else np.tile([1.0, 0, 0, 0], (len(rows), 1))
    return [r[0] for r in rows], numbers[:, :3], q
