# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What a check can ask: every question becomes a row with its verdict."""

import csv
import json
import math

_VERDICTS = {True: "pass", False: "FAIL", None: "skip"}
COLUMNS = ("case", "quantity", "value", "reference", "error", "gate", "verdict")


class Broken(Exception):
    """A check that cannot go on; its text is one line."""


class Checks:
    """The rows of one validation case."""

    def __init__(self, case, tell, parts=(), long=False):
        """parts: of a check that has PARTS, those asked for, all when empty; long: its long ones, too."""
        self.case, self.tell, self.rows = case, tell, []
        self.parts, self.long = parts, long
        self.pictures, self.notes = [], []

    def picture(self, path):
        """A picture of this case, for the page of results."""
        self.pictures.append(path)

    def note(self, text):
        """A line for the page of results, such as why a gate is not met."""
        self.notes.append(text)

    def _row(self, quantity, value, reference, error, gate, passed):
        row = dict(zip(COLUMNS, (self.case, quantity, value, reference, error, gate,
                                 _VERDICTS[passed])))
        self.rows.append(row)
        self.tell(row)
        return passed

    def at_most(self, quantity, value, gate):
        """A measure that must not exceed its gate."""
        good = value is not None and math.isfinite(value) and value <= gate
        return self._row(quantity, value, None, value, gate, good)

    def at_least(self, quantity, value, gate):
        good = value is not None and math.isfinite(value) and value >= gate
        return self._row(quantity, value, None, value, f">= {gate:g}", good)

    def close(self, quantity, value, reference, gate, relative=True):
        """A value within a relative (or absolute) distance of a reference."""
        error = abs(value - reference)
        if relative and reference:
            error /= abs(reference)
        return self._row(quantity, value, reference, error, gate, math.isfinite(error) and error <= gate)

    def equal(self, quantity, value, reference):
        return self._row(quantity, value, reference, None, "equal", value == reference)

    def true(self, quantity, passed, value="", reference=""):
        """A yes-or-no question; value says what was found."""
        return self._row(quantity, value, reference, None, "true", bool(passed))

    def skipped(self, quantity, why):
        """A question that cannot be asked here; neither passed nor failed."""
        return self._row(quantity, why, None, None, "true", None)


def failed(rows):
    return [r for r in rows if r["verdict"] == "FAIL"]


def count(rows):
    """How many rows passed, failed and, if any, were skipped."""
    skipped = sum(r["verdict"] == "skip" for r in rows)
    bad = len(failed(rows))
    return f"{len(rows) - bad - skipped} passed, {bad} failed" + (f", {skipped} skipped" if skipped else "")


def short(value):
    """A value for the table."""
    if value is None:
        return ""
    if isinstance(value, float):
        return f"{value:.4g}"
    return str(value)


def line(row):
    """A row of the table; a failed one says all it knows, a skipped one why."""
    said = f"{row['verdict']:<5}{row['case']:<21}{row['quantity']:<60}"
    value, reference = short(row["value"]), short(row["reference"])
    if row["verdict"] == "skip":
        return f"{said} {value}"
    if row["verdict"] != "pass":
        against = f", reference {reference}" if reference else ""
        return f"{said}\n     found {value}; gate {row['gate']}{against}".rstrip()
    return f"{said} {value[:14]:<14} {reference[:14]:<14} {short(row['error']):<11}{short(row['gate'])}".rstrip()


def write_csv(path, rows):
    with open(path, "w", encoding="utf-8", newline="") as f:
        out = csv.DictWriter(f, COLUMNS, lineterminator="\n")
        out.writeheader()
        out.writerows(rows)


def plain(row):
    """A row as JSON has it: passed instead of the verdict (null when skipped), nothing that is not a finite number."""
    row = {k: None if isinstance(v, float) and not math.isfinite(v) else v for k, v in row.items()}
    passed = None if row["verdict"] == "skip" else row["verdict"] == "pass"
    return {**{k: row[k] for k in COLUMNS[:-1]}, "passed": passed}


def write_json(path, rows):
    """A list of objects: case, quantity, value, reference, error, gate, passed."""
    with open(path, "w", encoding="utf-8") as f:
        json.dump([plain(r) for r in rows], f, indent=2, default=float)
        f.write("\n")
