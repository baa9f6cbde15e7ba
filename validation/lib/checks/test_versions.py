# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The CFD half's sources keep to forms that OpenFOAM v1912 to v2512 all take."""

import os
import re

import pytest

from cases.lib.case.casefile import TOP

# what a version does not take, and the form that all do
_FORMS = (
    (r"\w+Ptr\(\)\s*=\s*new\b", "a unique_ptr from v2406 on: = pointer(new ...) with the decayed type"),
    (r"\b(?:r|returnR)educe\s*\(\s*[\w.]+\s*,\s*\[",
     "from v2506 on no list with an operator over lists: reduce its numbers"),
    (r"\?[^:;?]*(?<!vectorField\()(?<!scalarField\()\b\w+\.primitiveField\(\)\s*:\s*\w+Field\(",
     "another type from v2512 on: ? vectorField(U.primitiveField()) : vectorField()"),
    (r"#\s*(?:el)?if[^\n]*\bOPENFOAM\b", "no version is asked for"),
)


def faults(text):
    """The line and the cure of each form that some version does not take."""
    code = re.sub(r"//[^\n]*|/\*.*?\*/", lambda m: "\n" * m.group().count("\n"), text, flags=re.S)
    return [(code.count("\n", 0, m.start()) + 1, cure) for form, cure in _FORMS for m in re.finditer(form, code, re.S)]


def test_every_version_takes_the_sources():
    found, seen = [], 0
    for folder, _, names in os.walk(os.path.join(TOP, "foam-coupling")):
        for path in (os.path.join(folder, n) for n in names if n.endswith((".C", ".H"))):
            seen += 1
            with open(path, encoding="utf-8") as f:
                found += [(os.path.relpath(path, TOP), *fault) for fault in faults(f.read())]
    assert found == []
    assert seen > 100


@pytest.mark.parametrize("text", [
    'pEqn.faceFluxCorrectionPtr() =\n    new surfaceScalarField(a);',
    "reduce\n(\n    sizes,\n    [](const FixedList<scalar, 2>& a, const FixedList<scalar, 2>& b)\n    {\n",
    "f ? U_.primitiveField() : vectorField()", "#if OPENFOAM > 2406"])
def test_each_form_is_seen(text):
    assert [line for line, _ in faults("\n" + text)] == [2]


@pytest.mark.parametrize("text", [
    "pEqn.faceFluxCorrectionPtr() = pointer(new surfaceScalarField(a));", "reduce(sizes[0], sumOp<scalar>());",
    "f ? vectorField(U_.primitiveField()) : vectorField()", "// OPENFOAM"])
def test_what_all_take_is_let_pass(text):
    assert faults(text) == []
