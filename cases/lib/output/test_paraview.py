# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The files for ParaView hold what the dumps hold, to the last bit."""

import base64
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

from cases.lib.case.errors import CaseError
from cases.lib.output import paraview, spheres

DUMP = """ITEM: TIMESTEP
{step}
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS ff ff ff
0 1
0 1
0 1
ITEM: ATOMS id mol type x y z vx vy vz radius
1 7 1 0.1 0.2 0.3 1e-3 2e-3 -3e-3 0.001
2 8 2 0.4 0.5 {z} 4e-3 5e-3 6e-3 0.002
"""


@pytest.fixture
def run(tmp_path):
    (tmp_path / "DEM").mkdir()
    for step, z in ((0, 0.6), (20, 1 / 3)):
        (tmp_path / "DEM" / f"spheres.{step:09d}.dump").write_text(DUMP.format(step=step, z=z))
    return tmp_path


def arrays(path):
    """The data arrays of a .vtu by name, decoded by the format's own description."""
    found, root = {}, ElementTree.parse(path).getroot()
    head = {"UInt64": 8, "UInt32": 4}[root.get("header_type", "UInt32")]
    for a in root.iter("DataArray"):
        raw = base64.b64decode(a.text.strip())
        assert int.from_bytes(raw[:head], "little") == len(raw) - head
        values = np.frombuffer(raw[head:],
                               {"Float64": "<f8", "Int64": "<i8", "Int32": "<i4", "UInt8": "u1"}[a.get("type")])
        found[a.get("Name")] = values.reshape(-1, int(a.get("NumberOfComponents", 1))).squeeze()
    return found


def test_a_dump_bit_by_bit(run):
    paraview.time_series(str(run), 1e-5)
    found = arrays(run / "DEM" / "spheres.000000020.vtu")
    assert found["Points"].tolist() == [[0.1, 0.2, 0.3], [0.4, 0.5, 1 / 3]]
    assert found["velocity"].tolist() == [[1e-3, 2e-3, -3e-3], [4e-3, 5e-3, 6e-3]]
    assert found["radius"].tolist() == [0.001, 0.002]
    assert [found[k].tolist() for k in ("clump", "type", "id")] == [[7, 8], [1, 2], [1, 2]]
    assert found["connectivity"].tolist() == [0, 1]
    assert found["types"].tolist() == [1, 1]  # vertices


def test_times(run):
    paraview.time_series(str(run), 1e-5)
    sets = list(ElementTree.parse(run / "DEM" / "spheres.pvd").getroot().iter("DataSet"))
    assert [(float(s.get("timestep")), s.get("file")) for s in sets] == [
        (0.0, "spheres.000000000.vtu"), (2e-4, "spheres.000000020.vtu")]


def test_free_spheres_are_their_own_clumps(tmp_path):
    one = {k: np.array([1.0]) for k in ("id", "type", "radius", "x", "y", "z", "vx", "vy", "vz")}
    paraview.write(str(tmp_path / "one.vtu"), one)
    assert arrays(tmp_path / "one.vtu")["clump"].tolist() == 1


def test_no_dumps(tmp_path):
    with pytest.raises(CaseError, match="holds no dumps"):
        spheres.dumps(str(tmp_path))
