# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What a run will need, foreseen from its settings before any work is done.

Costs are those of GROWTH.md, of one core; charges and clumps cost more, a bed at
rest less: the time is good to a factor of three, the memory to a factor of two.
"""

import math
import os
from dataclasses import dataclass

from cases.lib.case.errors import CaseError

_RANK = 60e6          # memory [bytes] of a rank with nothing in it
_SPHERE = 2.5e3       # of a sphere in the DEM half
_CELL = 8e3           # of a cell in the CFD half, with its kept factors
_MESHING = 1.2e3      # of a cell in blockMesh
_NEAR = 4             # of a pair within the cut-off of charges
_STEP = 80e-9         # time [s] of a sphere and DEM step
_PAIR = 4e-9          # of a pair of charges
_EXCHANGE = 1e-6      # of a sphere and exchange
_SOLVED = 4e-6        # of a cell and exchange
_OUTPUT = 200         # disk [bytes] of a sphere or cell in a frame
_RANKS_A_CORE = 8


@dataclass(frozen=True)
class Plan:
    """Counts, memory [bytes], time [s] and disk [bytes] of a run."""

    cells: int
    spheres: int
    steps: int
    exchanges: int
    memory: float
    seconds: float
    disk: float

    def line(self):
        """In one line, as a run begins with."""
        grains = f"{self.spheres} spheres, " if self.spheres else ""
        return (f"plan: {self.cells} cells, {grains}{self.steps} steps, {self.exchanges} exchanges; "
                f"about {_bytes(self.memory)} of memory, {_bytes(self.disk)} of disk, {_time(self.seconds)}")


def cells_of(v):
    """Cells of a case's mesh, 0 if it is neither a column's nor a box's."""
    if "core_cells" in v:
        return int(v["core_cells"]) * (int(v["core_cells"]) + 4 * int(v["ring_cells"])) * int(v["layers"])
    if "cells_x" in v:
        return int(v["cells_x"]) * int(v["cells_y"]) * int(v["cells_z"]) * (6 if v.get("mesh") == "tet" else 1)
    return 0


def spheres_of(v):
    """Spheres of a case, 0 if its script alone knows."""
    for key, each in (("clumps", 14), ("spheres", 1), ("particles", 14 if v.get("shape") == "clumps" else 1)):
        if isinstance(v.get(key), (int, float)):
            return int(v[key]) * each
    if "across_x" in v:
        return int(v["across_x"]) * int(v["across_y"]) * int(v["across_z"])
    return int(v["across"])**3 if "across" in v and "layers" not in v else 0


def _pairs(v, spheres):
    """Pairs of charges within the cut-off, of spheres spread evenly over their room."""
    if not v.get("charge") or "cutoff" not in v:
        return 0.0
    if "tube_radius" in v:
        room = math.pi * v["tube_radius"]**2 * v["fill_height"]
    else:
        room = v["size_x"] * v["size_y"] * v["size_z"]
    return 0.5 * spheres * min(spheres, spheres * 4 / 3 * math.pi * v["cutoff"]**3 / room)


def foresee(v):
    """The Plan of a case with values v, derived ones among them."""
    cells, spheres = cells_of(v), spheres_of(v)
    ranks = v["dem_ranks"] + v["cfd_ranks"]
    steps, exchanges = v["steps"], max(1, v["steps"] // int(v["coupling_steps"]))
    pairs = _pairs(v, spheres)
    dem = steps * (spheres * _STEP + pairs * _PAIR / v.get("coulomb_steps", 1)) / v["dem_ranks"]
    cfd = exchanges * (spheres * _EXCHANGE + cells * _SOLVED) / v["cfd_ranks"]
    together = v.get("overlap") == "yes" and ranks <= (os.cpu_count() or 1)
    memory = max(ranks * _RANK + spheres * _SPHERE + pairs * _NEAR + cells * _CELL, cells * _MESHING)
    return Plan(cells, spheres, steps, exchanges, memory, max(dem, cfd) if together else dem + cfd,
                (v["steps"] // v["frame_steps"] + 1) * _OUTPUT * (spheres + cells))


def machine_memory():
    """Memory [bytes] of this machine, or of the container this runs in."""
    found = [math.inf]
    for path, scale in (("/sys/fs/cgroup/memory.max", 1), ("/sys/fs/cgroup/memory/memory.limit_in_bytes", 1),
                        ("/proc/meminfo", 1024)):
        try:
            with open(path, encoding="utf-8") as f:
                words = f.readline().split()
            found.append(float(words[1 if scale > 1 else 0]) * scale)
        except (OSError, ValueError, IndexError):  # "max": no limit
            continue
    return min(found)


def check(plan, v, cores, memory):
    """Refuses what the machine cannot do: more ranks than cells, far more than cores, more memory than there is."""
    dem, cfd = v["dem_ranks"], v["cfd_ranks"]
    if plan.cells and cfd > plan.cells:
        raise CaseError(f"--cfd {cfd}: must be at most the {plan.cells} cells of the mesh")
    if dem + cfd > _RANKS_A_CORE * cores:
        raise CaseError(f"--dem {dem} --cfd {cfd}: must be at most {_RANKS_A_CORE * cores} ranks on the {cores} "
                        "cores of this machine; --oversize does it all the same")
    if plan.memory > memory:
        raise CaseError(f"{plan.line()}: this machine has {_bytes(memory)}; take fewer cells or particles, "
                        "or --oversize")


def _bytes(n):
    """Bytes as one says them."""
    return f"{n / 1e9:.3g} GB" if n >= 1e9 else f"{max(1, n / 1e6):.0f} MB"


def _time(seconds):
    """A length of time as one says it."""
    for name, unit in (("years", 3.15576e7), ("days", 86400), ("h", 3600), ("min", 60)):
        if seconds >= 1.5 * unit:
            return f"{seconds / unit:.3g} {name}"
    return f"{max(1.0, seconds):.0f} s"
