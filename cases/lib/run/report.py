# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""After a run: summary.json, settling.csv with days, pictures, a short table."""

import csv
import glob
import json
import os
import re
import shutil
import subprocess
import sys
import time

from cases.lib.case import openfoam
from cases.lib.case.casefile import TOP
from cases.lib.case.errors import CaseError

_DAY = 86400.0


def _json(folder, *names):
    path = os.path.join(folder, *names)
    try:
        with open(path, encoding="utf-8") as f:
            return json.load(f)
    except OSError:
        raise CaseError(f"{path} is missing: that half did not come to its end") from None
    except ValueError as e:
        raise CaseError(f"{path}: {e}") from None


def curve(folder, time_scale):
    """settling.csv's columns by name; adds the column of days if it lacks one."""
    path = os.path.join(folder, "settling.csv")
    with open(path, encoding="utf-8", newline="") as f:
        lines = [line for line in f if not line.startswith("#")]
    rows = list(csv.DictReader(lines))
    if not rows:
        raise CaseError(f"{path}: holds no rows")
    if "time_days" not in rows[0]:
        keys = ["time_s", "time_days"] + [k for k in rows[0] if k != "time_s"]
        for row in rows:
            row["time_days"] = f"{float(row['time_s']) * time_scale / _DAY:.8g}"
        with open(path, "w", encoding="utf-8", newline="") as f:
            out = csv.DictWriter(f, keys, lineterminator="\n")
            out.writeheader()
            out.writerows(rows)
    return rows


def _alone(run):
    """Seconds the same DEM half takes for the same steps without the fluid."""
    folder = os.path.join(run.folder, "alone")
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(os.path.join(folder, "DEM"))
    for pattern in ("*.liggghts", "*.places"):
        for path in glob.glob(os.path.join(glob.escape(run.folder), pattern)):
            shutil.copy(path, folder)
    print("the DEM half alone, for comparison ...", flush=True)
    began = time.monotonic()
    with open(os.path.join(folder, "log"), "w", encoding="utf-8") as log:
        status = subprocess.call(
            ["mpirun", "--bind-to", "none", "-np", str(run.dem), "liggghts-clay",
             "-in", "in.liggghts", "-log", "none", "-var", "fluid", "alone"],
            cwd=folder, env=run.environment(), stdin=subprocess.DEVNULL, stdout=log,
            stderr=subprocess.STDOUT)
    if status:
        raise CaseError(f"the DEM half alone failed with exit code {status} (log in {folder}/log)")
    return time.monotonic() - began


def _version():
    """The project's version, from where CMake has it."""
    with open(os.path.join(TOP, "CMakeLists.txt"), encoding="utf-8") as f:
        return re.search(r"project\(\w+ VERSION ([\d.]+)", f.read()).group(1)


def summary(case, run, derived, alone_s):
    """What both halves measured, in one place."""
    dem, cfd = _json(run.folder, "DEM", "dem.json"), _json(run.folder, "CFD", "cfd.json")
    s = {
        "case": case.name,
        "versions": {"clayFoam": _version(), "dem": dem["program"],
                     "cfd": f"{cfd['program']} on OpenFOAM {cfd.get('openfoam', '')}".strip()},
        "settings": {**case.values, **derived, "dem": dem.get("settings", {}),
                     "cfd": cfd.get("settings", {})},
        "seed": case.values["seed"],
        "particles": dem["particles"],
        "particles_lost": dem["particles_lost"],
        "clumps": dem.get("clumps"),
        "simulated_s": dem.get("simulated_s", case.values["end"]),
        "wall_s": round(run.wall, 3),
        "dem_s": dem["dem_s"],
        "cfd_s": cfd["cfd_s"],
        "mapping_s": cfd.get("mapping_s"),
        "exchange_s": dem["exchange_s"] + cfd["exchange_s"],
        "waiting_s": dem["waiting_s"] + cfd["waiting_s"],
        "output_s": dem["output_s"] + cfd.get("output_s", 0),
        "exchange_dem_s": dem["exchange_s"], "exchange_cfd_s": cfd["exchange_s"],
        "waiting_dem_s": dem["waiting_s"], "waiting_cfd_s": cfd["waiting_s"],
        "dem_steps": dem["dem_steps"],
        "cfd_steps": cfd["cfd_steps"],
        "exchanges": dem["exchanges"],
        "max_overlap_over_d": dem["max_overlap_over_d"],
        "max_momentum_residual": cfd["max_momentum_residual"],
        "max_void_fraction_volume_error": cfd["max_void_fraction_volume_error"],
        "reynolds_max": cfd["reynolds_max"],
        "courant_max": cfd["courant_max"],
        "dem_alone_s": alone_s,
        "coupled_over_dem": round(run.wall / (alone_s or max(dem["dem_s"], 1e-9)), 4),
        "warnings": dem.get("warnings", []) + cfd.get("warnings", []),
    }
    with open(os.path.join(run.folder, "summary.json"), "w", encoding="utf-8") as f:
        json.dump(s, f, indent=2)
        f.write("\n")
    return s


def table(s):
    wall = s["wall_s"] or 1e-9
    against = "the same DEM run alone" if s["dem_alone_s"] else "its own DEM steps alone (dem_s)"
    rows = [
        ("wall time", f"{s['wall_s']:.1f} s for {s['simulated_s']:.4g} s simulated"),
        ("DEM half", f"{s['dem_s']:.1f} s stepping, {s['waiting_dem_s']:.1f} s waiting"),
        ("CFD half",
         f"{s['cfd_s'] + (s['mapping_s'] or 0):.1f} s solving and mapping, {s['waiting_cfd_s']:.1f} s waiting"),
        ("exchange", f"{100 * s['exchange_dem_s'] / wall:.1f} % of the DEM half's time, "
                     f"{100 * s['exchange_cfd_s'] / wall:.1f} % of the CFD half's"),
        ("waiting", f"{100 * s['waiting_dem_s'] / wall:.1f} % of the DEM half's time, "
                    f"{100 * s['waiting_cfd_s'] / wall:.1f} % of the CFD half's"),
        ("coupled / DEM", f"{s['coupled_over_dem']:.3f} times {against}"),
        ("overlap / d", f"{s['max_overlap_over_d']:.2e} at most"),
        ("momentum", f"{s['max_momentum_residual']:.1e} residual, "
                     f"volume {s['max_void_fraction_volume_error']:.1e}"),
        ("Reynolds", f"{s['reynolds_max']:.3g} at most, Courant {s['courant_max']:.3g}"),
        ("particles", f"{s['particles']}, lost {s['particles_lost']}"),
    ]
    return "\n".join(f"  {a:<14}{b}" for a, b in rows)


def finish(case, run, derived, alone=False, pictures=True):
    """All that follows a run; returns the exit code."""
    v = case.values
    scale = v.get("time_scale", 1.0)
    settled = os.path.isfile(os.path.join(run.folder, "settling.csv"))
    rows = curve(run.folder, scale) if settled else []
    s = summary(case, run, derived, _alone(run) if alone else None)
    if run.cfd > 1:
        openfoam.run("reconstructPar", os.path.join(run.folder, "CFD"))
    from cases.lib.output import paraview
    if glob.glob(os.path.join(glob.escape(run.folder), "DEM", "spheres.*.dump")):
        paraview.time_series(run.folder, v["dem_step"])
    if pictures and settled and "tube_radius" in v:
        import numpy as np
        from cases.lib.output import pictures as draw
        arrays = {k: np.array([float(r[k]) for r in rows]) for k in rows[0]}
        draw.settling(run.folder, arrays, scale, case.title)
        draw.columns(run.folder, v, case.title)
    more = ""
    if pictures and settled and v.get("velocity_to", 0) > v.get("velocity_from", 0) and v["bottom"] == "inlet":
        from cases.lib.run import beds
        import numpy as np
        arrays = {k: np.array([float(r[k]) for r in rows]) for k in rows[0]}
        more = "".join(f"\n  {a:<14}{b}" for a, b in beds.finish(run.folder, {**v, **derived}, arrays, case.title))
    print(table(s) + more)
    for warning in s["warnings"]:
        print(f"  warning: {warning}")
    shown = os.path.relpath(run.folder, os.getcwd())
    print(f"results in {shown if not shown.startswith('../..') else run.folder}")
    if s["particles_lost"]:
        print(f"cases/run: {s['particles_lost']} particles were lost", file=sys.stderr)
        return 1
    return 0
