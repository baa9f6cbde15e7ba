# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Fields of OpenFOAM in both of its formats: output is ascii, saved states are binary."""

import numpy as np
import pytest

from cases.lib.case import openfoam
from cases.lib.case.errors import CaseError

HEAD = "FoamFile\n{{\n    version 2.0;\n    format {};\n    class volVectorField;\n}}\ndimensions [0 1 -1 0 0 0 0];\n"


def field(tmp_path, kind, body):
    path = tmp_path / "U"
    path.write_bytes(HEAD.format(kind).encode() + b"internalField " + body)
    return str(path)


def test_ascii(tmp_path):
    u = openfoam.internal_field(field(tmp_path, "ascii", b"nonuniform List<vector> 2((1 2 3) (4 5 6));"), 2)
    assert u.tolist() == [[1, 2, 3], [4, 5, 6]]


def test_binary(tmp_path):
    values = np.array([[1.5, -2.0, 3e-9], [4.0, 1 / 3, -0.0]])
    body = b"nonuniform List<vector> 2(" + values.tobytes() + b");\nboundaryField { }\n"
    assert np.array_equal(openfoam.internal_field(field(tmp_path, "binary", body), 2), values)
    body = b"nonuniform List<scalar> 2(" + values.tobytes()[:16] + b");"
    one = openfoam.internal_field(field(tmp_path, "binary", body), 2)
    assert one.tolist() == [[1.5], [-2.0]]
    assert openfoam.internal_field(field(tmp_path, "binary", b"uniform (1 2 3);"), 2).tolist() == 2 * [[1, 2, 3]]
    with pytest.raises(CaseError, match="is not whole"):
        openfoam.internal_field(field(tmp_path, "binary", b"nonuniform List<vector> 2(" + values.tobytes()[:40]), 2)
