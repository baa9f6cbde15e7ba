# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a run folder: the case's files, the parameters, the mesh."""

import hashlib
import os
import re
import shutil

from cases.lib.case import cache, files, meshes, openfoam
from cases.lib.case.casefile import CASES, text
from cases.lib.packing import packing
from cases.lib.run import folders


def fill(out, case, derived):
    """Fills a run folder that was claimed."""
    folders.write_mark(out, case, (derived["dem_ranks"], derived["cfd_ranks"]))
    os.makedirs(os.path.join(out, "DEM"), exist_ok=True)
    # shared files first, so that a case's own take their place
    for source in (os.path.join(CASES, "common"), *case.folders):
        with files.naming(out):
            shutil.copytree(source, out, dirs_exist_ok=True,
                            ignore=shutil.ignore_patterns("case.json", "README*", "check.py"))
    parameters(out, {**case.values, **derived})
    if "packing" in case.values:
        packing.write(out, {**case.values, **derived})
    _mesh(os.path.join(out, "CFD"), case, derived)


def scripts(out):
    """The text of the DEM half's scripts in a folder, by name."""
    found = {}
    for name in os.listdir(out):
        if name.endswith(".liggghts"):
            with open(os.path.join(out, name), encoding="utf-8", errors="replace") as f:
                found[name] = f.read()
    return found


def parameters(out, values):
    """Hands every value to both halves, to each in its own words."""
    head = "This file is made by clayFoam from case.json"
    with files.writing(os.path.join(out, "parameters.liggghts")) as f:
        f.write(f"# {head}\n")
        f.writelines(f'variable {k} string "{text(v)}"\n' for k, v in values.items())
    with files.writing(os.path.join(out, "CFD", "system", "parameters")) as f:
        f.write(f"// {head}\n\nparameters\n{{\n")
        f.writelines(f"    {k:<15} {text(v)};\n" for k, v in values.items())
        f.write("}\n")


def _included(path, seen):
    """The text of one of OpenFOAM's files and of those it includes, each once."""
    path = os.path.normpath(path)
    if path in seen or not os.path.isfile(path):
        return ""
    seen.add(path)
    with open(path, encoding="utf-8", errors="replace") as f:
        found = f.read()
    for name in re.findall(r'^\s*#include\w*\s+"([^"]+)"', found, re.M):
        found += _included(os.path.join(os.path.dirname(path), name), seen)
    return found


def _mesh(cfd, case, derived):
    """The mesh, from the store if this one was made before, cut up if need be."""
    dictionary = _included(os.path.join(cfd, "system", "blockMeshDict"), {os.path.join(cfd, "system", "parameters")})
    values = {**case.values, **derived}
    used = {k: text(values[k]) for k in sorted(values) if re.search(r"parameters\." + k + r"\b", dictionary)}
    kind = values.get("mesh", "hex")
    if kind != "hex":
        used["mesh"] = f"{kind} {values['seed']}"
    with open(meshes.__file__, encoding="utf-8") as f:
        maker = f.read() if kind != "hex" else ""
    version = os.environ.get("WM_PROJECT_VERSION", "packaged")
    key = hashlib.sha256(f"{dictionary}{used}{version}{maker}with sums".encode()).hexdigest()[:16]

    def make(part):
        openfoam.run("blockMesh", cfd)
        meshes.change(kind, cfd, values)
        for name in os.listdir(mesh):
            shutil.move(os.path.join(mesh, name), part)

    mesh = os.path.join(cfd, "constant", "polyMesh")
    cache.fill("meshes", key, mesh, make)
    if derived["cfd_ranks"] > 1:
        openfoam.run("decomposePar", cfd)
    # what ParaView opens
    with open(os.path.join(cfd, case.name + ".foam"), "w", encoding="utf-8"):
        pass
