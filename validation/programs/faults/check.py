# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What is done to runs, folders, caches, disks and inputs, and what comes of it."""

import glob
import os
import re
import shutil
import signal
import subprocess
import tempfile

from cases.lib.case import cache
from cases.lib.case.casefile import TOP
from validation.lib.checks import coupled
from validation.lib.faults import fuzz, inputs, kills, resumed, tries, victim

TITLE = "faults: kills, full disks, two runs at once, damaged caches, odd inputs"
PARTS = ("kills", "continue", "stops", "twice", "caches", "disk", "inputs", "moved", "messages",
         "fuzz")  # of --part
SAVED_BESIDE = 1e-3
_PLACE = os.path.join(coupled.RUNS, "faults")


def _in_turn(trials):
    """One of each kind, then the next of each: what a table has that was cut short it has of all kinds."""
    return sorted(trials, key=lambda t: t["number"])


def _kills(checks, known, long):
    """Signals to each part of a run; few by default, 20 of each in the long part."""
    trials = kills.plan(20) if long else [t for t in kills.plan(1) if (t["target"], t["signal"]) in (
        ("DEM half", "TERM"), ("CFD half", "KILL"), ("mpirun", "KILL"), ("cases/run", "INT"))]
    wrong = {}
    folder = known.place(os.path.join(_PLACE, "kill"))
    for t in known.mine(_in_turn(trials)):
        what = " ".join(str(t[k]) for k in ("target", "signal", "number"))
        said = known.outcome(f"kill {what}", lambda t=t: kills.attempt(t, folder))
        wrong.setdefault((t["target"], t["signal"]), []).append(said)
    for (target, name), said in wrong.items():
        bad = [s for s in said if s]
        checks.true(f"SIG{name} to {target}: {len(said)} ended right", not bad, bad[0] if bad else len(said))


def _continue(checks, known, long):
    """A run that is ended goes on by --continue, and ends with the curve of one that was not."""
    trials = resumed.plan(20 if long else 1)
    if not long:
        short = (("CFD half", "KILL"), ("mpirun", "KILL"), ("DEM half", "TERM"), ("CFD half", "TERM"),
                 ("cases/run", "INT"))
        trials = [t for t in trials if (t["target"], t["signal"]) in short]
    wanted, said = {}, {}
    for t in known.mine(_in_turn(trials)):
        ranks = t["ranks"]
        if ranks not in wanted:
            wanted[ranks], why = known.kept(f"whole-{ranks[0]}-{ranks[1]}", lambda t=t: resumed.whole(
                known.place(os.path.join(_PLACE, "whole")), t))
            checks.true(f"a run on {ranks[0]} + {ranks[1]} ranks that nothing is done to", wanted[ranks], why)
        if not wanted[ranks]:
            continue
        # a state saved beside the steps of checkpoint_steps makes lists and factors anew there: p differs within its
        # tolerance from there on, and falling spheres that meet take that further
        most = SAVED_BESIDE if (t["target"], t["signal"]) in resumed.BESIDE else 0.0
        what = " ".join(str(t[k]) for k in ("target", "signal", "number"))
        said.setdefault((t["target"], t["signal"]), []).append(known.outcome(
            f"continue {what}", lambda t=t, ranks=ranks, most=most:
            resumed.attempt(t, known.place(os.path.join(_PLACE, "continue")), wanted[ranks], most)))
    for (target, name), found in said.items():
        bad = [s for s in found if s]
        checks.true(f"SIG{name} to {target}, then --continue: {len(found)} with the curve of a run that was not ended",
                    not bad, bad[0] if bad else len(found))


def _stops(checks, _known, long):
    """A half that is stopped for a while, and for longer than the time-out."""
    for target in ("DEM half", "CFD half") if long else ("DEM half",):
        code, state, said = kills.stopped(os.path.join(_PLACE, "stop"), target, 2, 60)
        checks.true(f"{target} stopped for 2 s: goes on to its end", code == 0 and state.get("complete"), said[-200:])
    for target in ("DEM half", "CFD half") if long else ("CFD half",):
        code, state, said = kills.stopped(os.path.join(_PLACE, "stop"), target, 15 * victim.slowdown(), 3)
        checks.true(f"{target} stopped for longer than the time-out: ends", code == 1 and "left:" not in said,
                    said[-200:])
        checks.true(f"{target} stopped for longer: the state says so",
                    state.get("complete") is False and "waited 3" in state.get("reason", "")
                    and "CLAYFOAM_TIMEOUT" in state["reason"], state)


def _twice(checks, _known, _long):
    """Two runs into one folder."""
    codes, said, state = kills.twice(os.path.join(_PLACE, "twice"))
    checks.equal("two runs into one folder: exit codes", sorted(c if c is not None else 99 for c in codes), [0, 2])
    checks.true("two runs into one folder: the second says why", "another run writes there" in said, said[-200:])
    checks.true("two runs into one folder: the first is complete", state.get("complete"), state)
    checks.equal("two runs into one folder: parts of files", kills.remains(os.path.join(_PLACE, "twice")), [])


def _prepare(where, *words):
    """cases/run --dry-run of a small case; its outcome and folder."""
    return coupled.case("sphere-half", f"faults/{where}", "--dry-run", "--set", "seed=977", "--set", "spheres=40",
                        *words, limit=60 * victim.slowdown())


def _read(path):
    """A file's lines but for comments, which tell how long something took."""
    with open(path, "rb") as f:
        return [line for line in f if not line.startswith(b"#")]


def _entry(kind, folder):
    """The folder of the cache that a run's packing or mesh was copied from, known by its content."""
    name, mine = {"packings": ("packing.places", "packing.places"),
                  "meshes": ("points", "CFD/constant/polyMesh/points")}[kind]
    mine = _read(os.path.join(folder, mine))
    return next(os.path.dirname(p) for p in glob.glob(os.path.join(cache.place(kind), "*", name)) if _read(p) == mine)


def _caches(checks, _known, _long):
    """Entries of the caches that are cut, emptied, or lack a file."""
    first, folder = _prepare("cache-first")
    checks.equal("caches: prepared", first.status, 0)
    for kind, name in (("packings", "packing.places"), ("packings", "packing.json"), ("meshes", "points"),
                       ("meshes", "owner")):
        file = os.path.join(_entry(kind, folder), name)
        for how in ("cut", "emptied", "removed"):
            if how == "removed":
                os.remove(file)
            else:
                os.truncate(file, os.path.getsize(file) // 2 if how == "cut" else 0)
            again, other = _prepare("cache-again")
            same = all(_read(os.path.join(other, n)) == _read(os.path.join(folder, n))
                       for n in ("packing.places", "CFD/constant/polyMesh/points", "CFD/constant/polyMesh/owner"))
            checks.true(f"caches: {kind}/{name} {how}: named, healed, the same again",
                        again.status == 0 and same
                        and f"{os.path.dirname(file)} is damaged: made anew" in again.output,
                        f"exit code {again.status}, same: {same}, {again.output.strip()[:200]}")


def _disk(checks, known, long):
    """A run on a disk of any size: it ends complete, or with the reason and the place."""
    for size in known.mine(range(60, 2060, 100) if long else (100, 700)):
        said = known.outcome(f"disk {size}", lambda size=size: _on_disk(size))
        if said == "no mount":
            checks.skipped("a full disk", "no small file system can be mounted here")
            return
        checks.true(f"a disk of {size} kB: complete, or the reason with its place", not said, said)


def _on_disk(kilobytes):
    with tempfile.TemporaryDirectory() as place:
        if subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={kilobytes}k", "tmpfs", place], check=False,
                          stderr=subprocess.DEVNULL).returncode:
            return "no mount"
        try:
            with victim.Run("clump-half", os.path.join(place, "run"), "--end", "0.05") as run:
                code, _ = run.end()
                said, state = run.said().strip(), run.state()
        finally:
            subprocess.run(["umount", "-l", place], check=False)
    if code is None or "Traceback" in said or "[Errno" in said or "[(" in said:
        return f"exit code {code}: {said[-300:]}"
    if code == 0:
        return "" if state.get("complete") else f"exit code 0, but {state}"
    if state.get("complete") and code != 4:
        return f"exit code {code}, but complete"
    last = said.splitlines()[-1] if said else ""
    return "" if last and (place in said or "CFD" in said or "DEM" in said) else f"exit code {code}: {said[-300:]}"


def _inputs(checks, known, long):
    """Odd command lines: one line that says why, or a run that ends right."""
    numbers = known.mine(range(500 if long else 12))
    folder = known.place(os.path.join(_PLACE, "input"))
    wrong = []
    for number in numbers:
        words = inputs.words(number)
        said = known.outcome(f"input {number} {words}", lambda words=words: _input(words, folder))
        if said:
            wrong.append(f"{' '.join(words)}: {said}")
    for line in wrong[:20]:
        checks.note(line)
    checks.true(f"{len(numbers)} odd command lines: one line, or right", not wrong,
                f"{len(wrong)}, as {wrong[0]}" if wrong else len(numbers))


def _input(words, folder):
    with victim.Run(words[0], folder, "--overwrite", *words[1:]) as run:
        # what is refused has to be so soon; what runs may take its time, as seen by its plan
        run.until(lambda: "plan: " in run.said(), 10)
        if run.process.poll() is None and "plan: " not in run.said():
            return "not a word in 10 s"
        if _large(run.said()):
            return ""  # it is as it should be, and takes too long here
        code, _ = run.end(60)
        said = run.said().strip()
        if code is None:
            return "goes on after 60 s"
        if "Traceback" in said:
            return "a traceback: " + said.splitlines()[-1]
        left = run.left()
        if left:
            return f"left: {left}"
        if code == 0:
            return "" if run.state().get("complete") else f"exit code 0, but {run.state()}"
        reasons = [x for x in said.splitlines() if x.startswith("cases/run: ")]
        if code == 2:
            good = len(reasons) == 1 or "usage: " in said
        else:
            good = code in (1, 3) and run.state().get("reason", "lost") and "no half said why" not in said \
                and "exited on signal" not in said
        return "" if good else f"exit code {code}: {said[-300:]}"


def _large(said):
    """Whether the plan has said that it takes its time, a large mesh or many particles."""
    line = next((x for x in said.splitlines() if x.startswith("plan: ")), "")
    counts = [int(n) for n in re.findall(r"(\d+) (?:cells|spheres)", line)]
    return bool(line) and (not line.endswith(" s") or float(line.split()[-2]) > 10 or max(counts) > 10000)


def _moved(checks, _known, _long):
    """The project's folder, copied to another place, with nothing left of the first in what it loads."""
    with tempfile.TemporaryDirectory() as place:
        for name in ("cases", "cmake", "__main__.py", "CMakeLists.txt"):
            source = os.path.join(TOP, name)
            shutil.copytree(source, os.path.join(place, name)) if os.path.isdir(source) else shutil.copy(source, place)
        for name in ("bin/liggghts-clay", "bin/clayFoam", "lib"):
            source, target = os.path.join(TOP, "build", name), os.path.join(place, "build", name)
            os.makedirs(os.path.dirname(target), exist_ok=True)
            shutil.copytree(source, target) if os.path.isdir(source) else shutil.copy(source, target)
        for program in ("liggghts-clay", "clayFoam"):
            said = subprocess.run(["ldd", os.path.join(place, "build", "bin", program)], capture_output=True, text=True,
                                  check=False).stdout
            ours = [x.strip() for x in said.splitlines() if TOP + os.sep in x or "not found" in x]
            checks.equal(f"moved: {program} loads nothing from where it was", ours, [])
        done = coupled.execute([os.path.join(place, "cases", "run"), "--no-setup", "clump-half", "--end", "0.01",
                                "--no-pictures"], 120 * victim.slowdown())
        checks.equal("moved: a run there", done.status, 0)


def _messages(checks, known, long):
    """Damaged messages between the halves: the tests of the decoders, which ctest knows; long every one of them."""
    if not checks.parts and not long:
        return  # the check `unit` has just run them
    tested = coupled.execute(["ctest", "--test-dir", os.path.join(TOP, "build"), "-R",
                              r"^exchange\.(decode|damage_runs|fuzz)$"], 600 * victim.slowdown())
    if "No tests were found" in tested.output:
        checks.skipped("damaged messages", "its tests are not built")
        return
    checks.true("damaged messages: exchange.decode, damage_runs, fuzz", tested.status == 0,
                tested.output.strip()[-200:])
    if not long:
        return
    every, wrong = _all_messages(), []
    mine = known.mine(range(0, every, _AT_ONCE))
    for first in mine:
        said = known.outcome(f"messages {first}", lambda first=first: _damaged(first, first + _AT_ONCE))
        if said:
            wrong.append(f"{first}: {said}")
    checks.at_least("damaged messages of a run of two programs", every, 300)
    done = min(_AT_ONCE * len(mine), every)
    checks.true(f"{done} damaged messages: both halves end, with the reason", not wrong, wrong[0] if wrong else done)


_AT_ONCE = 25


def _damage_runs(chosen, limit):
    program = os.path.join(TOP, "build", "bin", "test_damage_runs")
    return coupled.execute([program, "--gtest_filter=*AMessageEndsBothHalvesWithALine"], limit,
                           env={**os.environ, "CLAYFOAM_DAMAGE": chosen})


def _all_messages():
    """How many there are."""
    return int(re.search(r"0 of (\d+) damaged messages", _damage_runs("0:0", 60).output).group(1))


def _damaged(first, end):
    done = _damage_runs(f"{first}:{end}", 60 * (end - first) * victim.slowdown())
    # what GoogleTest says of the first that fails, ahead of its own sums
    return "" if done.status == 0 else f"exit code {done.status}: {done.output.partition(': Failure')[2].strip()[:600]}"


def _fuzz(checks, known, long):
    """The decoders under libFuzzer, for 10 min."""
    if not checks.parts and not long:
        return
    program, why = fuzz.build(os.path.join(_PLACE, "fuzz", "build"), coupled.execute)
    if not program:
        checks.skipped("libFuzzer on the decoders", why)
        return
    seconds = 600 if long else 10

    def attempt():
        count, wrong = fuzz.attempt(program, seconds, os.path.join(_PLACE, "fuzz"), coupled.execute)
        return wrong or ("" if count >= 1000 * seconds else f"{count} messages, fewer than 1000 a second")
    said = known.outcome(f"fuzz {seconds}", attempt)
    checks.true(f"libFuzzer on the decoders for {seconds} s: no crash, no leak, no hang, 1000 messages a second",
                not said, said)


_DO = {"kills": _kills, "continue": _continue, "stops": _stops, "twice": _twice, "caches": _caches, "disk": _disk,
       "inputs": _inputs, "moved": _moved, "messages": _messages, "fuzz": _fuzz}


def run(checks):
    os.makedirs(_PLACE, exist_ok=True)
    signal.signal(signal.SIGPIPE, signal.SIG_IGN)
    version, shares = tries.version(), tries.parted(checks.parts or PARTS)
    for part in PARTS:
        if part in shares:
            known = tries.Tries(os.path.join(_PLACE, "tries.jsonl"), version, shares[part])
            _DO[part](checks, known, checks.long)
