# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The same packed bed on four kinds of mesh, and on several ranks."""

import os

import numpy as np

from validation.lib.checks import coupled, fields, plots

TITLE = "a packed bed on hexahedra, warped ones, tetrahedra, polyhedra, and on several ranks"
LONG = True

_RHO, _SPEED = 10.0, 0.01
# lattice of fixed-bed-scene, smoothed over 2 d; the drop between two heights inside of it
_SET = ("layers=30", "spheres=960", "size_z=0.0442", "cells_x=2", "cells_y=2", "cells_z=17", "smoothing=diffusion",
        "bandwidth=3e-3", "frames=1",
        f"velocity_from={_SPEED}", f"velocity_to={_SPEED}", f"start_velocity={_SPEED}", "sides=slip")
_LOW, _HIGH = 0.0130, 0.0312  # m: inside of the bed, which reaches from 2.6 to 41.6 mm


def _profile(folder):
    """Height of the cells [m], real pressure without hydrostatics [Pa], velocities [m/s]."""
    c = fields.centres(folder)
    at = fields.times(folder)[-1][1]
    return c[:, 2], _RHO * fields.field(at, "p", len(c)), fields.field(at, "U", len(c)), \
        fields.field(at, "voidfraction", len(c))


def _gradient(z, p):
    """Pressure gradient between the two heights, by least squares [Pa/m]."""
    use = (z > _LOW) & (z < _HIGH)
    return -float(np.polyfit(z[use], p[use], 1)[0])


def _run(name, *more, ranks=()):
    words = [w for s in _SET + more for w in ("--set", s)]
    return coupled.finished("fixed-bed-scene", "meshes/" + name, "--end", "0.01", *words, *ranks)


def run(checks):
    law = 150 * 0.548665**2 / 0.451335**3 * 1.5e-3 * _SPEED / 1e-6
    law += 1.75 * 0.548665 / 0.451335**3 * _RHO * _SPEED**2 / 1e-3
    curves, first = [], None
    for kind in ("hex", "warped", "tet", "poly"):
        folder = _run(kind, f"mesh={kind}")
        z, p, u, n = _profile(folder)
        slope = _gradient(z, p)
        first = first or slope
        checks.close(f"{kind}: pressure gradient inside [Pa/m], against Ergun", slope, law, 0.02)
        if kind != "hex":
            checks.close(f"{kind}: the same, against hexahedra", slope, first, 0.02)
        inside = (z > _LOW) & (z < _HIGH)
        flow = n[inside] * u[inside, 2]
        checks.close(f"{kind}: mean of n U inside [m/s]", float(flow.mean()), _SPEED, 0.01)
        s = coupled.summary(folder)
        checks.at_most(f"{kind}: momentum residual", s["max_momentum_residual"], 1e-10)
        checks.at_most(f"{kind}: volume error", s["max_void_fraction_volume_error"], 1e-12)
        order = np.argsort(z)
        curves.append((kind, 1e3 * z[order], p[order], "dashed" if kind == "hex" else "dots"))
        if kind in ("hex", "tet"):
            many = _run(kind + "-1+2", f"mesh={kind}", ranks=("--cfd", "2"))
            z2, p2, u2, _ = _profile(many)
            checks.at_most(f"{kind}: pressure on 1 + 2 ranks against 1 + 1, over the largest",
                           float(abs(p2 - p).max() / p.max()), 1e-5)
            checks.at_most(f"{kind}: velocity, the same", float(abs(u2 - u).max() / abs(u).max()), 1e-4)
    checks.picture(plots.compare(os.path.join(coupled.RUNS, "meshes", "pressure.png"), curves, "height [mm]",
                                 "pressure [Pa]", "a held bed of porosity 0.451 on four meshes"))
