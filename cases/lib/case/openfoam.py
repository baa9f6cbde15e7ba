# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""OpenFOAM's environment and programs, and a small reader of its fields."""

import glob
import os
import re
import shutil
import subprocess

from cases.lib.case import files, stops
from cases.lib.case.errors import CaseError


def environment():
    """The variables OpenFOAM's programs need; a sourced environment is kept."""
    if os.environ.get("WM_PROJECT_DIR"):
        return {}
    for folder in sorted(glob.glob("/usr/share/openfoam*")):
        if os.path.isfile(os.path.join(folder, "etc", "controlDict")):
            return {"WM_PROJECT_DIR": folder}
    raise CaseError("OpenFOAM is not to be found: source its environment, "
                    "or install the packages openfoam and libopenfoam")


def run(program, case, *options):
    """Runs one of OpenFOAM's serial programs; its output goes to a log."""
    if not shutil.which(program):
        raise CaseError(f"OpenFOAM's {program} is not on the PATH")
    case = os.path.abspath(case)
    log = os.path.join(case, "log." + program)
    with files.naming(case), open(log, "w", encoding="utf-8") as f:
        status = subprocess.run([program, "-case", case, *options], stdout=f, check=False, cwd=case,
                                stderr=subprocess.STDOUT, env={**os.environ, **environment()},
                                preexec_fn=stops.die_with_parent()).returncode
    if status:
        raise CaseError(f"{program} failed: {error_line(log)} (log in {log})")


def error_line(log):
    """The line of a log that says what went wrong."""
    with open(log, encoding="utf-8", errors="replace") as f:
        lines = [line.strip() for line in f if line.strip()]
    for i, line in enumerate(lines):
        if "FOAM FATAL" in line:
            rest = [x for x in lines[i + 1:i + 4] if not x.startswith(("From function", "in file"))]
            return " ".join(rest) if rest else line
    return lines[-1] if lines else "it said nothing"


def times(case):
    """The output times of a case, as (seconds, folder), in order."""
    found = []
    for entry in os.listdir(case):
        if re.fullmatch(r"\d+(\.\d+)?(e-?\d+)?", entry):
            found.append((float(entry), os.path.join(case, entry)))
    return sorted(found)


def internal_field(path, count):
    """The internal field of a file: count rows of one or three numbers."""
    import numpy as np
    with open(path, "rb") as f:
        raw = f.read()
    if re.search(rb"^\s*format\s+binary;", raw[:2000], re.M):
        found = _binary(path, raw)
        if found is not None:
            return found
    content = raw.decode("utf-8", "replace")
    match = re.search(r"internalField\s+uniform\s+([^;]*);", content)
    if match:
        row = np.array([float(x) for x in match.group(1).strip("() ").split()])
        return np.tile(row, (count, 1))
    match = re.search(r"internalField\s+nonuniform\s+List<\w+>\s+(\d+)\s*\(", content)
    if not match:
        raise CaseError(f"{path}: no internal field")
    # a short list stands on one line
    end = re.compile(r"\)\s*;").search(content, match.end())
    body = content[match.end():end.start()].replace("(", " ").replace(")", " ").split() if end else []
    if not body or len(body) % int(match.group(1)):
        raise CaseError(f"{path}: is not whole")
    return np.array(body, dtype=float).reshape(int(match.group(1)), -1)


def _binary(path, raw):
    """The internal field of a binary file's bytes, as saved states are, (rows, numbers); None of a uniform one."""
    import numpy as np
    match = re.search(rb"internalField\s+nonuniform\s+List<(scalar|vector)>\s+(\d+)\s*\(", raw)
    if not match:
        return None
    rows, each = int(match.group(2)), {b"scalar": 1, b"vector": 3}[match.group(1)]
    body = raw[match.end():match.end() + 8 * rows * each]
    if len(body) != 8 * rows * each:
        raise CaseError(f"{path}: is not whole")
    return np.frombuffer(body, dtype="<f8").reshape(rows, each)


def cell_centres(mesh):
    """Centres of a mesh's cells (mean of their points), from polyMesh in ascii."""
    import numpy as np
    points = _list(os.path.join(mesh, "points")).reshape(-1, 3)
    owner = _list(os.path.join(mesh, "owner")).astype(int)
    neighbour = _list(os.path.join(mesh, "neighbour")).astype(int)
    with open(os.path.join(mesh, "faces"), encoding="utf-8") as f:
        faces = [[int(x) for x in m.split()] for m in re.findall(r"\d+\s*\(([\d\s]+)\)", f.read())]
    centre = np.array([points[face].mean(axis=0) for face in faces])
    cells = owner.max() + 1
    total, count = np.zeros((cells, 3)), np.zeros(cells)
    for label, face in ((owner, centre), (neighbour, centre[:len(neighbour)])):
        np.add.at(total, label, face)
        np.add.at(count, label, 1)
    return total / count[:, None]


def _list(path):
    """The numbers of a list file, without its header."""
    import numpy as np
    with open(path, encoding="utf-8") as f:
        content = f.read()
    content = content[content.index("}") + 1:]
    start = content.index("(")
    body = content[start + 1:content.rindex(")")].replace("(", " ").replace(")", " ")
    return np.array(body.split(), dtype=float)
