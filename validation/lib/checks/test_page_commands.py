# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What is a page's command, and how it is tried; options and names of all of them are known."""

from validation.lib.checks import page_commands, rooms

_PAGE = """# A title

Text with `cases/run` and `cases/run CASE --keys`, `--set`, and `cases/run --continue`.

    cases/run clump-half --end 1   # a remark
    cases/lib/    no command, a folder
    clayFoam: stopped: no command, a message
    mpirun -np 1 liggghts-clay -in a \\
        : -np 1 clayFoam -case CFD

```
cmake --preset debug && cmake --build build/debug
```
"""


def test_what_is_a_command():
    found = page_commands.commands("a.md", _PAGE)
    assert [(c.line, c.text, c.block) for c in found] == [
        (3, "cases/run CASE --keys", False), (5, "cases/run clump-half --end 1", True),
        (8, "mpirun -np 1 liggghts-clay -in a : -np 1 clayFoam -case CFD", True),
        (12, "cmake --preset debug && cmake --build build/debug", True)]


def trial(text):
    return page_commands.trial(page_commands.Command("a.md", 1, text, True))


def test_how_they_are_tried():
    assert trial("cases/run CASE --keys").words == ("cases/run", "--no-setup", "clump-half", "--keys")
    assert trial("cases/run CASE --keys").how == "as it stands"
    assert trial("cases/run clump-half --end 1 --dem 2").words[3:] == ("--end", "0.02", "--dem", "2")
    assert trial("cases/clay --quiet run ./a").words == (
        "cases/clay", "--no-setup", "--quiet", "run", "./a", "--end", "0.02")
    assert trial("cases/sweep CASE --set KEY=A,B,C").words[-2:] == ("charge=1e-10,2e-10", "--dry-run")
    assert trial("validation/run NAME") == page_commands.Trial(
        "its words", ("validation/run", "--no-setup", "linters", "--list"))
    assert trial("mpirun -np 2 liggghts-clay -in in.a : -np 4 clayFoam").where == "run 2 4 in.a"
    assert trial("mpirun -np 64 liggghts-clay -in in.a : -np 64 clayFoam").how == "excerpt"
    assert trial("clang-format -i a.cpp").words == ("clang-format", "--dry-run", "a.cpp")  # changes nothing
    assert trial("cmake --preset debug && cmake --build build/debug").how == "excerpt"


def test_few_are_not_run():
    every = page_commands.every_command()
    hows = [page_commands.trial(c).how for c in every]
    assert len(every) > 90 and set(hows) == set(page_commands.HOWS)
    assert hows.count("excerpt") <= 0.1 * len(every)
    assert {"README.md", "CONTRIBUTING.md", "cases/README.md", "liggghts-fix/doc/restart.md"} <= {c.page for c in every}


def test_the_checks_that_pages_name_are_there():
    known = rooms.holding("check.py")
    for c in page_commands.every_command():
        words = page_commands.trial(c).words
        if words[:1] == ("validation/run",):
            named = [w for before, w in zip(words, words[1:]) if not w.startswith("-") and before not in (
                "--json", "--part")]
            assert set(named) <= set(known), c
