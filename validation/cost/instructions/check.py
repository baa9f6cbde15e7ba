# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Instructions of the kernels, as callgrind counts them, against a stored baseline."""

import csv
import os
import re
import shutil

from validation.lib.checks import coupled
from validation.lib.checks.verdicts import Broken

TITLE = "instruction counts of the kernels (callgrind)"
HERE = os.path.dirname(os.path.abspath(__file__))
GROWTH = 0.05
# kernel: program, its arguments, the function that is counted with all it calls
KERNELS = {
    "contact": ("kernel_counts", ["contact"], "clay::contactForces*"),
    "contact_hertz": ("kernel_counts", ["contact_hertz"], "clay::contactForces*"),
    "contact_rolling": ("kernel_counts", ["contact_rolling"], "clay::contactForces*"),
    "coulomb": ("kernel_counts", ["coulomb"], "clay::ChargeGroups::act*"),
    "coulomb_single": ("kernel_counts", ["coulomb_single"], "clay::ChargeGroups::act*"),
    "screened": ("kernel_counts", ["screened"], "clay::ChargeGroups::act*"),
    "screened_single": ("kernel_counts", ["screened_single"], "clay::ChargeGroups::act*"),
    "dlvo": ("kernel_counts", ["dlvo"], "clay::ChargeGroups::act*"),
    "dlvo_far": ("kernel_counts", ["dlvo_far"], "clay::ChargeGroups::act*"),
    "overlap": ("mappingCost", ["--gtest_filter=mappingCost.onePass"],
                "Foam::voidFractionModels::exactOverlap::weights*"),
    "divided": ("mappingCost", ["--gtest_filter=mappingCost.onePassDivided"],
                "Foam::voidFractionModels::divided::weights*"),
    "unpack": ("kernel_counts", ["packing"], "clay::unpackFields*"),
    "pack": ("kernel_counts", ["packing"], "clay::packAnswers*"),
}


def count(program, arguments, function):
    path = os.path.join(coupled.TOP, "build", "bin", program)
    folder = os.path.join(coupled.RUNS, "instructions")
    os.makedirs(folder, exist_ok=True)
    outcome = coupled.execute(
        ["valgrind", "--tool=callgrind", "--trace-children=yes", "--collect-atstart=no",
         f"--toggle-collect={function}",
         f"--callgrind-out-file={os.path.join(folder, program)}.%p", path, *arguments], 300)
    # a kernel that had nothing to do counts for nothing
    if outcome.status != 0:
        raise Broken(f"{program} {' '.join(arguments)} ended with {outcome.status}: "
                     f"{outcome.output.strip().splitlines()[-1:]}")
    found = re.search(r"Collected : (\d+)", outcome.output)
    if not found or int(found.group(1)) == 0:
        raise Broken(f"callgrind counted nothing in {function} of {program}: "
                     f"{outcome.output.strip().splitlines()[-1:]}")
    return int(found.group(1))


def run(checks):
    if not shutil.which("valgrind"):
        raise Broken("valgrind is not installed")
    with open(os.path.join(HERE, "baseline.csv"), encoding="utf-8") as file:
        baseline = {row["kernel"]: int(row["instructions"])
                    for row in csv.DictReader(line for line in file if not line.startswith("#"))}
    for kernel, arguments in KERNELS.items():
        now = count(*arguments)
        checks.at_most(f"{kernel}: instructions over the baseline's {baseline[kernel]}",
                       now / baseline[kernel], 1 + GROWTH)
