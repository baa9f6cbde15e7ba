# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Run folders: whose they are, what is in them, who may write there. What a run
has computed is never deleted unless that is asked for."""

import glob
import json
import os
import re
import shlex
import shutil

from cases.lib.case import files, heading, places
from cases.lib.case.casefile import Case, TOP
from cases.lib.case.errors import CaseError

MARK = "case.json"
_FORMAT = "clayFoam run"
LOCK = ".lock"
# what a run leaves behind; removed when its folder is used again
_REMAINS = ("DEM", "CFD", "alone", "dem.json", "summary.json", "report.html", "settling.csv", "solids.csv",
            "profile.csv", "stages.json", "*.png",
            "pressure_drop.csv", "bed.json",
            "*.liggghts", "packing.*", "packmol", "log.liggghts", "run.sh", "DEM.pvd",
            "checkpoints", "restart_forced_liggghts_*.data")  # LIGGGHTS's, when it is interrupted
# any of these says that something was computed
_RESULTS = ("settling.csv", "DEM/dem.json", "DEM/spheres.*.dump", "CFD/cfd.json")
# what OpenFOAM does not take in the name of a folder
_UNFIT = re.compile(r"[\s\"'`;{}$()]")


def fit(path, what, remedy):
    """Refuses a path that OpenFOAM would break in two."""
    unfit = _UNFIT.search(path)
    if unfit:
        raise CaseError(f"{what} {path!r}: OpenFOAM takes no {unfit.group()!r} in a path; {remedy}")


def read_mark(folder):
    """What the mark of a run's folder says, None without one: case, title, values, ranks. A
    symbolic link is none, nor is another file of that name."""
    path = os.path.join(folder, MARK)
    if os.path.islink(path) or not os.path.isfile(path):
        return None
    try:
        with open(path, encoding="utf-8") as f:
            found = json.load(f)
    except (ValueError, OSError, RecursionError):
        return None
    good = isinstance(found, dict) and found.get(_FORMAT) == 1 and isinstance(found.get("values"), dict)
    return found if good else None


def of(mark):
    """The case a mark names, as Case takes it."""
    return mark.get("from", mark["case"])


def case_of(folder):
    """The case a folder was made for, with its values and its ranks."""
    mark = read_mark(folder)
    if mark is None:
        raise CaseError(f"{folder}: is no run's folder; it lacks {MARK}")
    case = Case(of(mark))
    lacking = sorted(set(case.values) - set(mark["values"]))
    if lacking:
        raise CaseError(f"{folder}: was made by another version of this project; it says nothing of {lacking[0]}")
    case.values = {key: mark["values"][key] for key in case.values}
    return case, mark["ranks"]


def write_mark(folder, case, ranks):
    """Marks the folder as this case's, for programs and to be read."""
    own = {"from": case.reference} if case.reference != case.name else {}
    files.write_json(os.path.join(folder, MARK), {_FORMAT: 1, "case": case.name, **own, "title": case.title,
                                                  "values": case.values, "ranks": list(ranks)})
    with files.writing(os.path.join(folder, "case.txt")) as f:
        f.write(f"{case.name}: {heading.of(case, case.derive(*ranks))}\n\n{case.table()}\n")


def summary(folder):
    """summary.json, {} when there is none that can be read."""
    try:
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as f:
            found = json.load(f)
    except (ValueError, OSError, RecursionError):
        return {}
    return found if isinstance(found, dict) else {}


def holds(folder):
    """What is in a folder: nothing, prepared, unfinished or finished (a run), other."""
    try:
        there = set(os.listdir(folder)) - {LOCK}
    except FileNotFoundError:
        return "nothing"
    except OSError as e:
        raise CaseError(f"--out {folder}: {e.strerror}; name another folder") from None
    if not there:
        return "nothing"
    if read_mark(folder) is None:
        return "other"
    if summary(folder).get("complete"):
        return "finished"
    found = any(glob.glob(os.path.join(glob.escape(folder), p)) for p in _RESULTS)
    return "unfinished" if found else "prepared"


def _lock(place):
    """The lock of a folder, which is made if need be."""
    try:
        os.makedirs(place, exist_ok=True)
        return files.Lock(os.path.join(place, LOCK))
    except files.Taken:
        raise CaseError(f"{place}: another run writes there; wait for it, or name another folder by --out") from None
    except OSError as e:
        raise CaseError(f"--out {place}: {e.strerror}; name another folder") from None


def _free(stem):
    """The first of stem.1, stem.2 ... that is not there."""
    number = 1
    while os.path.lexists(f"{stem}.{number}"):
        number += 1
    return f"{stem}.{number}"


def _clear(folder):
    """Takes away what an older run left."""
    for pattern in _REMAINS:
        for old in glob.glob(os.path.join(glob.escape(folder), pattern)):
            shutil.rmtree(old) if os.path.isdir(old) and not os.path.islink(old) else os.remove(old)


def _beside(place):
    """Where --dry-run writes when the place itself holds something."""
    while True:
        other = place + "-dry-run"
        if holds(other) in ("nothing", "prepared"):
            return other
        place = other


def place_of(case_name, out):
    """The path of a run's folder; out: --out, or None for results/NAME."""
    fit(TOP, "the project's folder", "move the project")
    if out is not None and not out.strip():
        raise CaseError(f"--out {out!r}: must name a folder")
    place = os.path.abspath(os.path.join(places.base(), "results", case_name) if out is None else out)
    fit(place, "--out", "name another folder")
    if os.path.lexists(place) and not os.path.isdir(place):
        raise CaseError(f"--out {place}: is a file; name a folder")
    return place


def claim_again(case, out):
    """The folder of a run of the case that is to go on, as it is, (its path, the lock it is held by)."""
    place = place_of(case.name, out)
    mark = read_mark(place)
    if mark is None:
        raise CaseError(f"{place}: holds no run to go on with")
    if of(mark) != case.reference:
        raise CaseError(f"{place}: holds a run of case {of(mark)}")
    return place, _lock(place)


def offer(place, case, called=None):
    """The command by which the run of that folder, then called so, goes on to the case's end; empty where it has no
    saved state, is there already, or has other settings."""
    mark, end = read_mark(place), case.values["end"]
    pairs = os.path.join(place, "checkpoints")
    saved = os.path.isdir(pairs) and any(map(str.isdigit, os.listdir(pairs)))
    if mark is None or of(mark) != case.reference or not saved:
        return ""
    there = summary(place)
    reached = there.get("simulated_s") or 0
    if {**mark["values"], "end": end} != case.values:
        return ""
    # one that was ended as it came to its end is not complete, and its last state lies before. Times are sums of steps
    beyond = reached - end
    if beyond > 0.5 * case.values["dem_step"] + 1e-9 * end or beyond > -1e-9 * end and there.get("complete"):
        return ""
    further = "" if mark["values"].get("end") == end else f" --end {end:.12g}"
    return (f"{places.called('run')} {shlex.quote(case.reference)} --out {shlex.quote(called or place)} "
            f"--continue{further}")


def claim(case, out, overwrite=False, dry_run=False, tell=print):
    """A folder for a run of the case, (its path, the lock it is held by), without what an older
    run left there. out: --out, or None for results/NAME."""
    place = place_of(case.name, out)
    inside = holds(place)
    if inside == "other" and out is not None:
        raise CaseError(f"--out {place}: holds other things than a run; name a new folder")
    if dry_run and inside in ("finished", "unfinished", "other") and not (overwrite and inside != "other"):
        tell(f"{place} holds {_words(inside, place)} and stays as it is: prepared beside it")
        place = _beside(place)
    lock = _lock(place)
    try:
        inside = holds(place)  # nobody else changes it now
        if inside in ("finished", "unfinished", "other") and not (overwrite and inside != "other"):
            what = _words(inside, place)
            if out is not None or dry_run:
                more = offer(place, case)
                raise CaseError(f"--out {place}: holds {what}; name another folder, or give --overwrite to delete it" +
                                (f", or go on with it: {more}" if more else ""))
            aside = _free(place)
            more = offer(place, case, os.path.relpath(aside, places.base()))
            os.rename(place, aside)
            here, there = (os.path.relpath(p, places.base()) for p in (place, aside))
            tell(f"{here} held {what}: it is {there} now" +
                 (f"; it would go on by {more}" if more else ""))
            lock.close()
            lock = _lock(place)
        else:
            _clear(place)
    except BaseException:
        lock.close()
        raise
    return place, lock


def _words(inside, place):
    """What a folder holds, as one says it."""
    if inside == "unfinished":
        s = summary(place)
        if s.get("simulated_s") and s.get("end"):
            return f"an unfinished run, {s['simulated_s']:.4g} s of {s['end']:.4g} s"
        return "an unfinished run"
    return {"finished": "a finished run", "other": "other things than a run"}[inside]
