# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A case's parameters: case.json, changes on the command line, derived values."""

import glob
import json
import math
import os
import re

from cases.lib.case import suspension
from cases.lib.case.errors import CaseError, nearest

CASES = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TOP = os.path.dirname(CASES)
ROOMS = os.path.join(TOP, "validation")
# where a case's folder may be; the first holds those that cases/run lists
PLACES = (CASES, *sorted(glob.glob(os.path.join(glob.escape(ROOMS), "*"))))
HOLDS = "case.json"

# what every case has, and what each of it must be; case.json may ask for more
_NEEDED = {
    "end": {"above": 0},
    "dem_step": {"above": 0},
    "coupling_steps": {"min": 1, "whole": True},
    "frames": {"min": 1, "whole": True},
    "curve_rows": {"min": 1, "whole": True},
    "seed": {"min": 1, "whole": True},
}
_ENTRIES = ("value", "unit", "is", "choices", "or", "min", "max", "above", "below", "whole", "followed", "sets",
            "along")
_PARTS = ("title", "like", "limits", "set", "parameters", "calibrated")
_BOUNDS = ("min", "max", "above", "below")
_MOST_STEPS = 2**31 - 1  # LIGGGHTS counts the steps of a run in 32 bits


def names():
    """The cases there are: folders with a case.json that has a title, or that
    cannot be read; one without holds what other cases share."""
    def is_case(folder):
        try:
            return "title" in _read(folder)
        except CaseError:
            return True
    return sorted(name for name, folder in _folders(PLACES[:1]).items() if is_case(folder))


def _folders(places=None):
    """The folders with a case.json, {name: path}."""
    return {d: os.path.join(p, d) for p in reversed(places or PLACES) if os.path.isdir(p)
            for d in os.listdir(p) if os.path.isfile(os.path.join(p, d, HOLDS))}


def _of_ones_own(name):
    """The path that stands in place of a case's name, as ./my-case does; None of a name."""
    if os.sep not in name and name not in (".", ".."):
        return None
    folder = os.path.abspath(name)
    if not os.path.isfile(os.path.join(folder, HOLDS)):
        raise CaseError(f"{name}: is no case's folder; it lacks {HOLDS}")
    return folder


def _read(folder):
    """A folder's case.json."""
    path = os.path.join(folder, HOLDS)
    try:
        with open(path, encoding="utf-8") as f:
            found = json.load(f)
    except ValueError as e:
        raise CaseError(f"{path}: {e}") from None
    except RecursionError:
        raise CaseError(f"{path}: is nested too deep") from None
    except OSError as e:
        raise CaseError(f"{path}: {e.strerror}") from None
    if not isinstance(found, dict):
        raise CaseError(f"{path}: must be an object with {', '.join(_PARTS)}")
    for word in found:
        if word not in _PARTS:
            raise CaseError(f"{path}: {nearest(word, _PARTS, 'entry')}")
    for word, kind, what in (("title", str, "text"), ("like", str, "a case's name"), ("set", dict, "an object"),
                             ("limits", dict, "an object"), ("parameters", dict, "an object"),
                             ("calibrated", list, "a list of keys")):
        if word in found and not isinstance(found[word], kind):
            raise CaseError(f"{path}: {word}: must be {what}")
    return found


def _every(n, wanted):
    """How many of n between two outputs: near to what is wanted, and a divisor
    of n if one is near, so that the last state is written too."""
    near = [d for d in range(max(1, math.ceil(wanted / 2)), min(n, math.floor(2 * wanted)) + 1) if n % d == 0]
    return min(near, key=lambda d: abs(math.log(d / wanted))) if near else max(1, int(wanted))


class Case:
    """A case with the values of this run.

    name: one of names(), or the path of a folder that holds a case of one's own; cases beside it are
    known to it, too. reference: what stands for the case in a command, wherever that is given.
    values: what case.json names, as changed; derived: what follows from them.
    """

    def __init__(self, name):
        own = _of_ones_own(name)
        folder = own or _folders().get(name)
        if folder is None or not own and "title" not in _read(folder):
            here = f"; ./{name} is the one here" if os.path.isfile(os.path.join(name, HOLDS)) else ""
            raise CaseError(nearest(name, names(), "case") + here)
        self.name, self.reference = os.path.basename(folder), own or name
        self._known = {**(_folders((os.path.dirname(own),)) if own else {}), **_folders()}
        self.folders = []  # of the cases this one is like, the remotest first, its own last
        self.parameters, self.values, self.calibrated = {}, {}, ()
        self._load(folder, [])
        path = os.path.join(folder, HOLDS)
        self.title = _read(folder).get("title", self.name)
        self._own = dict(self.values)
        for key in _NEEDED:
            if key not in self.values:
                raise CaseError(f"{path}: the parameter '{key}' is missing; every case has it")

    def _load(self, folder, below):
        """Takes over what the case of a folder says, after all that it is like."""
        path = os.path.join(folder, HOLDS)
        found = _read(folder)
        if "like" in found:
            other = found["like"]
            if other not in self._known:
                raise CaseError(f"{path}: like: {nearest(other, list(self._known), 'case')}")
            if self._known[other] in below + [folder]:
                raise CaseError(f"{path}: like = {other}: a case cannot be like itself")
            self._load(self._known[other], below + [folder])
        self.folders.append(folder)
        try:
            for key, entry in found.get("parameters", {}).items():
                for word in entry:
                    if word not in _ENTRIES:
                        raise CaseError(f"{key}: {nearest(word, _ENTRIES, 'entry')}")
                for word in ("is", "value"):
                    if word not in entry:
                        raise CaseError(f"{key}: the entry '{word}' is missing")
                self.parameters[key] = dict(entry)
                self.values[key] = entry["value"]
                self._check(key, entry["value"], entry["value"])
                self._check_sets(key, entry)
            for key, bounds in found.get("limits", {}).items():
                if key not in self.values:
                    raise CaseError(f"limits: {nearest(key, list(self.values), 'key')}")
                for word in bounds:
                    if word not in _BOUNDS:
                        raise CaseError(f"limits: {key}: {nearest(word, _BOUNDS, 'entry')}")
                for word in _BOUNDS if bounds else ():
                    self.parameters[key].pop(word, None)
                self.parameters[key].update(bounds)
            for key, value in found.get("set", {}).items():
                if key not in self.values:
                    raise CaseError(f"set: {nearest(key, list(self.values), 'key')}")
                if "sets" in self.parameters[key]:
                    raise CaseError(f"set: {key} stands for other keys; set those")
                self._check(key, value, value)
                self.values[key] = value
            for key in found.get("calibrated", ()):
                if key not in self.values:
                    raise CaseError(f"calibrated: {nearest(key, list(self.values), 'key')}")
            self.calibrated = found.get("calibrated", self.calibrated)
        except CaseError as e:
            raise CaseError(f"{path}: {e}") from None
        except (TypeError, AttributeError, OverflowError) as e:
            raise CaseError(f"{path}: {e}") from None

    @staticmethod
    def _check_sets(key, entry):
        """Refuses an entry `sets` that is not {choice: {key: value}} of all choices."""
        if "sets" not in entry:
            return
        if sorted(entry["sets"]) != sorted(entry.get("choices", [])) or entry["sets"][entry["value"]]:
            raise CaseError(f"{key}: sets: must hold an object for each of the choices, "
                            f"an empty one for {entry['value']}")

    def _check(self, key, value, shown):
        """Refuses a value that is not what its entry in case.json asks for."""
        entry = {**_NEEDED.get(key, {}), **self.parameters[key]}
        if value in entry.get("or", ()):
            return
        if "choices" in entry:
            good = value in entry["choices"]
            wanted = "one of " + ", ".join(str(c) for c in entry["choices"])
        elif isinstance(entry["value"], str) and "or" not in entry and key not in _NEEDED:
            good = isinstance(value, str) and re.fullmatch(r"[\w.+-]+", value)
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
            if "min" in entry and "max" in entry:
                wanted += f" from {text(entry['min'])} to {text(entry['max'])}"
            elif limits:
                wanted += " " + " and ".join(f"{words} {text(at)}" for at, words, _ in limits)
            if limits and entry.get("unit", "1") != "1":
                wanted += f" {entry['unit']}"
            if "or" in entry:
                wanted += ", or " + " or ".join(entry["or"])
        if not good:
            raise CaseError(f"{key} = {shown}: must be {wanted} ({entry['is']})")

    def set(self, key, text):
        """Takes a changed value; its type is that of the value in case.json."""
        if key not in self.values:
            raise CaseError(nearest(key, list(self.values), f"key of case {self.name}"))
        entry = self.parameters[key]
        words = entry.get("or", ())
        value = text
        if text not in words and (words or not isinstance(entry["value"], str)):
            try:
                value = float(text)
            except ValueError:
                wanted = " or ".join(["a number", *words])
                raise CaseError(f"{key} = {text}: must be {wanted} ({entry['is']})") from None
        self._check(key, value, text)
        if entry.get("whole") and not isinstance(value, str):
            value = int(value)
        self.values[key] = value

    def changed(self):
        """What the values of this run are that are not the case's own, {key: (case's, run's)}."""
        return {k: (self._own[k], v) for k, v in self.values.items() if v != self._own[k]}

    def idle(self):
        """Keys whose values decide nothing here, since none follows them by their word, with what decides in their
        place: {"solids": "clumps"}."""
        found = {}
        for key in self.parameters:
            if self.parameters[key].get("followed"):
                deciding = self._deciding(key)
                if deciding:
                    found[key] = deciding
        return found

    def _deciding(self, key):
        """Of a followed key, the parameter that is set to a value instead of following it; None if one follows."""
        instead = None
        for other, entry in self.parameters.items():
            words = entry.get("or", ())
            word = next((w for w in words if (words[w] if isinstance(words, dict) else w) == key), None)
            if word is None:
                continue
            taken = other if self.values[other] != word else (
                self._deciding(other) if entry.get("followed") else None)
            if taken is None:
                return None
            instead = instead or taken
        return instead

    def derive(self, dem_ranks, cfd_ranks):
        """What both halves' input needs besides: counts of steps, numbers for words."""
        try:
            return self._derive(dem_ranks, cfd_ranks)
        except ArithmeticError as e:
            raise CaseError(f"the case's values do not fit together: {e}") from None

    def _derive(self, dem_ranks, cfd_ranks):
        v = self.values
        if v["end"] / v["dem_step"] > _MOST_STEPS:
            raise CaseError(f"end = {v['end']} s: must be at most {_MOST_STEPS} steps of dem_step = {v['dem_step']} s")
        steps = round(v["end"] / v["dem_step"])
        if abs(steps * v["dem_step"] - v["end"]) > 1e-6 * v["end"]:
            raise CaseError(f"end = {v['end']} s: must be a multiple of dem_step = {v['dem_step']} s")
        every = int(v["coupling_steps"])
        frame = every * _every(max(1, steps // every), steps / v["frames"] / every)
        profile = {}
        if "profile_rows" in v:
            # at exchanges, where both halves are at the same time
            wanted = max(steps / 200, 1500) if v["profile_rows"] == "auto" else steps / v["profile_rows"]
            exchanges = max(1, steps // every)
            profile_steps = every * _every(exchanges, min(exchanges, wanted / every))
            profile = {"profile_steps": profile_steps, "profile_time": v["dem_step"] * profile_steps}
        return {
            **suspension.resolve(v),
            "steps": steps,
            "coupling_time": v["dem_step"] * every,
            "frame_steps": frame,
            "frame_time": v["dem_step"] * frame,
            "curve_steps": _every(steps, steps / v["curve_rows"]),
            **profile,
            "dem_ranks": dem_ranks,
            "cfd_ranks": cfd_ranks,
            "neighbour_skin": min(1e-3, 2 * v["sphere_radius"]),
            "prime_seed": prime_seed(int(v["seed"])),
        }

    def table(self):
        """The parameters, one a line, in columns that keep apart."""
        rows, idle = [], self.idle()
        for key, p in self.parameters.items():
            value = "-" if key in idle else text(self.values[key])
            more = f" (decides nothing here: {idle[key]} = {text(self.values[idle[key]])})" if key in idle else ""
            rows.append((key, value, p.get("unit", "|".join(p.get("choices", []))), p["is"] + more))
        wide = [max(len(r[c]) for r in rows) for c in range(3)]
        return "\n".join("  " + "  ".join(r[c].ljust(wide[c]) for c in range(3)) + "  " + r[3] for r in rows)


def prime_seed(seed):
    """A prime above 10000, as LIGGGHTS's random numbers want it: another one for each small seed."""
    number = 10007 + 2 * (37 * seed % 1_000_000_000)
    while any(number % k == 0 for k in range(3, math.isqrt(number) + 1, 2)):
        number += 2
    return number


def text(value):
    """A value as both halves read it."""
    return value if isinstance(value, str) else f"{value:.12g}"
