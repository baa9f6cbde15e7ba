# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cmake/FindOpenFOAM.cmake and FindLIGGGHTS.cmake: what they take and what they refuse, with trees of empty files."""

import os
import shutil
import re
import subprocess

import pytest

from cases.lib.case.casefile import TOP

_ASK = """cmake_minimum_required(VERSION 3.22)
project(ask LANGUAGES NONE)
list(APPEND CMAKE_MODULE_PATH ${MODULES})
find_package(${HOST} REQUIRED)
if(TARGET OpenFOAM::finiteVolume)
  get_target_property(definitions OpenFOAM::finiteVolume INTERFACE_COMPILE_DEFINITIONS)
  get_target_property(include OpenFOAM::finiteVolume INTERFACE_INCLUDE_DIRECTORIES)
  message(STATUS "has ${definitions} ${include} ${OpenFOAM_Pstream_LIBRARY}")
endif()
message(STATUS "found ${OpenFOAM_VERSION}${LIGGGHTS_INCLUDE_DIR}")
"""
_LIBRARIES = ("OpenFOAM", "finiteVolume", "meshTools", "incompressibleTransportModels", "turbulenceModels",
              "incompressibleTurbulenceModels", "fvOptions")
_CURE = ": source openfoam.com's v1912 to v2512, with its headers and in double precision, or build in a new shell " \
    "without OpenFOAM's environment for Debian's package"


class Machine:
    """A sourced OpenFOAM without contents; a Debian package beside it."""

    def __init__(self, top):
        self.top, self.foam, self.packaged = top, top / "foam", top / "packaged"
        libraries = self.foam / "lib"
        for folder in (top / "project" / "cmake", libraries / "sys-mpi", self.foam / "META-INFO",
                       self.foam / "src" / "OpenFOAM" / "lnInclude", top / "bin", top / "liggghts"):
            folder.mkdir(parents=True)
        (top / "project" / "CMakeLists.txt").write_text(_ASK)
        for name in _LIBRARIES:
            (libraries / f"lib{name}.so").write_text("")
        (libraries / "sys-mpi" / "libPstream.so").write_text("")
        for name in ("FindLIGGGHTS.cmake", "FindOpenFOAM.cmake"):
            shutil.copy(os.path.join(TOP, "cmake", name), top / "project" / "cmake")
        self.program("bin/dpkg", f"echo {self.packaged}/etc/controlDict")
        self.program("project/cmake/openfoam-headers.sh", 'mkdir -p "$1/src" && printf 1912.200626-1 > "$1/version"')
        self.env = {k: v for k, v in os.environ.items() if not k.startswith(("WM_", "FOAM_"))}
        self.env["PATH"] = f"{top / 'bin'}:{self.env['PATH']}"
        self.source("v2312")

    def program(self, name, text):
        (self.top / name).write_text(f"#!/bin/sh\n{text}\n")
        (self.top / name).chmod(0o755)

    def source(self, version, api=True, **more):
        """Sources the environment; a variable that is None is not set."""
        self.env.update(WM_PROJECT_DIR=str(self.foam), WM_PROJECT_VERSION=version, WM_LABEL_SIZE="32",
                        WM_PRECISION_OPTION="DP", FOAM_LIBBIN=str(self.foam / "lib"), FOAM_MPI="sys-mpi")
        self.env.update({k: v for k, v in more.items() if v is not None})
        for name in (k for k, v in more.items() if v is None):
            self.env.pop(name)
        info = self.foam / "META-INFO" / "api-info"
        info.unlink(missing_ok=True)
        if api:
            info.write_text(f"api={version[1:]}\npatch=0\n")

    def configure(self, host="OpenFOAM", *words):
        """Whether it was found, and all that CMake said."""
        done = subprocess.run(["cmake", "-S", self.top / "project", "-B", self.top / "build",
                               f"-DMODULES={self.top}/project/cmake", f"-DHOST={host}", *words],
                              env=self.env, text=True, capture_output=True, check=False)
        return done.returncode == 0, done.stdout + done.stderr

    def refusal(self, *words):
        """The line that CMake says of its error."""
        found, said = self.configure(*words)
        assert not found, said
        match = re.search(r"CMake Error at .*\n(?: .*\(\w*\).*\n)*\s*\n?  ?(.*)\n", said)
        assert match, said
        return match.group(1).strip()


@pytest.fixture
def machine(tmp_path):
    return Machine(tmp_path)


@pytest.mark.parametrize("version", ["v1912", "v2006", "v2312", "v2406", "v2506", "v2512"])
def test_sourced_versions_are_taken(machine, version):
    machine.source(version)
    found, said = machine.configure()
    assert found, said
    assert f"found {version}\n" in said
    assert f"OPENFOAM={version[1:]};WM_DP;WM_LABEL_SIZE=32;" in said
    assert f"{machine.foam}/src/OpenFOAM/lnInclude" in said and f"{machine.foam}/lib/sys-mpi/libPstream.so" in said


def test_the_version_is_that_of_the_tree(machine):
    machine.source("v2406")
    machine.env["WM_PROJECT_VERSION"] = "com"
    assert "found v2406\n" in machine.configure()[1]
    machine.source("v2206", api=False)
    assert "OPENFOAM=2206;" in machine.configure()[1]


def test_labels_of_64_bits(machine):
    machine.source("v2312", WM_LABEL_SIZE="64")
    assert "WM_LABEL_SIZE=64;" in machine.configure()[1]
    machine.source("v2312", WM_LABEL_SIZE="16")
    assert machine.refusal() == "OpenFOAM: WM_LABEL_SIZE is 16; it must be 32 or 64" + _CURE


@pytest.mark.parametrize("precision", ["SP", "SPDP"])
def test_single_precision_is_refused(machine, precision):
    machine.source("v2312", WM_PRECISION_OPTION=precision)
    assert machine.refusal() == f"OpenFOAM: WM_PRECISION_OPTION is {precision}; it must be DP" + _CURE


@pytest.mark.parametrize("version", ["7", "11", "13", "2.4.x", "dev"])
def test_the_foundations_versions_are_named(machine, version):
    machine.source(version, api=False)
    assert machine.refusal() == (f"OpenFOAM: WM_PROJECT_VERSION is {version}, of the OpenFOAM Foundation, "
                                 "which is not supported" + _CURE)


@pytest.mark.parametrize("version", ["v1906", "v2606"])
def test_versions_outside_the_range_are_refused(machine, version):
    machine.source(version)
    assert machine.refusal() == (f"OpenFOAM: {machine.foam}/META-INFO/api-info says api={version[1:]}, "
                                 "which is not supported" + _CURE)
    machine.source(version, api=False)
    assert machine.refusal() == f"OpenFOAM: WM_PROJECT_VERSION is '{version}', which is not supported" + _CURE


def test_an_environment_without_a_version_is_refused(machine):
    machine.source("v2312", api=False, WM_PROJECT_VERSION=None)
    assert machine.refusal() == "OpenFOAM: WM_PROJECT_VERSION is '', which is not supported" + _CURE


def test_an_environment_without_headers_is_refused(machine):
    (machine.foam / "src" / "OpenFOAM" / "lnInclude").rmdir()
    assert machine.refusal() == (f"OpenFOAM: WM_PROJECT_DIR is {machine.foam}, which holds no headers "
                                 "(src/OpenFOAM/lnInclude)" + _CURE)


def test_an_environment_without_libraries_is_refused(machine):
    (machine.foam / "lib" / "libmeshTools.so").unlink()
    found, said = machine.configure()
    assert not found
    said = " ".join(said.split())
    assert "(missing: OpenFOAM_meshTools_LIBRARY)" in said
    assert f"FOAM_LIBBIN is '{machine.foam}/lib' and FOAM_MPI 'sys-mpi': compile the sourced OpenFOAM" in said


@pytest.mark.parametrize("slash", ["", "/"])
def test_the_package_s_own_folder_is_no_sourced_environment(machine, slash):
    machine.source("1912", WM_PROJECT_DIR=f"{machine.packaged}{slash}", api=False)
    said = machine.configure(*["OpenFOAM", *(f"-DOpenFOAM_{n}_LIBRARY=/{n}" for n in (*_LIBRARIES, "Pstream"))])[1]
    assert "found 1912.200626-1\n" in said
    assert f'WM_LABEL_SIZE=32;NoRepository;CLAYFOAM_OPENFOAM_DIR="{machine.packaged}"' in said


def test_a_package_outside_the_range_is_refused(machine):
    machine.program("project/cmake/openfoam-headers.sh", 'mkdir -p "$1/src" && printf 1906.1-1 > "$1/version"')
    machine.env.pop("WM_PROJECT_DIR")
    assert machine.refusal() == "OpenFOAM: the package openfoam is of version 1906.1-1" + _CURE


def test_liggghts_pfm_is_named(machine):
    words = ("LIGGGHTS", f"-DLIGGGHTS_INCLUDE_DIR={machine.top}/liggghts", "-DLIGGGHTS_LIBRARY=/libliggghts.so.3.8.0")
    header = machine.top / "liggghts" / "multisphere.h"
    for text in (None, "void check_lost_atoms(int *body);\n"):
        if text:
            header.write_text(text)
        assert machine.refusal(*words) == (
            f"LIGGGHTS: LIGGGHTS_INCLUDE_DIR is {machine.top}/liggghts, whose clumps have no volume weights, "
            "as in LIGGGHTS-PFM, which is not supported: give LIGGGHTS_INCLUDE_DIR and LIGGGHTS_LIBRARY of "
            "LIGGGHTS-PUBLIC 3.8, or install the packages liggghts and libliggghts-dev")
    header.write_text("void check_lost_atoms(int *body, double *volumeweight);\n")
    found, said = machine.configure(*words)
    assert found and f"found {machine.top}/liggghts\n" in said
