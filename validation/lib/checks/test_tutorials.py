# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Tutorials are read as they are written; each has commands, and says what comes of them."""

import os

import pytest

from cases.lib.case.casefile import TOP
from validation.lib.checks import rooms, tutorials


def test_steps():
    page = ("# A\n```shell\na b\nc\n```\ntext\n```{code-block} text\n:caption: expected\nwords\n```\n"
            "```{code-block} json\n:caption: x/case.json\n{}\n```\n```\nnothing\n```\n")
    assert tutorials.steps(page) == [
        ("run", "", "a b\nc\n"), ("expected", "", "words\n"), ("file", "x/case.json", "{}\n")]


@pytest.mark.parametrize("name", rooms.load("tutorials").PARTS)
def test_each_has_commands(name):
    with open(os.path.join(TOP, "manual", name + ".md"), encoding="utf-8") as f:
        assert [k for k, _, _ in tutorials.steps(f.read())].count("run") > 0
