# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Two pairs of saved states compared: particles by their tags, the fluid by its cells."""

import os
import re
import struct

import numpy as np

from cases.lib.run import saved_pairs as pairs
from validation.lib.checks.verdicts import Broken

_INTERNAL = re.compile(rb"internalField\s+nonuniform\s+List<(scalar|vector)>\s+(\d+)\s*\(")
_PLACE = re.compile(rb'location +"[^"]*";')


def particles(pair):
    """The particles' rows in a restart file of LIGGGHTS, {tag: array}: length, place, tag, type, groups,
    image, velocity, radius, mass, spin, and what the fixes keep."""
    with open(pair.dem, "rb") as f:
        content = f.read()
    with open(os.path.join(os.path.dirname(pair.dem), "about"), encoding="utf-8") as f:
        ranks = int(re.search(r"ranks (\d+)", f.read()).group(1))
    for start in range(len(content) - 4):  # its last part: for each rank a number of doubles, and these
        chunks = _chunks(content, start, ranks)
        if chunks is not None:
            rows = _rows(chunks)
            if rows:
                return rows
    raise Broken(f"{pair.dem}: no particles in it")


def _chunks(content, at, ranks):
    found = []
    for _ in range(ranks):
        if at + 4 > len(content):
            return None
        size = struct.unpack_from("<i", content, at)[0]
        if size < 0 or at + 4 + 8 * size > len(content):
            return None
        found.append(content[at + 4:at + 4 + 8 * size])
        at += 4 + 8 * size
    return found if at == len(content) else None


def _rows(chunks):
    rows = {}
    for chunk in chunks:
        numbers, at = np.frombuffer(chunk), 0
        while at < len(numbers):
            length = numbers[at]
            if not (16 <= length <= len(numbers) - at and length == int(length)):
                return None
            rows[struct.unpack_from("<i", chunk, 8 * (at + 4))[0]] = numbers[at:at + int(length)]
            at += int(length)
    return rows


def field(pair, name):
    """A field of cells of a state that one rank has saved, None where it is uniform."""
    with open(os.path.join(pair.cfd[0], name), "rb") as f:
        content = f.read()
    match = _INTERNAL.search(content)
    if not match:
        return None
    width = 3 if match.group(1) == b"vector" else 1
    return np.frombuffer(content, count=int(match.group(2)) * width, offset=match.end()).reshape(-1, width)


def _blocks(row):
    """A particle's row: what LIGGGHTS keeps, then of each fix its block, which begins with its length. The order of
    the fixes is that of the script, which is another one in a run that goes on: sorted."""
    for start in range(16, len(row)):
        at, blocks = start, []
        while at < len(row) and 1 <= row[at] <= len(row) - at and row[at] == int(row[at]):
            blocks.append(row[at:at + int(row[at])].tobytes())
            at += int(row[at])
        if at == len(row) and blocks:
            return [row[:start].tobytes(), *sorted(blocks)]
    return [row.tobytes()]


def differences(one, other):
    """How far two states are apart: places by the radius, velocities of particles and fluid by the largest
    speed; and whether all fields of the fluid are the same to the last bit."""
    a, b = particles(one), particles(other)
    if a.keys() != b.keys():
        raise Broken(f"{len(a)} particles in {one.folder}, {len(b)} or others in {other.folder}")
    x, y = (np.array([rows[tag][:11] for tag in sorted(rows)]) for rows in (a, b))
    radius = next(iter(a.values()))[11]
    speed = np.abs(x[:, 8:11]).max()
    found = {"place": np.abs(x[:, 1:4] - y[:, 1:4]).max() / radius,
             "velocity": np.abs(x[:, 8:11] - y[:, 8:11]).max() / max(speed, 1e-300)}
    if len(one.cfd) == len(other.cfd) == 1:
        u, v = field(one, "U"), field(other, "U")
        found["fluid"] = np.abs(u - v).max() / max(np.abs(u).max(), 1e-300)
    found["same"] = all(_blocks(a[tag]) == _blocks(b[tag]) for tag in a) and _same_files(one, other)
    return found


def _same_files(one, other):
    """Whether all that the CFD half saved is the same, but for the pair's number."""
    for part, like in zip(one.cfd, other.cfd):
        for folder, _, names in os.walk(part):
            for name in names:
                if name in ("sums", "couplingPair"):
                    continue
                path = os.path.join(folder, name)
                twin = os.path.join(like, os.path.relpath(path, part))
                with open(path, "rb") as f, open(twin, "rb") as g:
                    # the header names the last output's time
                    if _PLACE.sub(b"", f.read()) != _PLACE.sub(b"", g.read()):
                        return False
    return len(one.cfd) == len(other.cfd)


def last(folder):
    """The last pair of a run's folder."""
    return pairs.latest(folder, lambda _: None)
