# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""cases/run --continue: a run goes on from its last complete pair of saved states,
in its own folder, on any number of ranks."""

import contextlib
import glob
import os
import re
import shutil

from cases.lib.case import files, openfoam
from cases.lib.case.errors import CaseError
from cases.lib.case.places import called
from cases.lib.run import folders, prepare, saved_pairs as pairs, series, state

# the last entry of a name counts
_FROM = "\nstartFrom latestTime;\n"
_PARAMETER = re.compile(r'^variable (\w+) string "(.*)"$', re.M)


def set_up(folder, case, derived, tell=print):
    """Makes the folder ready to go on, for the steps and ranks of `derived`. Gives the pair that it goes on from."""
    pair = chosen(folder, derived["steps"], case.values["end"], tell)
    if pair.step % case.values["coupling_steps"]:
        raise CaseError(f"{pair.folder} is of a run with another coupling_steps")
    _keep_outputs(folder, derived)
    cfd = os.path.join(folder, "CFD")
    cut(folder, pair, case.values["dem_step"])
    _fluid(cfd, pair, {**case.values, **derived})
    folders.write_mark(folder, case, (derived["dem_ranks"], derived["cfd_ranks"]))
    return pair


def chosen(folder, steps, end, tell=print):
    """The pair from which a run goes on to its end, of so many steps and at that time [s]."""
    pair = pairs.latest(folder, tell)
    if pair.step == steps and not state.complete(folder):
        tell(f"{called('run')}: passed over, the run was ended after it had saved its end: {pair.folder}")
        pair = pairs.latest(folder, tell, before=pair.step)
    if pair.step >= steps:
        raise CaseError(f"{folder}: its last saved state is that of {pair.time:.6g} s, the run's end {end:.6g} s: "
                        "there is nothing to go on with; a later --end does")
    return pair


def _keep_outputs(folder, derived):
    """Output goes on at the steps it had, also with another end."""
    with open(os.path.join(folder, "parameters.liggghts"), encoding="utf-8") as f:
        before = dict(_PARAMETER.findall(f.read()))
    for key, kind in (("frame_steps", int), ("curve_steps", int), ("profile_steps", int), ("profile_time", float),
                      ("frame_time", float)):
        if key in before:
            derived[key] = kind(before[key])


def _next(stem):
    """The first of stem.1, stem.2 ... that is not there."""
    number = 1
    while os.path.lexists(f"{stem}.{number}"):
        number += 1
    return f"{stem}.{number}"


def cut(folder, pair, dem_step):
    """Takes away what was written after the pair, and puts the logs and measures of the part before aside."""
    cfd = os.path.join(folder, "CFD")
    for path in glob.glob(os.path.join(glob.escape(folder), pairs.FOLDER, "*.part")):
        shutil.rmtree(path)  # a half was killed while it wrote
    for name in ("settling.csv", "solids.csv"):
        path = os.path.join(folder, name)
        if os.path.isfile(path):
            # the row of that step is written again
            series.cut_curve(path, pair.time - 0.5 * dem_step)
    series.join_functions(cfd, pair.time + 0.5 * dem_step)
    for path in glob.glob(os.path.join(glob.escape(folder), "DEM", "spheres.*.dump")):
        if int(os.path.basename(path).split(".")[1]) > pair.step:
            os.remove(path)
    for part in (cfd, *glob.glob(os.path.join(glob.escape(cfd), "processor*"))):
        for time, path in openfoam.times(part):
            if time > pair.time + 0.5 * dem_step:
                shutil.rmtree(path)
    for name in ("DEM/log", "DEM/dem.json", "CFD/log", "CFD/cfd.json"):
        path = os.path.join(folder, name)
        if os.path.isfile(path):
            os.rename(path, _next(path))


def _fluid(cfd, pair, values):
    """The fluid's state in a time folder, from which the case starts, cut up for the ranks that are wanted."""
    name, parts, wanted = f"{pair.time:.8g}", len(pair.cfd), values["cfd_ranks"]
    control = os.path.join(cfd, "system", "controlDict")
    with open(control, encoding="utf-8") as f:
        text = f.read()
    if _FROM not in text:
        text += _FROM
        _write(control, text)
    with _all_digits(control, text):
        if parts == 1 or len(_processors(cfd)) != parts:
            _put_together(cfd)
        if parts > 1 and not _processors(cfd):
            prepare.parameters(os.path.dirname(cfd), {**values, "cfd_ranks": parts})
            openfoam.run("decomposePar", cfd, "-force", "-time", "0")
        pairs.put(pair, cfd, name)
        if parts > 1 and parts != wanted:
            _put_together(cfd)
        prepare.parameters(os.path.dirname(cfd), values)
        if wanted > 1 and parts != wanted:
            openfoam.run("decomposePar", cfd, "-force", "-time", name)


def _processors(cfd):
    return glob.glob(os.path.join(glob.escape(cfd), "processor*"))


def _put_together(cfd):
    """One case of its parts, with all times they hold."""
    if _processors(cfd):
        openfoam.run("reconstructPar", cfd)
    for path in _processors(cfd):
        shutil.rmtree(path)


def _write(path, text):
    with files.writing(path) as f:
        f.write(text)


@contextlib.contextmanager
def _all_digits(control, text):
    """OpenFOAM's programs write what they read to the last bit."""
    _write(control, text + "\nwriteFormat binary;\nwritePrecision 17;\n")
    try:
        yield
    finally:
        _write(control, text)
