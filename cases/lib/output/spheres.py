# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The DEM half's output: reads LIGGGHTS's dumps, draws their spheres."""

import glob
import os
import re

import numpy as np

from cases.lib.case.errors import CaseError


def dumps(folder):
    """The dumps of a run as (step, path), in order of time."""
    found = []
    for path in glob.glob(os.path.join(glob.escape(folder), "DEM", "spheres.*.dump")):
        found.append((int(re.search(r"\.(\d+)\.dump$", path).group(1)), path))
    if not found:
        raise CaseError(f"{folder}/DEM holds no dumps, spheres.*.dump; does in.liggghts write them?")
    return sorted(found)


def read(path):
    """A dump's columns by name, each an array; CaseError when it is not whole."""
    with open(path, encoding="utf-8") as f:
        count, columns = None, []
        for line in f:
            if line.startswith("ITEM: NUMBER OF ATOMS"):
                count = f.readline().strip()
            if line.startswith("ITEM: ATOMS"):
                columns = line.split()[2:]
                break
        rest = f.read()
    words = rest.split()
    try:
        if words and not rest.endswith((" ", "\n")) or count is not None and len(words) != int(count) * len(columns):
            raise ValueError
        rows = np.array(words, dtype=float).reshape(-1, len(columns))
    except ValueError:
        raise CaseError(f"{path}: is not a whole dump") from None
    return {c: rows[:, i] for i, c in enumerate(columns)}


def hues(s):
    """A colour for every sphere, that of its clump; neighbours differ."""
    import colorsys
    of = {}
    for k in np.unique(s.get("mol", s["id"])).astype(int):
        # hues a golden section apart
        of[k] = colorsys.hsv_to_rgb(k * 0.618034 % 1, 0.45 + 0.4 * (k % 3) / 2, 0.98)
    return np.array([of[int(k)] for k in s.get("mol", s["id"])])


def picture(s, radius, height, pixels=8000.0, tilt=8.0, colours=None):
    """An image (rows, columns, RGBA) of the spheres, coloured by clump.

    Seen level with the tube's axis, from tilt degrees above; pixels a metre.
    colours: one for every sphere (RGB), in place of hues(s).
    """
    colours = hues(s) if colours is None else colours
    c, sn = np.cos(np.radians(tilt)), np.sin(np.radians(tilt))
    right, depth = s["x"], -s["y"] * c + s["z"] * sn
    up = s["z"] * c + s["y"] * sn
    low, high = -radius * sn, height * c + radius * sn
    columns, rows = int(2 * radius * pixels), int((high - low) * pixels)
    image = np.zeros((rows, columns, 4))
    nearest = np.full((rows, columns), -np.inf)
    light = np.array([-0.45, 0.55, 0.70])
    light /= np.linalg.norm(light)
    for i in range(len(right)):
        r = s["radius"][i] * pixels
        x, y = (right[i] + radius) * pixels, (up[i] - low) * pixels
        x0, x1 = max(0, int(x - r)), min(columns, int(x + r) + 2)
        y0, y1 = max(0, int(y - r)), min(rows, int(y + r) + 2)
        if x0 >= x1 or y0 >= y1:
            continue
        u = (np.arange(x0, x1) + 0.5 - x)[None, :] / r
        v = (np.arange(y0, y1) + 0.5 - y)[:, None] / r
        inside = 1 - u * u - v * v
        w = np.sqrt(np.maximum(inside, 0))
        z = depth[i] * pixels + w * r
        shown = (inside > 0) & (z > nearest[y0:y1, x0:x1])
        nearest[y0:y1, x0:x1][shown] = z[shown]
        shade = 0.35 + 0.65 * np.maximum(0, light[0] * u + light[1] * v + light[2] * w)
        image[y0:y1, x0:x1][shown] = np.concatenate(
            [np.clip(shade[shown][:, None] * colours[i], 0, 1), np.ones((shown.sum(), 1))], axis=1)
    return image, (-radius, radius, low, high)
