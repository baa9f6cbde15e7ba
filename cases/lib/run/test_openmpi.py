# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What Open MPI 4 and 5 say is read alike."""

import pytest

from cases.lib.run import launch, openmpi

_RULE = "-" * 74
_ENDED = {
    "4.1": [_RULE, "mpirun noticed that process rank 1 with PID 0 on node vm exited on signal 9 (Killed).", _RULE],
    "5.0": [_RULE, "prterun noticed that process rank 1 with PID 812 on node vm exited on", "signal 9 (Killed).",
            _RULE]}
_TAGGED = {"4.1": "[1,1]<stdout>:", "5.0": "[1,1]<stdout>: ", "5.0, names": "[prterun-vm-812@1,1]<stdout>: "}


@pytest.mark.parametrize("version", _ENDED)
def test_a_program_that_was_ended(version, tmp_path):
    lines = ["something else", *_ENDED[version], "and more."]
    said = openmpi.noticed(lines)
    assert said.partition(" noticed ")[2].startswith("that process rank 1 with PID ")
    assert said.endswith(" on node vm exited on signal 9 (Killed).")
    assert openmpi.NOTICED.search("\n".join(lines))
    (tmp_path / "CFD").mkdir()
    assert launch.Run(str(tmp_path), 1, 1)._watch([line + "\n" for line in lines]) == said


def test_a_line_that_is_cut_off():
    assert openmpi.noticed(["prterun noticed that process rank 1 exited on"]) == \
        "prterun noticed that process rank 1 exited on"
    assert openmpi.noticed(["mpirun noticed that it", _RULE, "went on."]) == "mpirun noticed that it"
    assert openmpi.noticed(["I noticed that process rank 1 exited on signal 9."]) == ""


@pytest.mark.parametrize("version", _TAGGED)
def test_lines_are_sorted_by_rank(version, tmp_path):
    (tmp_path / "CFD").mkdir()
    said = launch.Run(str(tmp_path), 1, 1)._watch([
        _TAGGED[version] + "clayFoam: starts\n", _TAGGED[version].replace(",1]", ",0]") + "ERROR: no room\n"])
    assert said == "ERROR: no room"
    assert (tmp_path / "CFD" / "log").read_text() == "clayFoam: starts\n"


def test_more_ranks_than_cores(tmp_path, monkeypatch):
    monkeypatch.setenv("WM_PROJECT_DIR", "/opt/foam")
    monkeypatch.setattr(launch, "cores", lambda: 2)
    alone, crowd = launch.Run(str(tmp_path), 1, 1), launch.Run(str(tmp_path), 1, 2)
    assert alone.command()[:4] == ["mpirun", "--bind-to", "none", "-np"]
    assert crowd.command()[:6] == ["mpirun", "--bind-to", "none", "--map-by", ":OVERSUBSCRIBE", "-np"]
    names = {"OMPI_MCA_mpi_yield_when_idle": "1", "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe"}
    assert {k: v for k, v in crowd.exports().items() if k not in alone.exports()} == names
    assert all(f"export {k}={v}" in crowd.script() for k, v in names.items())
