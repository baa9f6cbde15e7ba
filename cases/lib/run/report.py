# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""After a run: summary.json, settling.csv with days, pictures, a short table."""

import contextlib
import csv
import glob
import os
import shutil
import subprocess
import sys
import time

from cases.lib.case import files, heading, openfoam, places, program
from cases.lib.case.errors import CaseError
from cases.lib.case.places import called
from cases.lib.run import series, state
from cases.lib.theory import screening, similarity

_DAY = 86400.0


def curve(folder, time_scale):
    """settling.csv's columns by name, its whole rows; adds the column of days if it lacks one."""
    path = os.path.join(folder, "settling.csv")
    with open(path, encoding="utf-8", newline="") as f:
        lines = [line for line in f if not line.startswith("#") and line.endswith("\n")]
    rows = [r for r in csv.DictReader(lines) if None not in r and None not in r.values()]
    if not rows:
        raise CaseError(f"{path}: holds no rows")
    if "time_days" not in rows[0]:
        keys = ["time_s", "time_days"] + [k for k in rows[0] if k != "time_s"]
        for row in rows:
            row["time_days"] = f"{float(row['time_s']) * time_scale / _DAY:.8g}"
        with files.writing(path, newline="") as f:
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


def _sum(*values):
    """The sum, None when one of them is."""
    return None if None in values else sum(values)


def summary(case, run, derived, alone_s, lacking=""):
    """What both halves measured, in one place; lacking: why the run is not complete. What a half
    has not told is None."""
    dem, cfd = state.halves(run.folder)
    idle = case.idle()  # solids is not said of a run with clumps = 60
    s = {
        "case": case.name,
        "title": heading.of(case, derived),
        "complete": not lacking,
        "simulated_s": state.reached(run.folder),
        "end": case.values["end"],
        **({"reason": lacking} if lacking else {}),
        "versions": {"clayFoam": places.version(), "dem": dem.get("program"),
                     "cfd": f"{cfd['program']} on OpenFOAM {cfd.get('openfoam', '')}".strip() if cfd else None},
        "settings": {**{k: x for k, x in case.values.items() if k not in idle}, **derived,
                     "dem": dem.get("settings", {}), "cfd": cfd.get("settings", {})},
        "seed": case.values["seed"],
        "particles": dem.get("particles"),
        "particles_lost": dem.get("particles_lost"),
        "clumps": dem.get("clumps"),
        "wall_s": round(run.wall, 3),
        "dem_s": dem.get("dem_s"),
        "cfd_s": cfd.get("cfd_s"),
        "mapping_s": cfd.get("mapping_s"),
        "exchange_s": _sum(dem.get("exchange_s"), cfd.get("exchange_s")),
        "waiting_s": _sum(dem.get("waiting_s"), cfd.get("waiting_s")),
        "output_s": _sum(dem.get("output_s"), cfd.get("output_s", 0)),
        "exchange_dem_s": dem.get("exchange_s"), "exchange_cfd_s": cfd.get("exchange_s"),
        "waiting_dem_s": dem.get("waiting_s"), "waiting_cfd_s": cfd.get("waiting_s"),
        "dem_steps": dem.get("dem_steps"),
        "cfd_steps": cfd.get("cfd_steps"),
        "exchanges": dem.get("exchanges"),
        "max_overlap_over_d": dem.get("max_overlap_over_d"),
        "max_momentum_residual": cfd.get("max_momentum_residual"),
        "max_void_fraction_volume_error": cfd.get("max_void_fraction_volume_error"),
        "reynolds_max": cfd.get("reynolds_max"),
        "courant_max": cfd.get("courant_max"),
        "dem_alone_s": alone_s,
        "coupled_over_dem": round(run.wall / (alone_s or max(dem["dem_s"], 1e-9)), 4) if dem else None,
        **({"groups": similarity.as_json(similarity.groups({**case.values, **derived}))}
           if "prototype_diameter" in case.values else {}),
        "warnings": dem.get("warnings", []) + cfd.get("warnings", []) +
        screening.warnings({**case.values, **derived}, dem.get("max_overlap_over_d")),
    }
    files.write_json(os.path.join(run.folder, "summary.json"), s)
    return s


def table(s):
    """A short table of a summary, without the rows of what is not known."""
    wall = s["wall_s"] or 1e-9
    against = "the same DEM run alone" if s["dem_alone_s"] else "its own DEM steps alone (dem_s)"
    rows = [
        ("wall time", lambda: f"{s['wall_s']:.1f} s for {s['simulated_s']:.4g} s simulated"),
        ("DEM half", lambda: f"{s['dem_s']:.1f} s stepping, {s['waiting_dem_s']:.1f} s waiting"),
        ("CFD half", lambda: f"{s['cfd_s'] + (s['mapping_s'] or 0):.1f} s solving and mapping, "
                             f"{s['waiting_cfd_s']:.1f} s waiting"),
        ("exchange", lambda: f"{100 * s['exchange_dem_s'] / wall:.1f} % of the DEM half's time, "
                             f"{100 * s['exchange_cfd_s'] / wall:.1f} % of the CFD half's"),
        ("waiting", lambda: f"{100 * s['waiting_dem_s'] / wall:.1f} % of the DEM half's time, "
                            f"{100 * s['waiting_cfd_s'] / wall:.1f} % of the CFD half's"),
        ("coupled / DEM", lambda: f"{s['coupled_over_dem']:.3f} times {against}"),
        ("overlap / d", lambda: f"{s['max_overlap_over_d']:.2e} at most"),
        ("momentum", lambda: f"{s['max_momentum_residual']:.1e} residual, "
                             f"volume {s['max_void_fraction_volume_error']:.1e}"),
        ("Reynolds", lambda: f"{s['reynolds_max']:.3g} at most, Courant {s['courant_max']:.3g}"),
        ("particles", lambda: f"{s['particles']:d}, lost {s['particles_lost']}"),
    ]
    shown = []
    for name, words in rows:
        with contextlib.suppress(TypeError):  # a half that was stopped has not told
            shown.append(f"  {name:<14}{words()}")
    return "\n".join(shown)


def finish(case, run, derived, alone=False, pictures=True, lacking=""):
    """All that follows a run, or is made of one that is not complete (lacking: why); gives the
    exit code of a run."""
    v = case.values
    alone_s = _alone(run) if alone else None
    s = summary(case, run, derived, alone_s, lacking)
    try:
        more = _draw(case, run, derived, pictures, torn=bool(lacking))
    except (CaseError, OSError) as e:
        print(f"{called('run')}: the run is {'not ' if lacking else ''}complete, its report is not: {program.said(e)}",
              file=sys.stderr)
        return 4
    print(table(s) + more)
    for warning in s["warnings"]:
        print(f"  warning: {warning}")
    shown = os.path.relpath(run.folder, os.getcwd())
    print(f"results in {shown if not shown.startswith('../..') else run.folder}")
    if lacking:
        print(f"not complete, {s['simulated_s']:.4g} s of {v['end']:.4g} s: {lacking}")
        return 1
    if s["particles_lost"]:
        print(f"{called('run')}: {s['particles_lost']} particles were lost", file=sys.stderr)
        return 3
    return 0


def _draw(case, run, derived, pictures, torn):
    """Series and pictures, of a torn run those that can be made; lines for the table."""
    v = case.values
    title, scale = heading.of(case, derived), v.get("time_scale", 1.0)
    settled = os.path.isfile(os.path.join(run.folder, "settling.csv"))
    rows = curve(run.folder, scale) if settled else []
    if run.cfd > 1:
        try:
            openfoam.run("reconstructPar", os.path.join(run.folder, "CFD"))
        except CaseError as e:
            if not torn:
                raise
            print(f"  warning: {e}")
    series.join_functions(os.path.join(run.folder, "CFD"))
    from cases.lib.output import paraview
    if glob.glob(os.path.join(glob.escape(run.folder), "DEM", "spheres.*.dump")):
        paraview.time_series(run.folder, v["dem_step"], torn)
    columns = None
    if os.path.isfile(os.path.join(run.folder, "solids.csv")):
        from cases.lib.output import profile
        columns = profile.joined(run.folder, {**v, **derived})
        profile.write(run.folder, columns)
    if not pictures or not settled:
        return ""
    import numpy as np
    arrays = {k: np.array([float(r[k]) for r in rows]) for k in rows[0]}
    if "tube_radius" in v:
        from cases.lib.output import pictures as draw
        draw.settling(run.folder, arrays, heading.days(case), title)
        draw.columns(run.folder, v, title, heading.days(case), torn=torn)
    if columns:
        from cases.lib.output import profile_pictures
        profile_pictures.space_time(run.folder, columns, arrays, title)
        profile_pictures.stresses(run.folder, columns, title)
    if v.get("velocity_to", 0) > v.get("velocity_from", 0) and v["bottom"] == "inlet":
        from cases.lib.run import beds
        return "".join(f"\n  {a:<14}{b}" for a, b in beds.finish(run.folder, {**v, **derived}, arrays, title))
    return ""
