# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The wire's decoders under libFuzzer: any bytes as any message."""

import os
import re
import shutil

from cases.lib.case.casefile import TOP

_DONE = re.compile(r"stat::number_of_executed_units: +(\d+)")


def build(where, execute):
    """Builds the program by execute(words, seconds); its path, or "" and why where clang or libFuzzer are missing."""
    if not any(map(shutil.which, ("clang++", "clang++-14"))):
        return "", "clang++ is not installed"
    words = ["cmake", "-S", TOP, "-B", where, "-DCLAYFOAM_DEM_HALF=OFF", "-DCLAYFOAM_CFD_HALF=OFF",
             "-DCLAYFOAM_TESTS=ON", "-DCLAYFOAM_FUZZ=ON"]
    for step in (words, ["cmake", "--build", where, "--target", "fuzz_decode_program"]):
        done = execute(step, 600)
        if done.status != 0:
            return "", done.output.strip()[-200:]
    return os.path.join(where, "bin", "fuzz_decode"), ""


def attempt(program, seconds, folder, execute):
    """Feeds it for so long; (messages it was fed, what was wrong or "")."""
    corpus = os.path.join(folder, "corpus")
    os.makedirs(corpus, exist_ok=True)
    done = execute([program, corpus, f"-max_total_time={seconds}", "-max_len=4096", "-print_final_stats=1",
                    f"-artifact_prefix={folder}/"], 60 + 2 * seconds)
    count = _DONE.search(done.output)
    return int(count.group(1)) if count else 0, "" if done.status == 0 and count else said(done.output)


def said(output):
    """The line of libFuzzer's or a sanitizer's words that tells most."""
    lines = [x for x in output.splitlines() if "ERROR" in x or "runtime error" in x or "Test unit written" in x]
    return "; ".join(x.strip() for x in lines[:3]) or output.strip()[-200:]
