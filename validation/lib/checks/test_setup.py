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
[ ! -f "$NOTES/error" ] || { cat "$NOTES/error"; exit 1; }
mkdir -p build/bin && touch build/CMakeCache.txt
for p in liggghts-clay clayFoam; do echo > build/bin/$p && chmod +x build/bin/$p; done
""",
    "dpkg": "#!/bin/sh\necho /usr/share/packaged/etc/controlDict\n",
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
        for name in [n for n in self.env if n.startswith(("WM_", "FOAM_"))]:
            self.env.pop(name)

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
    cache = project.top / "build" / "CMakeCache.txt"
    for name, value in (("WM_PROJECT_DIR", "/opt/another/OpenFOAM"), ("WM_PROJECT_VERSION", "v2312"),
                        ("WM_LABEL_SIZE", "64"), ("WM_PRECISION_OPTION", "DP"), ("FOAM_LIBBIN", "/opt/lib"),
                        ("FOAM_MPI", "mpi")):
        project.env[name] = value
        cache.write_text("of another OpenFOAM")
        assert project.setup()[0], name
        assert cache.read_text() == "", name  # the stand-in for cmake leaves what is there
        assert project.setup() == [[], []], name


def test_the_package_s_own_folder_is_no_other_openfoam(project):
    packages = project.setup()[1]
    assert "openfoam" in packages
    for folder in ("/usr/share/packaged", "/usr/share/packaged/"):
        project.env["WM_PROJECT_DIR"] = folder
        assert project.setup() == [[], []]
    project.env["WM_PROJECT_DIR"] = "/usr/share"
    assert "openfoam" not in project.setup()[1]


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


@pytest.mark.parametrize("text, said", [
    ("CMake Error at a.cmake:1 (message):\n   a setting: a cure\nCall Stack (most recent first):\n  b.txt:2 (c)\n\n",
     "a setting: a cure"),
    ("-- well\nCMake Error at a.cmake:1 (message):\n  a setting:\n  a cure\n\n\n-- Configuring incomplete\n",
     "a setting: a cure"),
    ("one.cpp:3:1: error: no such thing\nmake: *** [one] Error 1\n", "one.cpp:3:1: error: no such thing")])
def test_a_build_that_fails_ends_with_its_complaint(project, text, said):
    (project.notes / "error").write_text(text)
    done = subprocess.run([project.top / "cmake" / "setup.sh"], env=project.env, check=False, text=True,
                          capture_output=True)
    assert done.returncode == 1
    assert done.stderr == f"setup: the build failed: {said} (log in build/setup.log)\n"
