# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Command lines with something wrong in them, or odd and yet right, drawn from a seed."""

import random

from cases.lib.case.casefile import Case
from cases.lib.case.errors import CaseError

CASES = ("clump-half", "sphere-half", "rp-04a", "column1890", "ergun-bed", "fluidised-bed", "clump-full")
_WORDS = ("", " ", "nan", "inf", "-inf", "0", "-0", "-1", "1e-300", "1e308", "1e400", "1e9", "1e5", "1e-9", "0x10",
          "1_0", "1,5", "2.5", "yes", "no", "none", "auto",
          "water", "solids", "solid_fraction", "True", "[]", "{}", "$x",
          ";", "\u00e9", "1 2",
          "../x", "-h", "9" * 400, "e", ".", "1e", "random", "A", "hex", "open")


def _value(rng, case, key):
    """A value for a key: a word from the list, or the case's own in another unit, or next to a bound."""
    entry, now = case.parameters[key], case.values[key]
    draw = rng.random()
    if isinstance(now, (int, float)) and draw < 0.45:
        return repr(now * rng.choice([1e3, 1e-3, 100, 0.01, -1, 0, 1.0000001, 2, 0.5, 10, 0.1, 1e6, 1e-6]))
    bounds = [entry[b] for b in ("min", "max", "above", "below") if b in entry]
    if bounds and draw < 0.65:
        return repr(rng.choice(bounds) * rng.choice([1, 1, 0.999999, 1.000001]))
    if "choices" in entry and draw < 0.75:
        return str(rng.choice(entry["choices"]))
    return rng.choice(_WORDS)


def _key(rng, case):
    """A key, at times with a letter missing."""
    key = rng.choice(sorted(case.parameters))
    if rng.random() < 0.04:
        at = rng.randrange(len(key))
        return key, key[:at] + key[at + 1:]
    return key, key


def words(number, seed=1):
    """The words behind cases/run of one input. Where the end is not among what is changed, it is two exchanges."""
    rng = random.Random(f"{seed} {number}")
    name = rng.choice(CASES)
    case = Case(name)
    found, changed = [name], set()
    for _ in range(rng.choice([1, 1, 1, 2, 3])):
        key, said = _key(rng, case)
        value = _value(rng, case, key)
        changed.add(said)
        found += ["--set", rng.choice([f"{said}={value}"] * 12 + [said, f"={value}", f"{said}=={value}"])]
        try:
            case.set(said, value)
        except CaseError:
            pass
    if rng.random() < 0.1:
        found += [rng.choice(["--dem", "--cfd"]), rng.choice(["0", "-1", "2", "3", "1000", "x", "1.5", ""])]
    if not changed & {"end", "dem_step", "coupling_steps"}:
        found += ["--end", repr(2 * case.values["dem_step"] * case.values["coupling_steps"])]
    elif "end" not in changed:
        v = case.values
        found += ["--end", repr(2 * v["dem_step"] * v["coupling_steps"])]
    return found
