# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Settings KEY=VALUE of a command line: read, applied, and made to decide.

A parameter marked `followed` in case.json decides nothing by itself, only what
follows it by a word: solids the solid fraction, and that the number of clumps.
Where a follower holds a number of the case, it is made to follow; where it was
set to one as well, the setting is refused.

A parameter with `sets`, as accuracy, stands for values of others; what is set
by its own name wins. So do the keys that regime = stokes sets.
"""

import os

from cases.lib.case import places, regime
from cases.lib.case.casefile import text
from cases.lib.case.errors import CaseError


def split(setting, option="--set", form="KEY=VALUE"):
    """Key and value of one setting."""
    key, sign, value = (x.strip() for x in setting.partition("="))
    if not sign or not key:
        raise CaseError(f"{option} {setting}: must have the form {form}")
    return key, value


def read(settings, option="--set"):
    """The values by key; a key given again starts anew."""
    return dict(split(s, option) for s in settings)


def follow(case, given):
    """What has to follow so that each key of `given` decides, as {key: word}."""
    found = {}
    for key in given:
        if key not in case.parameters or not case.parameters[key].get("followed"):
            continue
        taken, decides, look = [], False, [key]
        while look:
            source = look.pop(0)
            for other, word in _followers(case, source):
                if other in given and given[other] != word:
                    taken.append(other)
                    continue
                if other not in given and case.values[other] != word:
                    found[other] = word
                if case.parameters[other].get("followed"):
                    look.append(other)
                else:
                    decides = True
        if taken and not decides:
            raise CaseError(f"{key} = {_shown(given[key])} decides nothing: "
                            f"{taken[0]} = {_shown(given[taken[0]])} is set, too")
    return found


def _followers(case, source):
    """Parameters that can follow `source`, each with the word that makes it."""
    for other, entry in case.parameters.items():
        words = entry.get("or", ())
        for word in words:
            if (words[word] if isinstance(words, dict) else word) == source:
                yield other, word


def _shown(value):
    return value if isinstance(value, str) else text(value)


def apply(case, given, tell=None):
    """Sets the values in the case; gives them with what follows, first. What
    follows is said in one line to tell."""
    for key, value in given.items():
        case.set(key, _shown(value))
    more = follow(case, given)
    for key, word in more.items():
        case.set(key, word)
    cells = _cells(case, given)
    for key, number in cells.items():
        case.set(key, str(number))
    of_regime = regime.values(case, given)
    for key, value in of_regime.items():
        case.set(key, _shown(value))
    more = {k: w for k, w in more.items() if k not in of_regime}
    stood_for = several(case, given)
    for key, value in stood_for.items():
        case.set(key, _shown(value))
    if of_regime and tell:
        tell(f"regime = {given['regime']} sets " + ", ".join(f"{k} = {_shown(v)}" for k, v in of_regime.items()))
    if stood_for and tell:
        tell("set, too: " + ", ".join(f"{k} = {_shown(v)}" for k, v in stood_for.items()))
    if more and tell:
        tell(said(more))
    if cells and tell:
        tell("the mesh follows: " + ", ".join(f"{k} = {n}" for k, n in cells.items()))
    return {**of_regime, **stood_for, **cells, **more, **given}


def _cells(case, given):
    """Numbers of cells (case.json: along, the length they lie along) that keep the cells' size where that length is
    given and they are not, as {key: number}."""
    found, changed = {}, case.changed()
    for key, entry in case.parameters.items():
        length = entry.get("along")
        if length in given and key not in given and length in changed:
            before, now = changed[length]
            number = max(1, round(case.values[key] * now / before))
            if number != case.values[key]:
                found[key] = number
    return found


def several(case, given):
    """What keys of `given` that stand for others (case.json: sets) make of
    those, as {key: value}; "*2" is twice what the case has."""
    found = {}
    for key, word in given.items():
        choices = case.parameters.get(key, {}).get("sets", {})
        for other, value in choices.get(word, {}).items():
            if other in given:
                continue
            if other not in case.values:
                raise CaseError(f"{key} = {word}: case {case.name} has no key {other} for it to set")
            if isinstance(value, str) and value.startswith("*"):
                value = float(value[1:]) * case.values[other]
                if case.parameters[other].get("whole"):
                    value = max(1, round(value))
            found[other] = value
    return found


def said(more):
    """What follows what, in a line."""
    return ", ".join(f"{key} follows: {word}" for key, word in more.items())


def path(out, *default):
    """The folder of --out, else that of the default in results."""
    if out is not None and not out.strip():  # a variable of a script that is not set
        raise CaseError(f"--out {out!r}: must name a folder")
    return os.path.abspath(os.path.join(places.base(), "results", *default) if out is None else out)


def folder(out, *default):
    """Likewise, and made if need be."""
    place = path(out, *default)
    if os.path.exists(place) and not os.path.isdir(place):
        raise CaseError(f"--out {place}: is a file; name a folder")
    try:
        os.makedirs(place, exist_ok=True)
    except OSError as e:
        raise CaseError(f"--out {place}: {e.strerror}; name another folder") from None
    if not os.access(place, os.W_OK | os.X_OK):
        raise CaseError(f"--out {place}: cannot be written to; name another folder")
    return place
