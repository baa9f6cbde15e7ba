# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""clang-tidy over every source that the build compiles.

The compiler is GCC: what clang alone takes for an error, in OpenFOAM's headers or where
GCC's own functions are called, is left out."""

import concurrent.futures
import json
import os
import tempfile

from cases.lib.run import launch
from validation.lib.checks import linters
from validation.lib.checks.coupled import TOP
from validation.lib.checks.verdicts import Broken

TITLE = "clang-tidy with the checks of .clang-tidy, over all sources"
LONG = True
_WORDS = ["clang-tidy", "--quiet", "--extra-arg=-ferror-limit=0", f"--config-file={os.path.join(TOP, '.clang-tidy')}"]


def run(checks):
    why = linters.missing(["clang-tidy", "--version"])
    if why:
        checks.skipped("clang-tidy", why)
        return
    build = os.path.join(TOP, "build")
    try:
        with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as f:
            sources = sorted({os.path.relpath(entry["file"], TOP) for entry in json.load(f)})
    except OSError as e:
        raise Broken(f"no list of what the build compiles: {e}") from None

    def look(source):
        return linters.in_project(linters.complaints([*_WORDS, "-p", build], [source]))

    with tempfile.TemporaryDirectory(dir=os.path.join(TOP, "build")) as folder:
        fault = os.path.join(folder, "fault.cpp")
        with open(fault, "w", encoding="utf-8") as f:
            f.write("int half(int n) { return n ? n : n; }\n")
        checks.true("a fault that is put there is found", linters.complaints(_WORDS, [fault, "--"]))

    with concurrent.futures.ThreadPoolExecutor(launch.cores()) as pool:
        for part in ("exchange", "liggghts-fix", "foam-coupling"):
            ours = [s for s in sources if s.startswith(part + "/")]
            found = [line for said in pool.map(look, ours) for line in said]
            if not ours:
                found = ["there are no files to look at"]
            checks.true(f"clang-tidy: {part}, {len(ours)} files", not found, linters.told(found))
