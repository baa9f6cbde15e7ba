# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What was tried already: a line of JSON each, so that a long table can be taken up again."""

import hashlib
import json
import os

from cases.lib.run import runkey
from cases.lib.case import files
from cases.lib.case.casefile import TOP


def version():
    """A hash of the programs and of the Python parts that a run is made by."""
    parts = sorted(runkey.programs().items())
    for folder, _, names in sorted(os.walk(os.path.join(TOP, "cases"))):
        for name in sorted(names):
            if name.endswith((".py", ".json")):
                with open(os.path.join(folder, name), "rb") as f:
                    parts.append((name, hashlib.sha256(f.read()).hexdigest()))
    return hashlib.sha256(repr(parts).encode()).hexdigest()[:16]


def parted(words):
    """{part: (number, of how many shares)} of words as `kills`, (1, 1), or `kills:2/3`."""
    found = {}
    for word in words:
        name, _, share = word.partition(":")
        number, _, count = share.partition("/") if share else ("1", "", "1")
        if not (number.isdecimal() and count.isdecimal() and 1 <= int(number) <= int(count)):
            raise ValueError(f"--part {word}: a share is as {name}:2/3, the second of three")
        found[name] = int(number), int(count)
    return found


class Tries:
    """Outcomes by what was tried, kept in a file; those of other versions count for nothing. share: (number, of how
    many), where several processes do a table side by side."""

    def __init__(self, path, of, share=(1, 1)):
        self.path, self.of, self.share, self.known = path, of, share, {}
        try:
            with open(path, encoding="utf-8") as f:
                for line in f:
                    if not line.endswith("\n"):
                        continue
                    row = json.loads(line)
                    if row["version"] == of:
                        self.known[row["what"]] = row["wrong"]
        except (OSError, ValueError, KeyError, TypeError):
            pass  # what cannot be read is tried again

    def mine(self, trials):
        """Those of its share."""
        number, count = self.share
        return list(trials)[number - 1::count]

    def place(self, folder):
        """A folder that no other share uses."""
        return folder if self.share[1] == 1 else f"{folder}-{self.share[0]}"

    def kept(self, name, make):
        """A result of these programs that tries are compared with, and what was wrong, "" for nothing: kept in a file
        where nothing was, else make()'s."""
        path = os.path.join(os.path.dirname(self.path), f"{name}-{self.of}.json")
        try:
            with open(path, encoding="utf-8") as f:
                return json.load(f), ""
        except (OSError, ValueError):
            pass  # it is made anew
        found, wrong = make()
        if not wrong:
            with files.writing(path) as f:
                json.dump(found, f)
        return found, wrong

    def outcome(self, what, attempt):
        """What was wrong with a try, "" for nothing: as it was found before, else by attempt(). What
        went wrong before is tried again."""
        if self.known.get(what, "?") != "":
            self.known[what] = attempt()
            with open(self.path, "a", encoding="utf-8") as f:
                f.write(json.dumps({"version": self.of, "what": what, "wrong": self.known[what]}) + "\n")
        return self.known[what]
