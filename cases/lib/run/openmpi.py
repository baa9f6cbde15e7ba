# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What mpirun is told and what it says, in Open MPI 4 and 5."""

import re

# of --tag-output: a rank's number, the stream (out, err), the line
TAG = re.compile(r"^\[(?:[^\]@]*@)?\d+,(\d+)\]<std(out|err)>:\s?(.*)$", re.S)
# mpirun itself of a program that was ended: 5 calls itself prterun, and breaks the line
NOTICED = re.compile(r"^(?:mpirun|mpiexec|orterun|prterun) noticed that ", re.M)

CROWDED = ("--map-by", ":OVERSUBSCRIBE")  # words of mpirun for more ranks than cores
YIELD = {"OMPI_MCA_mpi_yield_when_idle": "1"}  # ranks that wait give their core away


def crowded():
    """The environment of more ranks than cores; 5 reads the second, also where the words are not given."""
    return {**YIELD, "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe"}


def noticed(lines):
    """What mpirun says of a program that was ended, as one line; "" when it says nothing."""
    rest = iter(lines)
    for line in rest:
        if NOTICED.match(line):
            said = line.strip()
            while not said.endswith("."):
                more = next(rest, "--").strip()
                if not more or more.startswith("--"):
                    break
                said += " " + more
            return said
    return ""
