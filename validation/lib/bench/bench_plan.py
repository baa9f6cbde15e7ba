# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What validation/bench varies, one setting at a time from what is shipped."""

import math

CASES = ("clump-half", "sphere-half")
WINDOW = {"full": 0.5, "quick": 0.03}  # [s] simulated
# meshes: core cells, ring cells, layers
_MESHES = {"coarse": (3, 1, 8), "fine": (5, 3, 16), "finer": (6, 4, 24)}


def stiffer(values, factor):
    """A stiffness times the factor, with the DEM step that goes with it; the
    coupling interval stays."""
    parts = max(1, math.ceil(math.sqrt(factor) - 1e-9))
    return {"stiffness": values["stiffness"] * factor, "dem_step": float(f"{values['dem_step'] / parts:.12g}"),
            "coupling_steps": int(values["coupling_steps"]) * parts}


def finer_step(values, parts):
    """A DEM step of about that part, at the same coupling interval."""
    every = max(1, round(values["coupling_steps"] * parts))
    return {"dem_step": float(f"{values['dem_step'] * values['coupling_steps'] / every:.12g}"), "coupling_steps": every}


def interval(values, factor, window):
    """Steps of a coupling interval near that many times as long, of which the window [s] is a whole number."""
    steps, wanted = round(window / values["dem_step"]), values["coupling_steps"] * factor
    whole = [n for n in range(1, int(2 * wanted) + 2) if steps % n == 0]
    return min(whole, key=lambda n: abs(math.log(n / wanted)))


def settings(values, quick=False):
    """Of a case with these values: (setting, value, changes) of each point."""
    found = []

    def add(setting, value, changes):
        found.append((setting, value, changes))

    for parts in (2,) if quick else (0.8, 2, 4):
        step = finer_step(values, parts)
        add("dem_step", step["dem_step"], step)
    for factor in (4,) if quick else (0.25, 0.5, 4, 25, 100):
        add("stiffness", values["stiffness"] * factor, stiffer(values, factor))
    for factor in (0.2, 2) if quick else (0.2, 0.4, 2, 4, 8):
        every = interval(values, factor, WINDOW["quick" if quick else "full"])
        add("coupling_steps", every, {"coupling_steps": every})
    if "cutoff" in values:
        for factor in (0.5,) if quick else (0.33, 0.5, 0.75, 1.5):
            add("cutoff", values["cutoff"] * factor, {"cutoff": values["cutoff"] * factor})
        for every in (1,) if quick else (1, 5, 10, 50):
            if every != values["coulomb_steps"]:
                add("coulomb_steps", every, {"coulomb_steps": every})
    other = "no" if values["overlap"] == "yes" else "yes"
    add("overlap", other, {"overlap": other})
    for scheme in ("centre",) if quick else ("divided", "centre", "exactOverlap"):
        if scheme != values["void_fraction"]:
            add("void_fraction", scheme, {"void_fraction": scheme})
    for name in ("coarse",) if quick else _MESHES:
        add("mesh", name, dict(zip(("core_cells", "ring_cells", "layers"), _MESHES[name])))
    for tolerance in (1e-6,) if quick else (1e-4, 1e-6, 1e-10):
        add("tolerance", tolerance, {"tolerance": tolerance})
    for setting, value in (("rest", "no"), ("answer_lag", "0"), ("quiet_fluid", 0.0)):
        if setting in values and values[setting] != value:
            add(setting, value, {setting: value})
    add("accuracy", "fast", {"accuracy": "fast"})
    return found


def reference(values):
    """The paper's stiffness with a step that resolves it; every force at every
    step, the fluid every 0.05 ms, and nothing skipped."""
    step = 2.5e-7
    found = {"accuracy": "reference", "dem_step": step, "coupling_steps": round(5e-5 / step)}
    exact = {"rest": "no", "answer_lag": "0", "quiet_fluid": 0.0, "keep_mapping": 0.0}
    found.update({k: v for k, v in exact.items() if k in values})
    return found
