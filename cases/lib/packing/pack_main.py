# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/pack: makes the packing of a case and nothing else, to look at."""

import argparse
import contextlib
import json
import os

import numpy as np

from cases.lib.case import casefile, program, settings
from cases.lib.case.errors import CaseError
from cases.lib.case.places import called
from cases.lib.case.program import run as run_program
from cases.lib.packing import packing


def parser():
    p = argparse.ArgumentParser(
        prog=called("pack"), allow_abbrev=False,
        description="Makes the packing of a case: packing.places for fix insert/placed, the report "
                    "packing.json, the picture packing.png, and packing.vtu for ParaView.",
        epilog=f"{called('run')} NAME --keys lists a case's keys; packing, solid_fraction, fill_height and "
               "seed are among them.")
    p.add_argument("name", metavar="NAME", help="the case")
    p.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="change a value")
    p.add_argument("--out", metavar="DIR", help="where to (results/NAME-packing)")
    p.add_argument("--no-pictures", action="store_true", help="draw nothing")
    return p


def _clear(out):
    """Refuses a folder that holds more than an older packing, or what a failed
    one left; its pictures go."""
    if not os.path.isdir(out):
        return
    there = os.listdir(out)
    if "case.txt" in there or "case.json" in there:
        raise CaseError(f"--out {out}: is the folder of a run; name a new folder")
    if "packing.json" not in there and not all(n == "packmol" or n.startswith("packing.") for n in there):
        raise CaseError(f"--out {out}: holds other things than a packing; name a new folder")
    for name in ("packing.png", "packing.vtu"):
        with contextlib.suppress(FileNotFoundError):
            os.remove(os.path.join(out, name))


def points(folder, v):
    """The spheres of a packing as columns, as of LIGGGHTS's dumps."""
    shape = packing.shape_of(v)
    kinds, x, q = packing.read_places(os.path.join(folder, "packing.places"))
    at = shape.spheres(x, q)
    n = len(shape.centres)
    zero = np.zeros(len(at))
    # kaolinite's spheres as 2: the types of charges need the template
    return {"id": np.arange(1, len(at) + 1), "mol": np.repeat(np.arange(1, len(x) + 1), n),
            "type": np.repeat([1 + (k == "kao") for k in kinds], n), "radius": zero + shape.radius,
            "x": at[:, 0], "y": at[:, 1], "z": at[:, 2], "vx": zero, "vy": zero, "vz": zero}


def draw(folder, v, report):
    """packing.png: the tube from the side, and from above."""
    from cases.lib.output import paraview, spheres
    from cases.lib.output.plotting import plt
    s = points(folder, v)
    paraview.write(os.path.join(folder, "packing.vtu"), s)
    radius, height = v["tube_radius"], v["tube_height"]
    tall = 6.0
    wide = tall * 2 * radius / height
    fig, (side, top) = plt.subplots(1, 2, figsize=(2 * wide + 0.6, tall + 0.5))
    image, extent = spheres.picture(s, radius, height)
    side.imshow(image, origin="lower", extent=extent, interpolation="antialiased")
    side.plot([-radius, -radius, radius, radius], [height, 0, 0, height], color="0.4", lw=0.7)
    side.plot([-radius, radius], 2 * [v["fill_height"]], color="0.4", lw=0.7, ls="--")
    # from above: the upper quarter of what is filled, along y
    part = s["z"] > 0.75 * v["fill_height"]
    down = {k: c[part] for k, c in s.items()}
    down["y"], down["z"] = down["z"] * -1, down["y"] + radius
    image, extent = spheres.picture(down, radius, 2 * radius, tilt=0.0)
    top.imshow(image, origin="lower", extent=extent, interpolation="antialiased")
    top.add_patch(plt.Circle((0, radius), radius, fill=False, color="0.4", lw=0.7))
    for a in (side, top):
        a.set_aspect("equal", anchor="N")
        a.axis("off")
    fig.suptitle(f"{report['count']} {report['particles']}, {report['method']}\n"
                 f"solid fraction {report['solid_fraction']:.3g}", fontsize=8, y=0.9, va="bottom")
    fig.savefig(os.path.join(folder, "packing.png"), dpi=170, bbox_inches="tight")
    plt.close(fig)


def main():
    args = parser().parse_args()
    # packmol ends with it
    case = casefile.Case(args.name)
    settings.apply(case, settings.read(args.set), print)
    if "packing" not in case.values:
        raise CaseError(f"case {args.name} has no packing")
    v = {**case.values, **case.derive(1, 1)}
    out = case.name + "-packing"
    _clear(settings.path(args.out, out))
    folder = settings.folder(args.out, out)
    report = packing.write(folder, v)
    print(json.dumps(report, indent=2))
    program.result(report)
    if not args.no_pictures:
        draw(folder, v, report)
    print(f"packing: files in {os.path.relpath(folder)}")
    return 0


if __name__ == "__main__":
    run_program(main, called("pack"))
