# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""report.html: a run on one page that needs no other file."""

import base64
import os

import numpy as np

from cases.lib.case import casefile, files, heading
from cases.lib.case.errors import CaseError
from cases.lib.page import page_pictures
from cases.lib.run import report, runs

NAME = "report.html"
# pictures that a run has made, with their captions
_MADE = (("columns.png", "The column at times that tell most: particles, and the flow in the plane y = 0."),
         ("bed.png", "Pressure drop and bed height against the superficial velocity, with Ergun's equation."))


def _settings(case):
    """Rows of what differs from the case (key, case's, run's, unit, meaning), and of all others (key, value, ...)."""
    changed, idle = case.changed(), case.idle()

    def rest(key):
        entry = case.parameters[key]
        return entry.get("unit", "") if entry.get("unit") not in ("1", "name") else "", entry["is"]
    differ = [(k, casefile.text(a), casefile.text(b), *rest(k)) for k, (a, b) in changed.items() if k not in idle]
    same = [(k, casefile.text(v), *rest(k)) for k, v in case.values.items() if k not in changed and k not in idle]
    return differ, same


def _stage_rows(found):
    """Rows of stages: from, to [s], slope with its interval [mm/s]."""
    ends = [found.start, *found.breaks, None]
    return [(f"{k + 1}", f"{ends[k]:.4g}", "the end" if ends[k + 1] is None else f"{ends[k + 1]:.4g}",
             f"{1e3 * s:.4g}", f"{1e3 * low:.4g} to {1e3 * high:.4g}")
            for k, (s, (low, high)) in enumerate(zip(found.slopes, found.slopes_ci))]


def _measured(summary):
    """Rows of times and accuracy, as the table of cases/report has them."""
    return [(line[:16].strip(), line[16:].strip()) for line in report.table(summary).splitlines()]


def _pictures(folder, case, values, curve, found, torn):
    """(caption, PNG) of all there are."""
    shown = []
    if curve is not None:
        column = page_pictures.theory(case.name, values)
        told = "" if column is None else ", and Kynch's theory with the flux of the run's drag law, nothing fitted"
        shown.append((f"The upper interface with the stages found in it{told}.",
                      page_pictures.settling(curve, found, column)))
    for name, caption in _MADE:
        path = os.path.join(folder, name)
        if os.path.isfile(path):
            with open(path, "rb") as f:
                shown.append((caption, f.read()))
    if curve is not None:
        profiles = page_pictures.profiles(folder, values, torn)
        if profiles:
            shown.append(("Solid fraction over height.", profiles))
    return [(caption, base64.b64encode(png).decode()) for caption, png in shown]


def write(folder, case, derived, summary):
    """Writes the page of a run into its folder; returns its path."""
    import jinja2
    torn = not summary["complete"]
    values = {**case.values, **derived}
    try:
        curve = runs.curve(folder)
    except (CaseError, OSError):
        curve = None
    if curve is not None:  # rows of a run that was stopped may be torn
        whole = np.all([np.isfinite(c) for c in curve.values()], axis=0)
        curve = {k: c[whole] for k, c in curve.items()} if whole.sum() > 1 else None
    found = page_pictures.stages(curve) if curve is not None else None
    differ, same = _settings(case)
    with open(os.path.splitext(__file__)[0] + ".html", encoding="utf-8") as f:
        template = jinja2.Environment(autoescape=True, undefined=jinja2.StrictUndefined).from_string(f.read())
    path = os.path.join(folder, NAME)
    with files.writing(path) as f:
        f.write(template.render(
            title=heading.of(case, derived), case=case.reference, summary=summary, differ=differ, same=same,
            measured=_measured(summary), stages=_stage_rows(found) if found is not None else [],
            pictures=_pictures(folder, case, values, curve, found, torn)) + "\n")
    return path
