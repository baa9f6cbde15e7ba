# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What is skipped, what that gains and what it costs in accuracy: validation/bench skips.

Each row is a pair of runs, one in which the feature's work is done and one in
which it is left out, made in turn, in processor time; where work is only done
for what a scene has, the pair is a scene with and without it.
"""

import filecmp
import json
import os
import re
import statistics
from dataclasses import dataclass, field

from validation.lib.bench import bench_curve, bench_run
from validation.lib.checks import fields
from validation.lib.checks.verdicts import Broken

COLUMNS = ("feature", "switch", "scene", "timing", "work_s", "skipped_s", "gain", "error", "error_of", "note")
_FORCES = "pressureGradient+buoyancy"
_MORE = _FORCES + "+addedMass+saffmanMei+magnus+torque"


@dataclass
class Variant:
    """Changes of a case's values; edit, the name of a change of its script, if any."""

    case: str
    changes: dict = field(default_factory=dict)
    edit: str = ""

    def key(self):
        return self.case, tuple(sorted(self.changes.items())), self.edit


@dataclass
class Row:
    """work is the run with the feature's work done, skip the one without; note
    tells of counts, from both runs' reports."""

    feature: str
    switch: str
    scene: str
    timing: tuple     # whose sum is compared: of DEM/dem.json, CFD/cfd.json
    work: Variant
    skip: Variant
    note: object = None
    of: str = "skip"  # what the error is of: the skip, or the scene, which is another one without the feature


# ---- changes of a script


def _without_charges(text):
    """The style of charges is not there at all."""
    text = re.sub(r"pair_style hybrid/overlay gran/lean (.*?) coul/clump.*", r"pair_style gran/lean \1", text)
    text = re.sub(r"pair_coeff \* \* gran/lean", "pair_coeff * *", text)
    return re.sub(r"pair_coeff .*coul/clump.*\n", "", text)


def _with_bodies(text):
    """The style of bodies is there, and no body."""
    return text.replace("include packing.liggghts", "fix bodies all multisphere/clump\ninclude packing.liggghts")


EDITS = {"without charges": _without_charges, "with bodies": _with_bodies}


# ---- notes


def _wire(work, skip):
    """Bytes a particle and exchange, to the CFD half and back."""
    told = []
    for r in (work, skip):
        each = r["dem"]["particles"] * r["dem"]["exchanges"]
        told.append(" + ".join(f"{r[half]['bytes_sent'] / each:.0f}" for half in ("dem", "cfd")))
    return (f"{told[0]} bytes a particle and exchange, there and back; {told[1]} without: no field is sent that no "
            "model asks for")


def _rest(work, skip):
    d = skip["dem"]
    return (f"{d.get('dem_steps_left_out', 0):.0f} of {d['dem_steps']} DEM steps left out, "
            f"mean height by its own estimate {1e6 * abs(d.get('rest_height_missed_m', 0)):.2g} um off")


def _quiet(work, skip):
    return f"{skip['cfd']['quiet_intervals']} of {skip['cfd']['exchanges'] - 1} intervals not solved"


def _mapped(work, skip):
    a, b = work["cfd"], skip["cfd"]
    return (f"{b['particles_mapped']:.0f} of {a['particles_mapped']:.0f} particles mapped, nothing at all in "
            f"{b['exchanges_without_mapping']} of {b['exchanges']} exchanges")


def _empty(work, skip):
    few, many = skip["cells"], work["cells"]
    each = 1e9 * (work["seconds"] - skip["seconds"]) / ((many[1] - few[1]) * work["cfd"]["exchanges"])
    return (f"no switch: particles are mapped to the cells they touch. {many[0]} of {many[1]} cells hold none, "
            f"{few[0]} of {few[1]} in the other mesh: {each:.0f} ns an empty cell and exchange")


def _plain(text):
    return lambda work, skip: text


# ---- the plan


def scenes(quick):
    """Loose clumps and spheres, and columns that have settled: (case, changes)."""
    bed = {"end": 4.0}
    if quick:
        bed = {"end": 0.6, "fill_height": 0.03, "solid_fraction": 0.3}
    return {"loose clumps": ("clump-half", {"end": 0.02 if quick else 0.2}),
            "loose spheres": ("sphere-half", {"end": 0.02 if quick else 0.2}),
            "settled spheres": ("sphere-half", bed),
            "settled clumps": ("clump-half",
                               {"end": 0.4, "fill_height": 0.03, "clumps": 30} if quick else {"end": 7.0})}


def plan(quick=False):
    """The rows, in the order of the table."""
    known, rows = scenes(quick), []

    def add(feature, switch, scene, timing, work, skip=None, note="", edits=("", ""), of="skip"):
        case, base = known[scene]
        rows.append(Row(feature, switch, scene, timing, Variant(case, {**base, **work}, edits[0]),
                        Variant(case, {**base, **(skip or {})}, edits[1]),
                        _plain(note) if isinstance(note, str) else note, of))

    dem, maps, solves = ("dem.dem_cpu_s",), ("cfd.mapping_cpu_s",), ("cfd.cfd_cpu_s",)
    wire = dem + ("cfd.exchange_s",) + maps
    add("charges", "automatic: all charges zero", "loose clumps", dem, {"charge": 1e-20}, {"charge": 0},
        "charges of 1e-20 C, whose forces move nothing, against none")
    add("charges, style absent", "no pair coul/clump", "loose clumps", dem, {"charge": 0}, {"charge": 0},
        "the style with no charge, against a script without it: what it costs unused", ("", "without charges"))
    add("Coulomb between evaluations", "every N hold", "loose clumps", dem, {"coulomb_steps": 1}, {},
        "evaluated at every step, against every tenth")
    add("far Coulomb pairs", "automatic: out of reach", "loose clumps", dem, {"cutoff": 0.024}, {},
        "cutoff 24 mm against the paper's 12 mm: pairs out of reach are not visited. The sum does not converge with "
        "it, so the error is the model's. Pairs within it, evaluated seldom, gain nothing at equal error "
        "(pair_coul_clump.md)", of="scene")
    add("bodies", "no fix multisphere/clump", "loose spheres", dem, {}, {},
        "the style with no body, against a script without it: what it costs unused", ("with bodies", ""))
    add("torque", "forceModels", "loose spheres", wire, {"forces": _FORCES + "+torque"}, {"forces": _FORCES}, _wire,
        of="scene")
    add("fields on the wire", "automatic: what models ask for", "loose spheres", wire, {"forces": _MORE},
        {"forces": _FORCES}, _wire, of="scene")
    add("smoothing", "smoothingModel none", "loose spheres", maps + solves,
        {"smoothing": "diffusion", "bandwidth": 1e-7}, {"smoothing": "none"},
        "a bandwidth that smooths nothing, against none")
    add("empty cells", "none", "loose spheres", maps, {"tube_height": 0.6, "layers": 48, "fill_height": 0.15},
        {"tube_height": 0.15, "layers": 12, "fill_height": 0.15}, _empty, of="scene")
    add("void-fraction updates", "keepMapping 0", "settled spheres", maps, {"keep_mapping": 0}, {}, _mapped)
    add("quiescent fluid", "quietFluid 0", "settled spheres", solves, {"quiet_fluid": 0}, {}, _quiet)
    add("resting bed", "rest=no", "settled spheres", dem, {"rest": "no"}, {}, _rest)
    add("resting bed", "rest=no", "settled clumps", dem, {"rest": "no"}, {}, _rest)
    return rows


# ---- measuring


def report(folder):
    """Both halves' reports of a run."""
    found = {}
    for half, path in (("dem", "DEM/dem.json"), ("cfd", "CFD/cfd.json")):
        with open(os.path.join(folder, path), encoding="utf-8") as f:
            found[half] = json.load(f)
    return found


def seconds(found, timing):
    """The sum of a report's times."""
    return sum(found[half][key] for half, _, key in (t.partition(".") for t in timing))


def empty_cells(folder):
    """(cells that hold nothing at the end, all cells)."""
    count = len(fields.centres(folder))
    n = fields.field(fields.times(folder)[-1][1], "voidfraction", count)
    return int((n > 1 - 1e-12).sum()), count


class Pairs:
    """Runs of all rows, each variant once a repeat, in turn."""

    def __init__(self, rows, repeats, tell, run=None):
        self.rows, self.repeats, self.tell = rows, repeats, tell
        self.run = run or (lambda v: bench_run.made(v.case, v.changes, "skips", edit=EDITS.get(v.edit), tag=v.edit))
        self.found, self.folders, self.broken = {}, {}, {}

    def go(self):
        """The rows of the table."""
        variants = {}
        for row in self.rows:  # a row's own two beside each other
            for v in (row.work, row.skip):
                variants.setdefault(v.key(), v)
        total, made = self.repeats * len(variants), 0
        for _ in range(self.repeats):
            for key, v in variants.items():
                made += 1
                if key in self.broken:
                    continue
                try:
                    self.folders[key] = self.run(v)
                    self.found.setdefault(key, []).append(report(self.folders[key]))
                except Broken as e:
                    self.broken[key] = str(e)
                what = " ".join([f"{k}={x}" for k, x in v.changes.items()] + [v.edit]).strip()
                self.tell(f"{made} of {total}: {v.case} {what}"
                          + (f": {self.broken[key]}" if key in self.broken else ""))
        return [self.row(r) for r in self.rows]

    def row(self, r):
        made = dict.fromkeys(COLUMNS)
        made.update(feature=r.feature, switch=r.switch, scene=r.scene, timing=" + ".join(r.timing))
        keys = r.work.key(), r.skip.key()
        wrong = next((self.broken[k] for k in keys if k in self.broken), None)
        if wrong:
            made["note"] = f"not measured: {wrong}"
            return made
        times = [[seconds(f, r.timing) for f in self.found[k]] for k in keys]
        work, skip = (dict(self.found[k][-1], seconds=statistics.median(t)) for k, t in zip(keys, times))
        if r.feature == "empty cells":
            for told, k in ((work, keys[0]), (skip, keys[1])):
                told["cells"] = empty_cells(self.folders[k])
        made.update(work_s=work["seconds"], skipped_s=skip["seconds"],
                    gain=statistics.median(a / b for a, b in zip(*times)),
                    error=error(*(self.folders[k] for k in keys)), error_of=r.of, note=r.note(work, skip))
        return made


def error(work, skip):
    """Of the curve without the work, from the one with it; 0 when the same to the bit."""
    curves = [os.path.join(f, "settling.csv") for f in (work, skip)]
    if filecmp.cmp(*curves, shallow=False):
        return 0.0
    return bench_curve.difference(bench_run.curve(skip), bench_run.curve(work))


def measure(quick, repeats, tell):
    return Pairs(plan(quick), repeats or (1 if quick else 3), tell).go()


def table(rows):
    lines = [f"{'feature':<29}{'switch':<33}{'scene':<17}{'work s':>8}{'skipped':>9}{'gain':>7}{'error %':>10}"]
    for r in rows:
        said = f"{r['feature']:<29}{r['switch']:<33}{r['scene']:<17}"
        if r["gain"] is not None:
            said += f"{r['work_s']:>8.3g}{r['skipped_s']:>9.3g}{r['gain']:>7.2f}{100 * r['error']:>10.2g}"
            if r["error_of"] == "scene" and r["error"] > 0:
                said += "  (another scene, not a skip's)"
        lines += [said.rstrip(), f"    {r['note']}"]
    return "\n".join(lines)
