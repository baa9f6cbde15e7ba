# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cmake/setup.sh: what each way to call it asks for, and when it has nothing to do.
Stand-ins for cmake and dpkg-query note how they are called; a build takes minutes."""

import os
import shutil
import subprocess

import pytest

from cases.lib.case.casefile import TOP

_STAND_INS = {
    "cmake": """#!/bin/sh
echo "$@" >> "$NOTES/cmake"
mkdir -p build/bin && touch build/CMakeCache.txt
for p in liggghts-clay clayFoam; do echo > build/bin/$p && chmod +x build/bin/$p; done
""",
    "dpkg-query": '#!/bin/sh\nfor last; do :; done\necho "$last" >> "$NOTES/packages"\necho installed\n',
}


class Project:
    """A project folder with the set-up and no sources."""

    def __init__(self, top):
        self.top, self.notes = top / "project", top / "notes"
        for folder in ("cmake", "exchange", "liggghts-fix", "foam-coupling"):
            (self.top / folder).mkdir(parents=True)
        for name in ("CMakeLists.txt", "CMakePresets.json", "exchange/source.cpp"):
            (self.top / name).write_text("")
        shutil.copy(os.path.join(TOP, "cmake", "setup.sh"), self.top / "cmake")
        self.notes.mkdir()
        (top / "bin").mkdir()
        for name, text in _STAND_INS.items():
            (top / "bin" / name).write_text(text)
            (top / "bin" / name).chmod(0o755)
        self.env = {**os.environ, "PATH": f"{top / 'bin'}:{os.environ['PATH']}", "NOTES": str(self.notes)}
        self.env.pop("WM_PROJECT_DIR", None)

    def setup(self, *words):
        """What cmake and dpkg-query were called with, a line each; none when there was nothing to do."""
        for name in ("cmake", "packages"):
            (self.notes / name).write_text("")
        subprocess.run([self.top / "cmake" / "setup.sh", *words], env=self.env, check=True, capture_output=True)
        return [(self.notes / name).read_text().splitlines() for name in ("cmake", "packages")]


@pytest.fixture
def project(tmp_path):
    return Project(tmp_path)


def test_a_run_needs_programs_alone(project):
    (configure, build), packages = project.setup("--programs", "3")
    assert "-DCLAYFOAM_TESTS=OFF" in configure
    assert build.endswith("-j3 --target liggghts-clay clayFoam")
    assert "liggghts" in packages and "python3-numpy" in packages
    assert not {"libgtest-dev", "libbenchmark-dev", "valgrind", "python3-pytest", "python3-jinja2", "clang-format",
                "clang-tidy", "shellcheck", "python3-flake8"} & set(packages)


def test_checks_need_the_tests(project):
    (configure, build), packages = project.setup()
    assert "-DCLAYFOAM_TESTS=ON" in configure and "--target" not in build
    assert {"libgtest-dev", "valgrind", "python3-pytest", "clang-format", "shellcheck"} <= set(packages)


def test_tests_are_built_after_programs_and_not_the_other_way(project):
    assert project.setup("--programs")[0]
    assert project.setup("--programs") == [[], []]
    assert "-DCLAYFOAM_TESTS=ON" in project.setup()[0][0]
    assert project.setup() == [[], []]
    assert project.setup("--programs") == [[], []]


def test_a_newer_source_is_built(project):
    project.setup()
    stamp = (project.top / "build" / ".ready").stat().st_mtime
    os.utime(project.top / "exchange" / "source.cpp", (stamp + 5, stamp + 5))
    (configure, build), _ = project.setup("--programs")
    assert "CLAYFOAM_TESTS" not in configure  # as they are in the build folder
    assert "--target" in build
    os.utime(project.top / "exchange" / "source.cpp", (stamp - 5, stamp - 5))
    assert project.setup("--programs") == [[], []]
    assert project.setup()[0]  # the tests are older than the source


def test_another_openfoam_is_built_anew(project):
    project.setup()
    project.env["WM_PROJECT_DIR"] = "/opt/another/OpenFOAM"
    assert project.setup()[0]


def test_a_folder_that_was_moved_is_configured_anew(project):
    cache = project.top / "build" / "CMakeCache.txt"
    source = project.top / "exchange" / "source.cpp"
    for home, there in ((project.top, True), ("/some/where/else", False)):
        project.setup()
        cache.write_text(f"A:B=1\nCMAKE_HOME_DIRECTORY:INTERNAL={home}\n")
        (project.top / "build" / "CMakeFiles").mkdir(exist_ok=True)
        stamp = (project.top / "build" / ".ready").stat().st_mtime
        os.utime(source, (stamp + 5, stamp + 5))
        project.setup()
        # the stand-in for cmake leaves what is there
        assert (cache.read_text() != "", (project.top / "build" / "CMakeFiles").is_dir()) == (there, there)
        os.utime(source, (stamp - 5, stamp - 5))
