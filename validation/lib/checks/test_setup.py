# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cmake/setup.sh: what each way to call it asks for, and when it has nothing to do.
Stand-ins for cmake and dpkg-query note how they are called; a build takes minutes."""

import os
import pty
import shutil
import subprocess

import pytest

from cases.lib.case.casefile import TOP

_STAND_INS = {
    "cmake": """#!/bin/sh
echo "$@" >> "$NOTES/cmake"
[ ! -f "$NOTES/error" ] || { cat "$NOTES/error"; exit 1; }
mkdir -p build/bin && touch build/CMakeCache.txt
case $1 in --build) for i in 3 9 10 11 52 99 100; do printf '[%3d%%] Building CXX object a.o\\n' $i; done;; esac
for p in liggghts-clay clayFoam; do echo > build/bin/$p && chmod +x build/bin/$p; done
""",
    "dpkg": "#!/bin/sh\necho /usr/share/packaged/etc/controlDict\n",
    "dpkg-query": '#!/bin/sh\nfor last; do :; done\necho "$last" >> "$NOTES/packages"\n'
                  'case " $MISSING " in *" $last "*) echo no;; *) echo installed;; esac\n',
    "id": "#!/bin/sh\necho ${ID:-0}\n",
    "sudo": '#!/bin/sh\necho sudo >> "$NOTES/apt"\nexec "$@"\n',
    "apt-get": """#!/bin/sh
echo "$@" >> "$NOTES/apt"
[ "$2" = update ] && exit 0
echo "0 upgraded, 30 newly installed, 0 to remove and 0 not upgraded."
for i in $(seq 30); do echo "Get:$i somewhere"; done
for i in $(seq 30); do echo "Setting up p$i (1.0) ..."; done
""",
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
                "clang-tidy", "shellcheck", "python3-flake8", "chromium"} & set(packages)


def test_a_page_needs_its_template_engine(project):
    assert "python3-jinja2" in project.setup("--programs", "--reports")[1]
    assert project.setup("--programs", "--reports") == [[], ["python3-jinja2"]]  # it is looked for, nothing is built
    assert project.setup("--programs") == [[], []]
    project.env["MISSING"] = "python3-jinja2"
    (project.notes / "apt").write_text("")
    project.setup("--programs", "--reports")
    assert "install python3-jinja2" in (project.notes / "apt").read_text()


def test_the_manual_needs_its_tools_alone(project):
    assert project.setup("--docs") == [[], ["python3-sphinx", "python3-myst-parser"]]  # and nothing is built
    project.setup()
    assert project.setup("--docs")[0] == []
    for words in (["--programs"], ["--programs", "--reports"]):
        os.utime(project.top / "exchange" / "source.cpp")
        assert not {"python3-sphinx", "python3-myst-parser"} & set(project.setup(*words)[1])


def test_checks_need_the_tests(project):
    (configure, build), packages = project.setup()
    assert "-DCLAYFOAM_TESTS=ON" in configure and "--target" not in build
    assert {"libgtest-dev", "valgrind", "python3-pytest", "clang-format", "shellcheck"} <= set(packages)
    # none of them is skipped
    assert {"chromium", "python3-sphinx", "python3-myst-parser"} <= set(packages)


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


def on_terminal(project, answer, *words):
    """The exit code, what apt-get was called with, and what stood on the terminal."""
    ours, theirs = pty.openpty()
    (project.notes / "apt").write_text("")
    os.write(ours, answer.encode())
    process = subprocess.Popen([project.top / "cmake" / "setup.sh", *words], env=project.env, stdin=theirs,
                               stdout=theirs, stderr=theirs)
    os.close(theirs)
    said = b""
    try:
        while part := os.read(ours, 4096):
            said += part
    except OSError:  # the other end is closed
        pass
    os.close(ours)
    return process.wait(), (project.notes / "apt").read_text().splitlines(), said.decode()


@pytest.fixture
def user(project):
    """A machine that lacks packages, of a user with sudo."""
    project.env.update(ID="1000", MISSING="cmake packmol")
    return project


@pytest.mark.parametrize("answer, goes_on", [("y\n", True), ("\n", True), ("n\n", False), ("\4", False)])
def test_asks_before_it_installs_with_sudo(user, answer, goes_on):
    code, calls, said = on_terminal(user, answer, "--programs")
    assert "setup: install with sudo: cmake packmol? [Y/n]" in said
    assert (code == 0, "sudo" in calls) == (goes_on, goes_on)
    assert ("setup: nothing was installed; these packages are missing: cmake packmol" in said) == (not goes_on)
    assert any("install cmake packmol" in call for call in calls) == goes_on


@pytest.mark.parametrize("uid, words, terminal", [("1000", ["--yes"], True), ("0", [], True), ("1000", [], False)])
def test_does_not_ask(user, uid, words, terminal):
    user.env["ID"] = uid
    if terminal:
        code, calls, said = on_terminal(user, "n\n", *words)
        assert code == 0
    else:
        done = subprocess.run([user.top / "cmake" / "setup.sh"], env=user.env, check=True, text=True, input="n\n",
                              capture_output=True)
        calls, said = (user.notes / "apt").read_text().splitlines(), done.stdout + done.stderr
    assert "[Y/n]" not in said
    assert any("install cmake packmol" in call for call in calls)
    assert ("sudo" in calls) == (uid != "0")


def test_shows_how_far_it_is(user):
    done = subprocess.run([user.top / "cmake" / "setup.sh"], env=user.env, check=True, text=True, capture_output=True,
                          stdin=subprocess.DEVNULL)
    assert done.stdout.splitlines() == [
        "setup: installing cmake packmol", "setup: installing: 0 fetched, 0 of 30 packages are set up",
        "setup: installing: 20 fetched, 0 of 30 packages are set up",
        "setup: installing: 30 fetched, 10 of 30 packages are set up",
        "setup: installing: 30 fetched, 30 of 30 packages are set up", "setup: building (log in build/setup.log)",
        "setup: building: 3 %", "setup: building: 52 %", "setup: building: 99 %"]
    assert (user.top / "build" / "setup.log").read_text().count("Building CXX") == 7


def test_renews_one_line_on_a_terminal(user):
    said = on_terminal(user, "n\n", "--yes")[2]
    assert "".join(f"\rsetup: building: {i} %" for i in (3, 9, 10, 11, 52, 99, 100)) in said
    assert "\rsetup: installing: 30 fetched, 29 of 30 packages are set up" in said
