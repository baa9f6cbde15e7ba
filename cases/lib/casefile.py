# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A case's parameters: case.json, changes on the command line, derived values."""

import difflib
import json
import math
import os
import re

CASES = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
TOP = os.path.dirname(CASES)

# what every case has, and what each of it must be; case.json may ask for more
_NEEDED = {
    "end": {"above": 0},
    "dem_step": {"above": 0},
    "coupling_steps": {"min": 1, "whole": True},
    "frames": {"min": 1, "whole": True},
    "curve_rows": {"min": 1, "whole": True},
    "seed": {"min": 1, "whole": True},
}
_ENTRIES = ("value", "unit", "is", "choices", "min", "max", "above", "below", "whole")
_MOST_STEPS = 2**31 - 1  # LIGGGHTS counts the steps of a run in 32 bits


class CaseError(Exception):
    """Something the user can mend; its text is one line."""


def nearest(word, known, what):
    """The sentence that refuses an unknown word."""
    close = difflib.get_close_matches(word, known, 1, 0.4)
    hint = f"did you mean '{close[0]}'?" if close else "known are " + ", ".join(sorted(known))
    return f"unknown {what} '{word}'; {hint}"


def names():
    """The cases there are: folders with a case.json."""
    return sorted(d for d in os.listdir(CASES) if os.path.isfile(os.path.join(CASES, d, "case.json")))


def _every(n, wanted):
    """How many of n between two outputs: near to what is wanted, and a divisor
    of n if one is near, so that the last state is written too."""
    near = [d for d in range(max(1, math.ceil(wanted / 2)), min(n, math.floor(2 * wanted)) + 1) if n % d == 0]
    return min(near, key=lambda d: abs(math.log(d / wanted))) if near else max(1, int(wanted))


class Case:
    """A case with the values of this run.

    values: what case.json names, as changed; derived: what follows from them.
    """

    def __init__(self, name):
        known = names()
        if name not in known:
            raise CaseError(nearest(name, known, "case"))
        self.name = name
        self.folder = os.path.join(CASES, name)
        path = os.path.join(self.folder, "case.json")
        try:
            with open(path, encoding="utf-8") as f:
                text = json.load(f)
            self.title = text["title"]
            self.parameters = text["parameters"]
            self.values = {k: p["value"] for k, p in self.parameters.items()}
        except KeyError as e:
            raise CaseError(f"{path}: the entry {e} is missing") from None
        except (ValueError, TypeError, AttributeError) as e:
            raise CaseError(f"{path}: {e}") from None
        for key in _NEEDED:
            if key not in self.values:
                raise CaseError(f"{path}: the parameter '{key}' is missing; every case has it")
        for key, entry in self.parameters.items():
            for word in entry:
                if word not in _ENTRIES:
                    raise CaseError(f"{path}: {key}: {nearest(word, _ENTRIES, 'entry')}")
            if "is" not in entry:
                raise CaseError(f"{path}: {key}: the entry 'is', what it stands for, is missing")
            try:
                self._check(key, self.values[key], self.values[key])
            except CaseError as e:
                raise CaseError(f"{path}: {e}") from None

    def _check(self, key, value, shown):
        """Refuses a value that is not what its entry in case.json asks for."""
        entry = {**_NEEDED.get(key, {}), **self.parameters[key]}
        if "choices" in entry:
            good = value in entry["choices"]
            wanted = "one of " + ", ".join(str(c) for c in entry["choices"])
        elif isinstance(value, str):
            good = re.fullmatch(r"[\w.+-]+", value)
            wanted = "a single word"
        else:
            limits = [(entry[k], words, holds) for k, words, holds in (
                ("min", "of at least", lambda a, b: a >= b), ("above", "above", lambda a, b: a > b),
                ("max", "of at most", lambda a, b: a <= b), ("below", "below", lambda a, b: a < b))
                if k in entry]
            good = (isinstance(value, (int, float)) and not isinstance(value, bool)
                    and math.isfinite(value) and all(holds(value, at) for at, _, holds in limits)
                    and not (entry.get("whole") and value != int(value)))
            wanted = "a whole number" if entry.get("whole") else "a finite number"
            if limits:
                wanted += " " + " and ".join(f"{words} {text(at)}" for at, words, _ in limits)
        if not good:
            raise CaseError(f"{key} = {shown}: {wanted} is wanted ({entry['is']})")

    def set(self, key, text):
        """Takes a changed value; its type is that of the value in case.json."""
        if key not in self.values:
            raise CaseError(nearest(key, list(self.values), f"key of case {self.name}"))
        entry, old = self.parameters[key], self.parameters[key]["value"]
        value = text
        if not isinstance(old, str):
            try:
                value = float(text)
            except ValueError:
                raise CaseError(f"{key} = {text}: a number is wanted ({entry['is']})") from None
        self._check(key, value, text)
        if isinstance(old, int) and value == int(value):
            value = int(value)
        self.values[key] = value

    def derive(self, dem_ranks, cfd_ranks):
        """What both halves' input needs besides: counts of steps."""
        v = self.values
        if v["end"] / v["dem_step"] > _MOST_STEPS:
            raise CaseError(f"end = {v['end']} s: at most {_MOST_STEPS} steps of dem_step = {v['dem_step']} s are wanted")
        steps = round(v["end"] / v["dem_step"])
        if abs(steps * v["dem_step"] - v["end"]) > 1e-6 * v["end"]:
            raise CaseError(f"end = {v['end']} s is no multiple of dem_step = {v['dem_step']} s")
        every = int(v["coupling_steps"])
        frame = every * _every(max(1, steps // every), steps / v["frames"] / every)
        return {
            "steps": steps,
            "coupling_time": v["dem_step"] * every,
            "frame_steps": frame,
            "frame_time": v["dem_step"] * frame,
            "curve_steps": _every(steps, steps / v["curve_rows"]),
            "dem_ranks": dem_ranks,
            "cfd_ranks": cfd_ranks,
        }

    def table(self):
        """The parameters, one a line."""
        rows = []
        for key, p in self.parameters.items():
            unit = p.get("unit", "|".join(p.get("choices", [])))
            rows.append(f"  {key:<16}{text(self.values[key]):<14}{unit:<12}{p['is']}")
        return "\n".join(rows)


def text(value):
    """A value as both halves read it."""
    return value if isinstance(value, str) else f"{value:.12g}"
