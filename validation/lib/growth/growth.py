# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""validation/growth: what a particle, a message and a cell cost, from small to large.

Every scene is validation/scenes/growth-scene, a cube of touching spheres on an inlet.
DEM: the DEM half alone, seconds a particle-step and memory a particle.
Exchange: the coupled run, seconds a particle an exchange, and the bytes and
messages of a rank. CFD: the same spheres on finer meshes, seconds a cell-step.
"""

import argparse
import csv
import json
import os
import re
import statistics
import subprocess
import sys
import time

from validation.lib.checks import coupled, plots
from validation.lib.checks.verdicts import Broken

DIAMETER = 2e-3
COLUMNS = ("part", "spheres", "cells", "dem_ranks", "cfd_ranks", "steps", "ns_each", "bytes_each",
           "messages_at_most", "bytes_a_rank", "memory_MB")
FOLDER = os.path.join(coupled.TOP, "results", "growth")
HELD_WITHIN = 0.20  # how flat the cost of a particle-step should be past the cache


def options(across, cell, steps):
    """The scene's settings for a cube of `across` spheres an edge, in cells of
    about `cell` diameters, for so many DEM steps."""
    edge = across * DIAMETER
    cells = max(1, round(across / cell))
    values = {"across": across, "size_x": edge, "size_y": edge, "size_z": 1.5 * edge, "cells_x": cells,
              "cells_y": cells, "cells_z": max(1, round(1.5 * cells)), "end": steps * 2e-5}
    words = [x for k, v in values.items() for x in ("--set", f"{k}={v:.10g}")]
    return words, cells * cells * max(1, round(1.5 * cells))


def prepared(where, words, ranks=(1, 1)):
    """The scene's run folder, made but not run."""
    folder = os.path.join(FOLDER, where)
    command = [os.path.join(coupled.TOP, "cases", "run"), "--no-setup", "growth-scene", "--out", folder, "--overwrite",
               "--dem", str(ranks[0]), "--cfd", str(ranks[1]), *words]
    outcome = coupled.execute([*command, "--dry-run"], 600)
    if outcome.status:
        raise Broken(f"growth-scene: {outcome.output.strip().splitlines()[-1:]}")
    return folder, command


def dem_alone(across, repeats):
    """A row: the DEM half by itself."""
    count = across**3
    steps = max(50, min(2000, 25 * round(1.2e7 / count / 25)))
    words, _ = options(across, 3, steps)
    folder, _ = prepared("dem", words)
    seconds, memory = [], 0
    for _ in range(repeats):
        command = [os.path.join(coupled.TOP, "build", "bin", "liggghts-clay"), "-in", "in.liggghts",
                   "-log", "none", "-var", "fluid", "alone"]
        run = subprocess.Popen(command, cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        said = run.stdout.read()
        _, status, used = os.wait4(run.pid, 0)
        found = re.search(r"Loop time of ([\d.e+-]+)", said)
        if status or not found:
            raise Broken(f"growth-scene alone, {count} spheres: {said.strip().splitlines()[-1:]}")
        seconds.append(float(found.group(1)))
        memory = max(memory, used.ru_maxrss * 1024)
    return {"part": "DEM", "spheres": count, "dem_ranks": 1, "steps": steps,
            "ns_each": 1e9 * statistics.median(seconds) / steps / count, "memory_MB": memory / 1e6,
            "bytes_each": memory / count}


def coupled_run(part, across, cell, steps, ranks):
    """A row: the coupled scene; each is a particle-exchange, or a cell-step for the CFD half."""
    words, cells = options(across, cell, steps)
    folder, command = prepared(part, words, ranks)
    outcome = coupled.execute([*command, "--no-pictures"], 3600)
    if outcome.status:
        raise Broken(f"growth-scene, {across}^3 spheres: {outcome.output.strip().splitlines()[-1:]}")
    count = across**3
    with open(os.path.join(folder, "DEM", "dem.json"), encoding="utf-8") as f:
        dem = json.load(f)
    with open(os.path.join(folder, "CFD", "cfd.json"), encoding="utf-8") as f:
        cfd = json.load(f)
    row = {"part": part, "spheres": count, "cells": cells, "dem_ranks": ranks[0], "cfd_ranks": ranks[1], "steps": steps}
    if part == "CFD":
        row["ns_each"] = 1e9 * cfd["cfd_s"] / cfd["cfd_steps"] / cells
    else:
        spent = dem["exchange_s"] + cfd["exchange_s"] + cfd["mapping_s"]
        row["ns_each"] = 1e9 * spent / dem["exchanges"] / count
        row["bytes_each"] = dem["bytes_sent"] / dem["exchanges"] / count
        row["bytes_a_rank"] = dem["bytes_sent"] / dem["exchanges"] / ranks[0]
        # a header to every CFD rank, and at most a state to it and an answer from it
        row["messages_at_most"] = 3 * ranks[1]
    return row


def flatness(rows, cache):
    """Largest relative distance of a particle-step's cost from its median, of
    scenes whose memory is past the cache [bytes]; None if fewer than two are."""
    costs = [r["ns_each"] for r in rows if r["part"] == "DEM" and r["spheres"] * r["bytes_each"] > cache]
    if len(costs) < 2:
        return None
    middle = statistics.median(costs)
    return max(abs(c / middle - 1) for c in costs)


def cache_size():
    """Bytes of the last cache of this machine's first core; 32 MB if it does not say."""
    path = "/sys/devices/system/cpu/cpu0/cache"
    found = []
    try:
        for entry in os.listdir(path):
            if entry.startswith("index"):
                with open(os.path.join(path, entry, "size"), encoding="utf-8") as f:
                    found.append(int(f.read().strip().rstrip("K")) * 1024)
    except (OSError, ValueError):
        pass
    return max(found, default=32 << 20)


def draw(rows):
    def of(part, x, same=lambda r: True):
        chosen = [r for r in rows if r["part"] == part and same(r)]
        return [r[x] for r in chosen], [r["ns_each"] for r in chosen]

    def alone(r):
        return r["dem_ranks"] == r["cfd_ranks"] == 1

    series = [("DEM: particle-step", *of("DEM", "spheres"), "line"),
              ("exchange and mapping: particle-exchange", *of("exchange", "spheres", alone), "line"),
              ("CFD: cell-step, over cells", *of("CFD", "cells"), "line")]
    return plots.compare(os.path.join(FOLDER, "growth.png"), series, "spheres (CFD: cells)", "cost of one [ns]",
                         "growth of costs, one rank each", logx=True, logy=True)


def main():
    p = argparse.ArgumentParser(prog="validation/growth", allow_abbrev=False, description=__doc__.splitlines()[0])
    p.add_argument("--json", metavar="FILE", help="write the rows as JSON, too")
    p.add_argument("--quick", action="store_true", help="up to 33 thousand spheres only")
    p.add_argument("--repeats", type=int, default=3, metavar="N", help="runs of each DEM scene (3)")
    args = p.parse_args()
    big = [] if args.quick else [50, 100]
    tasks = [(f"DEM, {n}^3 spheres", dem_alone, (n, args.repeats if n < 60 else 1)) for n in [13, 20, 32] + big]
    tasks += [(f"exchange, {n}^3 spheres", coupled_run, ("exchange", n, 3, 250, (1, 1)))
              for n in [13, 20, 32] + big[:1]]
    tasks += [(f"exchange, 32^3 spheres on {a}+{b} ranks", coupled_run, ("exchange", 32, 3, 50, (a, b)))
              for a, b in ((1, 2), (2, 2), (4, 4))]
    tasks += [(f"CFD, cells of {cell} d", coupled_run, ("CFD", 20, cell, 250, (1, 1))) for cell in (4, 2, 1, 0.5)]
    os.makedirs(FOLDER, exist_ok=True)
    rows, began = [], time.monotonic()
    for i, (words, work, given) in enumerate(tasks):
        row = work(*given)
        rows.append(row)
        spent = time.monotonic() - began
        print(f"{i + 1:>2} of {len(tasks)}  {words:<42} {row['ns_each']:>9.1f} ns   {spent:.0f} s so far", flush=True)
    with open(os.path.join(FOLDER, "growth.csv"), "w", encoding="utf-8", newline="") as f:
        out = csv.DictWriter(f, COLUMNS, lineterminator="\n")
        out.writeheader()
        out.writerows(rows)
    if args.json:
        with open(args.json, "w", encoding="utf-8") as f:
            json.dump(rows, f, indent=2)
            f.write("\n")
    flat = flatness(rows, cache_size())
    if flat is not None:
        print(f"a particle-step past the cache ({cache_size() >> 20} MB) is flat within {100 * flat:.0f} % "
              f"(must be within {100 * HELD_WITHIN:.0f} %)")
    print(f"picture: {os.path.relpath(draw(rows))}")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Broken as e:
        print(f"validation/growth: {e}", file=sys.stderr)
        sys.exit(1)
