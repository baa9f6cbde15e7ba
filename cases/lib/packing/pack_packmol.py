# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Packing by the program packmol: particles as rigid molecules of atoms, one atom
a sphere, in its unit of length the spheres' radius.

It leaves in the given folder its input packmol.inp, a molecule KIND.xyz a kind,
its output packmol.xyz and all that it said, packmol.log.
"""

import glob
import os
import subprocess
import time

import numpy as np

from cases.lib.case import stops
from cases.lib.case.errors import CaseError
from cases.lib.packing.pack_shapes import NotPacked, overlaps

PROGRAM = "packmol"
MARGIN = 1e-3      # of a sphere's radius, kept between two spheres
_WALL = 0.035      # and from floor and top
_PRECISION = 1e-5  # what packmol may leave of (way beyond floor or top)^2 / 100
_LOOPS = 100       # packmol's tries at all of the particles, times the kinds
_SECONDS = 900     # after that it is stopped
_FEWER = 0.85      # when it fails: of the particles, and again of those, until it does not
# packmol draws Euler angles, which leaves directions uneven: an axis z of a molecule is
# vertical too often, x and y too seldom. A plate's axis is put along their diagonal,
# whose squared components are then a third each on average.
_TILT = np.array([[1, -1, 0], [1, 1, -2], [1, 1, 1]]) / np.sqrt([[2], [6], [3]])
_FIT = 1e-5        # of a radius: how well its output, of six digits, is a rigid particle


def place(shape, kinds, tube, seed, say, folder):
    """Centres and rotations of particles of the named kinds, in their order;
    NotPacked, with what packmol then does with fewer, if it leaves overlaps."""
    try:
        return _place(shape, kinds, tube, seed, say, folder, _SECONDS)
    except NotPacked as e:
        failed = e
    share = failed.share
    fewer = _FEWER
    while fewer > share and fewer * len(kinds) >= 1:
        part = kinds[:int(fewer * len(kinds))]
        try:
            _place(shape, part, tube, seed, lambda text: say(f"{len(part)} of {len(kinds)}: {text}"),
                   os.path.join(folder, "fewer"), _SECONDS / 4)
            share = len(part) / len(kinds)
        except NotPacked as e:
            share = max(share, e.share * len(part) / len(kinds))
        fewer *= _FEWER
    raise NotPacked(share, failed.at)


def _place(shape, kinds, tube, seed, say, folder, seconds):
    """One run of packmol."""
    os.makedirs(folder, exist_ok=True)
    for old in glob.glob(os.path.join(glob.escape(folder), "*.*")):
        os.remove(old)
    names = sorted(set(kinds))
    _input(shape, [(k, kinds.count(k)) for k in names], tube, seed, folder)
    said = _run(say, folder, seconds)
    path = os.path.join(folder, "packmol.xyz")
    if not os.path.isfile(path):
        if said:
            raise NotPacked(0.0, said)
        raise CaseError("packing = packmol: packmol wrote no packmol.xyz; see packmol/packmol.log")
    x, q = _read(path, shape, len(kinds))
    deepest, ij = overlaps(shape, x, q)
    out = tube.beyond(shape.spheres(x, q), shape.radius).reshape(len(x), -1).max(axis=1)
    if deepest > 2 * MARGIN * shape.radius or out.max() > MARGIN * shape.radius:
        inside = out[ij].max(axis=1) <= MARGIN * shape.radius
        kept = _without_overlaps(len(x), ij[inside]) - np.count_nonzero(out > MARGIN * shape.radius)
        raise NotPacked(kept / len(x), said or "packmol leaves overlaps")
    # packmol has them kind by kind
    where = np.empty(len(kinds), dtype=int)
    where[np.argsort([names.index(k) for k in kinds], kind="stable")] = np.arange(len(kinds))
    return x[where], q[where]


def _input(shape, numbers, tube, seed, folder):
    """Writes the molecules and packmol's input."""
    r = shape.radius
    # at the wall it is the difference of the squares of distance and radius
    radius = tube.radius / r - 1
    radius -= 0.5 * _WALL / max(radius, 1)
    height = tube.height / r - 2 - 2 * _WALL
    text = (f"tolerance {2 + 2 * MARGIN:.6f}\nprecision {_PRECISION}\nseed {seed}\nnloop {_LOOPS}\n"
            "filetype xyz\noutput packmol.xyz\n")
    for kind, number in numbers:
        with open(os.path.join(folder, f"{kind}.xyz"), "w", encoding="utf-8") as f:
            f.write(f"{len(shape.centres)}\n{kind}\n")
            f.writelines("C {:.9f} {:.9f} {:.9f}\n".format(*c) for c in shape.centres / r @ _TILT)
        text += (f"structure {kind}.xyz\n  number {number}\n"
                 f"  inside cylinder 0. 0. {1 + _WALL:.6f} 0. 0. 1. {radius:.9f} {height:.9f}\nend structure\n")
    with open(os.path.join(folder, "packmol.inp"), "w", encoding="utf-8") as f:
        f.write(text)


def _run(say, folder, limit):
    """Runs packmol; gives why it ended early, nothing when it says it succeeded."""
    log = os.path.join(folder, "packmol.log")
    began = time.monotonic()
    # a file: packmol reads its input twice, which a pipe does not allow
    with open(log, "w", encoding="utf-8") as out, \
            open(os.path.join(folder, "packmol.inp"), encoding="utf-8") as text:
        try:
            child = subprocess.Popen([PROGRAM], cwd=folder, stdin=text, stdout=out, stderr=subprocess.STDOUT,
                                     preexec_fn=stops.die_with_parent())
        except OSError as e:
            raise CaseError(f"packing = packmol: the program {PROGRAM} cannot be run ({e.strerror}); "
                            "Debian's package packmol has it") from None
        try:
            while child.poll() is None:
                time.sleep(0.05)
                seconds = time.monotonic() - began
                say(f"packmol runs for {seconds:.0f} s")
                if seconds > limit:
                    return f"packmol was stopped after {limit:.0f} s"
        finally:
            if child.poll() is None:
                child.kill()
            child.wait()
    with open(log, encoding="utf-8", errors="replace") as f:
        said = f.read()
    if "Success!" in said:
        return ""
    if "unable to put the molecules" in said:
        return "packmol finds no room in the tube"
    errors = [line.strip() for line in said.splitlines() if "ERROR" in line]
    if errors:
        raise CaseError(f"packing = packmol: {errors[0]}; see packmol/packmol.log")
    return "packmol ended without a perfect packing"


def _read(path, shape, count):
    """Centres and rotations [m] from packmol's coordinates, by a rigid fit
    (Kabsch, Acta Crystallogr. A 32, 922, 1976)."""
    n, r = len(shape.centres), shape.radius
    with open(path, encoding="utf-8") as f:
        rows = [line.split()[1:4] for line in f.readlines()[2:] if line.strip()]
    if len(rows) != n * count:
        raise CaseError(f"packing = packmol: packmol.xyz has {len(rows)} atoms and must have {n * count}")
    points = np.array(rows, dtype=float).reshape(count, n, 3)
    x = points.mean(axis=1)
    q = np.tile([1.0, 0, 0, 0], (count, 1))
    if n > 1:
        body = shape.centres / r
        u, _, vt = np.linalg.svd(np.einsum("ksi,sj->kij", points - x[:, None], body))
        u[:, :, 2] *= np.sign(np.linalg.det(u @ vt))[:, None]
        q = _quaternions(u @ vt)
        far = np.abs(points - _points(body, x, u @ vt)).max()
        if far > _FIT:
            raise CaseError(f"packing = packmol: a clump's spheres are {far:.1e} radii from where a rigid clump has "
                            "them")
    return r * x, q


def _points(body, x, matrices):
    """Points (N, n, 3) of bodies turned and moved."""
    return np.einsum("kij,sj->ksi", matrices, body) + x[:, None]


def _quaternions(m):
    """Unit quaternions (N, 4) of rotation matrices (N, 3, 3), by the largest
    eigenvector of Bar-Itzhack's matrix (J. Guid. Control Dyn. 23, 1085, 2000)."""
    k = np.empty((len(m), 4, 4))
    trace = np.trace(m, axis1=1, axis2=2)
    k[:, 0, 0] = trace
    k[:, 1:, 1:] = m + m.transpose(0, 2, 1) - trace[:, None, None] * np.eye(3)
    turn = np.stack([m[:, 2, 1] - m[:, 1, 2], m[:, 0, 2] - m[:, 2, 0], m[:, 1, 0] - m[:, 0, 1]], axis=1)
    k[:, 0, 1:] = k[:, 1:, 0] = turn
    return np.linalg.eigh(k)[1][:, :, -1]


def _without_overlaps(count, ij):
    """How many particles are left when of each two that overlap one is taken
    away, those with the most overlaps first."""
    met = [set() for _ in range(count)]
    for i, j in ij.tolist():
        met[i].add(j)
        met[j].add(i)
    left = count
    while True:
        worst = max(range(count), key=lambda i: len(met[i]), default=0)
        if count == 0 or not met[worst]:
            return left
        for j in met[worst]:
            met[j].discard(worst)
        met[worst] = set()
        left -= 1
