# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What the user can mend, said in one line."""

import difflib


class CaseError(Exception):
    """Something the user can mend; its text is one line."""


def nearest(word, known, what):
    """The sentence that refuses an unknown word."""
    close = difflib.get_close_matches(word, known, 1, 0.4)
    hint = f"did you mean '{close[0]}'?" if close else "known are " + ", ".join(sorted(known))
    return f"unknown {what} '{word}'; {hint}"
