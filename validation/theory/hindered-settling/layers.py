# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Writes layers.places: layers of spheres, each of its own solid fraction. In a
layer the spheres stand in upright columns on a square pattern, evenly spaced;
the columns' phases are spread evenly, so that every cut through the layer
finds the same share of solids, up to the rounding of a few spheres."""

import math
import os

# solid fractions from the floor upwards, and how many cells high the layers are: the
# ends of a layer, thinner by half a sphere, show some cells far where it is dense
LAYERS = ((0.02, 5), (0.05, 5), (0.1, 5), (0.15, 5), (0.25, 7), (0.35, 7), (0.45, 9), (0.5, 9))
D, WIDTH, CELL = 1e-3, 8.16e-3, 4.08e-3  # sphere, box, cell [m]


def columns(phi):
    """How many along a side: as near to equal spacing in all directions as goes."""
    return max(1, min(math.floor(WIDTH / (1.02 * D)), round(WIDTH / (math.pi / 6 / phi)**(1 / 3) / D)))


def layer(phi, bottom, height):
    """Centres of the spheres [m], in order of columns."""
    k = columns(phi)
    side = WIDTH / k
    spacing = math.pi / 6 * D**3 / (phi * side**2)
    marks = [((i * 0.7548776662 + j * 0.5698402910) % 1.0, i, j) for i in range(k) for j in range(k)]
    found = []
    for rank, (_, i, j) in enumerate(sorted(marks)):
        z = bottom + (rank + 0.5) / k**2 * spacing
        while z < bottom + height - 0.5 * D:
            if z >= bottom + 0.5 * D:
                found.append(((i + 0.5) * side, (j + 0.5) * side, z))
            z += spacing
    return found


if __name__ == "__main__":
    here = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(here, "layers.places"), "w", encoding="utf-8") as f:
        f.write("# made by layers.py: template, x, y, z [m]\n")
        bottom = 0.0
        for phi, cells in LAYERS:
            f.writelines(f"1 {x:.7g} {y:.7g} {z:.7g}\n" for x, y, z in layer(phi, bottom, cells * CELL))
            bottom += cells * CELL
