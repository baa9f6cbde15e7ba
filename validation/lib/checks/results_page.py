# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The page of results: every case's table, pictures and notes, as HTML in
results/validation, and without pictures as validation/RESULTS.md."""

import json
import os
import re
import shutil
import time
from dataclasses import dataclass

from validation.lib.checks import verdicts

_MOST = 40  # rows of a case that are shown one by one; of more, those that failed
_BEGIN, _END = "<!-- last result -->", "<!-- end of last result -->"
_HEADS = ("quantity", "value", "reference", "error", "gate", "verdict")


@dataclass
class Result:
    """What a case that has just run has to say."""

    title: str
    checks: verdicts.Checks
    seconds: float


def write(folder, results, keep):
    """Adds results to those stored in `folder`/cases (all others are dropped
    unless keep) and writes the page of all; returns its path."""
    store = os.path.join(folder, "cases")
    if not keep:
        shutil.rmtree(store, ignore_errors=True)
    os.makedirs(store, exist_ok=True)
    for r in results:
        pictures = []
        for n, path in enumerate(r.checks.pictures):
            name = f"{r.checks.case}-{n + 1}.png"
            shutil.copyfile(path, os.path.join(store, name))
            pictures.append(name)
        with open(os.path.join(store, r.checks.case + ".json"), "w", encoding="utf-8") as f:
            json.dump({"title": r.title, "seconds": r.seconds, "when": time.strftime("%Y-%m-%d"),
                       "rows": [{k: verdicts.short(v) for k, v in row.items()} for row in r.checks.rows],
                       "notes": r.checks.notes, "pictures": pictures}, f, indent=1)
    cases = {}
    for name in sorted(os.listdir(store)):
        if name.endswith(".json"):
            with open(os.path.join(store, name), encoding="utf-8") as f:
                cases[name[:-5]] = json.load(f)
    path = os.path.join(folder, "index.html")
    with open(path, "w", encoding="utf-8") as f:
        f.write(_html(cases))
    return path


def _failed(case):
    return verdicts.failed(case["rows"])


def _shown(case):
    rows = case["rows"]
    return rows if len(rows) <= _MOST else _failed(case)


def _html(cases):
    """The page by its template; what a case says is escaped."""
    import jinja2  # which only checks need, not lists of them
    with open(os.path.splitext(__file__)[0] + ".html", encoding="utf-8") as f:
        template = jinja2.Environment(autoescape=True, undefined=jinja2.StrictUndefined).from_string(f.read())
    return template.render(heads=_HEADS, cases={
        name: {**case, "failed": _failed(case), "shown": _shown(case)} for name, case in cases.items()}) + "\n"


def _markdown(case):
    """A stored case's table and notes."""
    rows = [[r[k].replace("|", "/") for k in _HEADS] for r in _shown(case)]
    lines = [f"{case['when']}: {verdicts.count(case['rows'])}, {case['seconds']:.0f} s.", ""]
    if rows:
        lines += ["| " + " | ".join(_HEADS) + " |", "|" + "---|" * len(_HEADS)]
        lines += ["| " + " | ".join(r) + " |" for r in rows] + [""]
    return lines + [x for n in case["notes"] for x in (n, "")]


def _sections(path):
    """What a page of results says, by case; nothing where there is none."""
    try:
        with open(path, encoding="utf-8") as f:
            _, *parts = re.split(r"^## (.+)$", f.read(), flags=re.M)
    except FileNotFoundError:
        return {}
    return {name: text.strip("\n") for name, text in zip(parts[::2], parts[1::2])}


def record(folder, names, here, folders):
    """Writes each named case's last result into the README.md of its folder
    (folders: {name: path}), and all stored ones into RESULTS.md of `here`, which keeps
    what it says of others that there are."""
    store, path = os.path.join(folder, "cases"), os.path.join(here, "RESULTS.md")
    said = {name: text for name, text in _sections(path).items() if name in folders}
    for name in sorted(f[:-5] for f in os.listdir(store) if f.endswith(".json")):
        with open(os.path.join(store, name + ".json"), encoding="utf-8") as f:
            case = json.load(f)
        lines = _markdown(case)
        said[name] = "\n".join([case["title"] + ".", "", *lines]).rstrip()
        if name in names and name in folders:
            readme = os.path.join(folders[name], "README.md")
            with open(readme, encoding="utf-8") as f:
                old = f.read()
            block = "\n".join([_BEGIN, *lines[:-1], _END])
            new = re.sub(re.escape(_BEGIN) + r".*" + re.escape(_END), lambda _: block, old, flags=re.S)
            with open(readme, "w", encoding="utf-8") as f:
                f.write(new)
    with open(path, "w", encoding="utf-8") as f:
        f.write("# Last results of every validation case\n\n"
                "The last run of each, written by `validation/run --record`.\n")
        f.writelines(f"\n## {name}\n\n{said[name]}\n" for name in sorted(said))
