# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The key of a run: a hash of all that decides its result.

That is its values and what follows from them, the files its folder is made of,
the code that makes it, and the programs and libraries that this project
builds. Of the packaged programs only OpenFOAM's folder or version goes in.
"""

import ast
import glob
import hashlib
import json
import os

from cases.lib.case import openfoam, places
from cases.lib.case.casefile import CASES, TOP
from cases.lib.case.errors import CaseError

_hashes = {}


def _file_hash(path):
    """Of a file's bytes; of a large one once a version."""
    try:
        s = os.stat(path)
    except OSError:
        raise CaseError(f"{path} is not there; {places.cure()}") from None
    stamp = (path, s.st_mtime_ns, s.st_size)
    if stamp not in _hashes:
        with open(path, "rb") as f:
            _hashes[stamp] = hashlib.sha256(f.read()).hexdigest()
    return _hashes[stamp]


def _modules(name, found):
    """The modules of this project that `name` imports, with itself. What
    casefile and openfoam make is in the key by its values."""
    path = os.path.join(TOP, *name.split(".")) + ".py"
    if name in found or name.rpartition(".")[2] in ("casefile", "openfoam") or not os.path.isfile(path):
        return
    with open(path, encoding="utf-8") as f:
        tree = ast.parse(f.read())
    found[name] = ast.dump(tree)  # without comments
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                _modules(alias.name, found)
        elif isinstance(node, ast.ImportFrom) and not node.level:
            for alias in node.names:  # a module of a package, or what a module holds
                _modules(f"{node.module}.{alias.name}", found)
            _modules(node.module, found)


def programs():
    """Hashes of the programs and libraries that this project builds."""
    programs, libraries = places.programs()
    files = [os.path.join(programs, p) for p in ("liggghts-clay", "clayFoam")]
    files += sorted(glob.glob(os.path.join(glob.escape(libraries), "libclay*.so")))
    return {os.path.basename(p): _file_hash(p) for p in files}


def inputs(case):
    """Hashes of the files a run folder is made of, and the code that makes it."""
    found = {}
    for source in (os.path.join(CASES, "common"), *case.folders):
        for folder, _, files in os.walk(source):
            for f in files:
                path = os.path.join(folder, f)
                if f not in ("case.json", "check.py") and not f.startswith("README"):
                    found[os.path.relpath(path, source)] = _file_hash(path)
    code = {}
    _modules("cases.lib.run.prepare", code)
    return {"files": found, "code": hashlib.sha256(repr(sorted(code.items())).encode()).hexdigest()}


def key(case, derived):
    """The key of a case with its values, derived ones too."""
    decides = {"case": case.values, "derived": derived, "inputs": inputs(case), "programs": programs(),
               "openfoam": os.environ.get("WM_PROJECT_VERSION") or openfoam.environment()}
    return hashlib.sha256(json.dumps(decides, sort_keys=True).encode()).hexdigest()[:20]
