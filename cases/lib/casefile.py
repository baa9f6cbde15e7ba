# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A case's parameters: case.json, changes on the command line, derived values."""

import difflib
import json
import math
import os

CASES = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
TOP = os.path.dirname(CASES)


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
    near = [d for d in range(1, n + 1) if n % d == 0 and wanted / 2 <= d <= 2 * wanted]
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
        except (ValueError, KeyError) as e:
            raise CaseError(f"{path}: {e}") from None
        for key in ("end", "dem_step", "coupling_steps", "frames", "curve_rows", "seed"):
            if key not in self.values:
                raise CaseError(f"{path}: the parameter '{key}' is missing; every case has it")

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
            if isinstance(old, int) and value == int(value):
                value = int(value)
        if value not in entry.get("choices", [value]):
            raise CaseError(f"{key} = {text}: one of {', '.join(entry['choices'])} is wanted")
        self.values[key] = value

    def derive(self, dem_ranks, cfd_ranks):
        """What both halves' input needs besides: counts of steps."""
        v = self.values
        for key in ("end", "dem_step", "coupling_steps", "frames", "curve_rows", "seed"):
            if not v[key] > 0:
                raise CaseError(f"{key} = {v[key]}: a number above 0 is wanted ({self.parameters[key]['is']})")
        for key in ("coupling_steps", "frames", "curve_rows", "seed"):
            if v[key] != int(v[key]):
                raise CaseError(f"{key} = {v[key]}: a whole number is wanted ({self.parameters[key]['is']})")
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
