# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The Debian package names what it needs: what set-up installs to run cases, by what cmake/package.cmake depends on."""

import os
import re
import subprocess

import pytest

from cases.lib.case.casefile import TOP


def read(*path):
    with open(os.path.join(TOP, *path), encoding="utf-8") as f:
        return f.read()


def test_what_a_run_needs_is_what_the_package_needs():
    setup = re.search(r"^packages=\((.*?)\)", read("cmake", "setup.sh"), re.M | re.S).group(1).split()
    building = {"cmake", "g++", "make", "libliggghts-dev", "libopenmpi-dev", "libeigen3-dev", "zlib1g-dev",
                "nlohmann-json3-dev", "librandom123-dev"}
    # the DEM half links LIGGGHTS's library, which the package finds by itself
    wanted = set(setup) - building - {"liggghts"}
    said = re.search(r'PROGRAMS_PACKAGE_DEPENDS "(.*?)"\)', read("cmake", "package.cmake"), re.S).group(1)
    named = {re.sub(r"\(.*", "", w).strip() for w in said.replace("\\\n", "").split(",")}
    assert wanted | {"openfoam", "libopenfoam"} <= named


@pytest.mark.long
def test_the_packages(tmp_path):
    if not os.path.isfile(os.path.join(TOP, "build", "CPackConfig.cmake")):
        pytest.skip("the build has no packages: it is of a sourced OpenFOAM, or of one half")
    subprocess.run(["cpack", "--config", os.path.join(TOP, "build", "CPackConfig.cmake"), "-B", str(tmp_path)],
                   cwd=os.path.join(TOP, "build"), check=True, capture_output=True)
    found = {re.match(r"[a-z-]+", n).group(): str(tmp_path / n) for n in os.listdir(tmp_path) if n.endswith(".deb")}
    assert set(found) == {"clayfoam", "clayfoam-dev"}

    def field(name, package):
        return subprocess.run(["dpkg", "-f", found[package], name], check=True, text=True,
                              capture_output=True).stdout.strip()
    needs = field("Depends", "clayfoam")
    for name in ("libliggghts3", "libopenmpi3", "libopenfoam (>=", "openfoam", "openmpi-bin", "python3-numpy",
                 "python3-matplotlib"):
        assert name in needs
    assert "clayfoam (= " + field("Version", "clayfoam") in field("Depends", "clayfoam-dev")
    for package, path in found.items():
        subprocess.run(["dpkg", "-x", path, str(tmp_path / package)], check=True)
    usr = tmp_path / "clayfoam" / "usr"
    for program in ("clayFoam", "liggghts-clay"):
        said = subprocess.run(["ldd", str(usr / "bin" / program)], check=True, text=True, capture_output=True).stdout
        assert "not found" not in said and TOP + os.sep not in said
    said = subprocess.run([str(usr / "bin" / "clay"), "run", "--list"], check=True, text=True, capture_output=True)
    assert "clump-half" in said.stdout
    assert (tmp_path / "clayfoam-dev" / "usr" / "include" / "clayfoam" / "exchange" / "session.h").is_file()
