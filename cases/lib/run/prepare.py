# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a run folder: the case's files, the parameters, the mesh."""

import glob
import hashlib
import os
import re
import shutil

from cases.lib.case import meshes, openfoam
from cases.lib.case.casefile import CASES, TOP, text
from cases.lib.case.errors import CaseError
from cases.lib.packing import packing

# what a run leaves behind; removed when its folder is used again
_REMAINS = ("DEM", "CFD", "alone", "dem.json", "summary.json", "settling.csv", "stages.json", "*.png",
            "pressure_drop.csv", "bed.json",
            "*.liggghts", "packing.*", "packmol", "log.liggghts", "run.sh", "DEM.pvd",
            "restart_forced_liggghts_*.data")  # LIGGGHTS's, when it is interrupted
_MARK = "case.txt"
# what OpenFOAM does not take in the name of a folder
_UNFIT = re.compile(r"[\s\"'`;{}$()]")


def _fit(path, what, remedy):
    """Refuses a path that OpenFOAM would break in two."""
    unfit = _UNFIT.search(path)
    if unfit:
        raise CaseError(f"{what} {path!r}: OpenFOAM takes no {unfit.group()!r} in a path; {remedy}")


def run_folder(case, out, derived):
    """Fills the run folder anew and returns it."""
    _fit(TOP, "the project's folder", "move the project")
    out = os.path.abspath(out or os.path.join(TOP, "results", case.name))
    _fit(out, "--out", "name another folder")
    if os.path.exists(out) and not os.path.isdir(out):
        raise CaseError(f"--out {out}: is a file; name a folder")
    if os.path.isdir(out) and os.listdir(out) and not os.path.isfile(os.path.join(out, _MARK)):
        raise CaseError(f"--out {out}: holds other things than a run; name a new folder")
    for pattern in _REMAINS:
        for old in glob.glob(os.path.join(glob.escape(out), pattern)):
            shutil.rmtree(old) if os.path.isdir(old) else os.remove(old)
    os.makedirs(os.path.join(out, "DEM"), exist_ok=True)
    with open(os.path.join(out, _MARK), "w", encoding="utf-8") as f:
        f.write(f"{case.name}: {case.title}\n\n{case.table()}\n")

    # shared files first, so that a case's own take their place
    for source in (os.path.join(CASES, "common"), *case.folders):
        shutil.copytree(source, out, dirs_exist_ok=True,
                        ignore=shutil.ignore_patterns("case.json", "README*", "check.py"))
    _parameters(out, {**case.values, **derived})
    if "packing" in case.values:
        packing.write(out, {**case.values, **derived})
    _mesh(os.path.join(out, "CFD"), case, derived)
    return out


def _parameters(out, values):
    """Hands every value to both halves, to each in its own words."""
    head = "This file is made by cases/run from case.json"
    with open(os.path.join(out, "parameters.liggghts"), "w", encoding="utf-8") as f:
        f.write(f"# {head}\n")
        f.writelines(f'variable {k} string "{text(v)}"\n' for k, v in values.items())
    with open(os.path.join(out, "CFD", "system", "parameters"), "w", encoding="utf-8") as f:
        f.write(f"// {head}\n\nparameters\n{{\n")
        f.writelines(f"    {k:<15} {text(v)};\n" for k, v in values.items())
        f.write("}\n")


def _mesh(cfd, case, derived):
    """The mesh, from the store if this one was made before, cut up if need be."""
    with open(os.path.join(cfd, "system", "blockMeshDict"), encoding="utf-8") as f:
        dictionary = f.read()
    values = {**case.values, **derived}
    used = {k: text(values[k]) for k in sorted(values) if re.search(r"parameters\." + k + r"\b", dictionary)}
    kind = values.get("mesh", "hex")
    if kind != "hex":
        used["mesh"] = f"{kind} {values['seed']}"
    version = os.environ.get("WM_PROJECT_VERSION", "packaged")
    key = hashlib.sha256(f"{dictionary}{used}{version}".encode()).hexdigest()[:16]
    store = os.path.join(TOP, "build", "meshes", key)
    target = os.path.join(cfd, "constant", "polyMesh")
    if not os.path.isfile(os.path.join(store, "owner")):
        openfoam.run("blockMesh", cfd)
        meshes.change(kind, cfd, values)
        part = f"{store}.{os.getpid()}"
        shutil.copytree(target, part)
        try:
            os.replace(part, store)
        except OSError:  # another run was quicker
            shutil.rmtree(part)
    else:
        shutil.copytree(store, target)
    if derived["cfd_ranks"] > 1:
        openfoam.run("decomposePar", cfd)
    # what ParaView opens
    with open(os.path.join(cfd, case.name + ".foam"), "w", encoding="utf-8"):
        pass
