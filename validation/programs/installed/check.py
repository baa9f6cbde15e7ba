# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cmake --install into a prefix that is then moved: a run by clay, and programs built on its libraries."""

import json
import os
import re
import shutil
import subprocess
import tempfile

from cases.lib.case.casefile import TOP
from validation.lib.checks import coupled

TITLE = "what cmake --install puts in place: moved, it runs a case and is linked by other programs"
_CASE = {"title": "a dozen clumps", "like": "clump-half", "set": {"clumps": 12, "end": 0.02}}
_OWN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "own-program")


def _run_paths(path):
    """The RUNPATH of a program or library, its folders."""
    said = subprocess.run(["readelf", "-d", path], capture_output=True, text=True, check=True).stdout
    found = re.search(r"RUNPATH.*\[(.*)\]", said)
    return found.group(1).split(":") if found else []


def _naming(folder, words):
    """Files that hold one of these words."""
    found = []
    for at, _, names in os.walk(folder):
        for name in names:
            with open(os.path.join(at, name), "rb") as f:
                content = f.read()
            found += [os.path.relpath(os.path.join(at, name), folder)] if any(w in content for w in words) else []
    return found


def _a_run(checks, prefix, place):
    """A case of one's own, from a folder of one's own, by the clay of the prefix."""
    os.makedirs(os.path.join(place, "my-case"))
    with open(os.path.join(place, "my-case", "case.json"), "w", encoding="utf-8") as f:
        json.dump(_CASE, f)
    clay = os.path.join(prefix, "bin", "clay")
    # what is in the project must not be found instead
    env = {**os.environ, "PATH": "/usr/bin:/bin", "XDG_CACHE_HOME": os.path.join(place, "cache")}
    done = subprocess.run([clay, "run", "./my-case", "--json", "--no-pictures"], cwd=place, env=env, text=True,
                          capture_output=True, check=False, timeout=300)
    checks.equal("a run of ./my-case: exit code", done.returncode, 0)
    if done.returncode:
        checks.note(done.stderr.strip()[-300:])
        return
    said = json.loads(done.stdout)
    checks.true("a run of ./my-case: complete", said["complete"] and said["clumps"] == 12, said.get("reason", ""))
    results = os.path.join(place, "results", "my-case")
    checks.true("results where one stands", os.path.isfile(os.path.join(results, "settling.csv")))
    with open(os.path.join(results, "run.sh"), encoding="utf-8") as f:
        checks.true("the programs are those of the moved prefix", f"PATH={prefix}/bin:" in f.read())
    # the run may be called by a link, as from a folder of the PATH
    os.symlink(clay, os.path.join(place, "clay"))
    done = subprocess.run([os.path.join(place, "clay"), "report", "results/my-case", "--quiet"], cwd=place, env=env,
                          text=True, capture_output=True, check=False, timeout=300)
    checks.equal("clay report, by a link", [done.returncode, done.stdout, done.stderr], [0, "", ""])


def _own_programs(checks, prefix, place):
    """A DEM program and a drag law's on the libraries of the prefix, found by CMake."""
    build = os.path.join(place, "own")
    outcome = coupled.execute(["cmake", "-S", _OWN, "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}",
                               f"-DOpenFOAM_HEADERS_DIR={TOP}/build/openfoam"], 120)
    if outcome.status == 0:
        outcome = coupled.execute(["cmake", "--build", build], 300)
    checks.true("programs of one's own: found by CMake, and built", outcome.status == 0,
                outcome.output[-200:] if outcome.status else "")
    if outcome.status:
        return
    env = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    outcome = coupled.execute([os.path.join(build, "own_liggghts"), "-in", os.path.join(_OWN, "in.liggghts"), "-log",
                               "none"], 60, cwd=build, env=env)
    checks.true("LIGGGHTS of one's own has this project's styles",
                outcome.status == 0 and "\nthe style is there" in outcome.output)
    note = coupled.execute(["sh", "-c", "dpkg -L openfoam 2> /dev/null | sed -n 's,/etc/controlDict$,,p'"], 60)
    foam = os.environ.get("WM_PROJECT_DIR") or note.output.strip()
    outcome = coupled.execute([os.path.join(build, "own_drag")], 60, cwd=build, env={**env, "WM_PROJECT_DIR": foam})
    found = re.search(r"^coefficient ([\d.e+]+)", outcome.output, re.M)
    checks.close("18 mu/d^2 by the drag law of the library [kg/(m3 s)]", float(found.group(1)) if found else 0.0,
                 18000.0, 1e-9)


def run(checks):
    with tempfile.TemporaryDirectory() as place:
        place = os.path.realpath(place)
        first, prefix = os.path.join(place, "first"), os.path.join(place, "moved")
        outcome = coupled.execute(["cmake", "--install", os.path.join(TOP, "build"), "--prefix", first], 120)
        if not checks.true("cmake --install", outcome.status == 0, outcome.output[-200:] if outcome.status else ""):
            return
        shutil.move(first, prefix)
        checks.equal("files that name the folder of the build, or the first prefix",
                     _naming(prefix, [TOP.encode(), first.encode()]), [])
        for name in ("bin/clayFoam", "bin/liggghts-clay", "lib/libclayCoupling.so"):
            path = os.path.join(prefix, name)
            mine = [p for p in _run_paths(path) if p.startswith((TOP, place))]
            checks.equal(f"{name}: folders of the build in its RUNPATH", mine, [])
            said = subprocess.run(["ldd", path], capture_output=True, text=True, check=False).stdout
            wrong = [x.strip() for x in said.splitlines() if "not found" in x or TOP + os.sep in x]
            checks.equal(f"{name}: libraries that are not found, or the project's", wrong, [])
        _a_run(checks, prefix, place)
        _own_programs(checks, prefix, place)
