# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The targets of speed and what is reached: validation/bench targets.

Every measurement is a function that gives (measured, note); Missing says that
the case or the switch it wants is not there.
"""

import json
import os
import re

from cases.lib.case import casefile
from validation.lib.bench import bench_run
from validation.lib.checks.verdicts import Broken

COLUMNS = ("target", "measured", "gate", "passed", "note")


class Missing(Exception):
    """What a measurement wants is not there; its text says what."""


class Measurements:
    """The measurements, each made once; quick: of short windows, which say
    little; full: of the whole 64 s."""

    def __init__(self, quick, full):
        self.quick, self.full, self._kept = quick, full, {}

    # ---- the column of 1890 spheres

    def _column(self):
        if "column1890" not in casefile.names():
            raise Missing("the case column1890 is not there")
        if "contacts" not in casefile.Case("column1890").values:
            raise Missing("the case column1890 has no key 'contacts'")
        values = casefile.Case("column1890").values
        return {"end": 20 * values["coupling_steps"] * values["dem_step"] if self.quick else 1.0}

    def _column_runs(self):
        """The coupled run with lean contacts, and both DEM halves alone beside it."""
        if "column" not in self._kept:
            end = self._column()
            folder = bench_run.made("column1890", {"contacts": "lean", **end}, "targets")
            # every contact computed
            awake = {"rest": "no"} if "rest" in casefile.Case("column1890").values else {}
            lean, stock = (bench_run.alone(bench_run.made("column1890", {"contacts": c, **awake, **end}, "targets",
                                                          dry=True))
                           for c in ("lean", "stock"))
            self._kept["column"] = folder, lean, stock
        return self._kept["column"]

    def coupled_over_stock(self):
        folder, _, stock = self._column_runs()
        wall, alone = bench_run.wall(folder), stock[-1][1]
        return wall / alone, f"coupled {wall:.1f} s, stock LIGGGHTS alone {alone:.1f} s"

    def packed_step(self):
        _, lean, stock = self._column_runs()
        a, b = last_step(lean), last_step(stock)
        return a / b, f"{1e6 * a:.0f} us a step, stock {1e6 * b:.0f} us; over the last tenth of the run"

    def _packed_law(self, law):
        """The packed step by another law of contact, which the column has not."""
        end = self._column()
        if "rest" not in casefile.Case("column1890").values:
            raise Missing("the case column1890 has no key 'rest'")
        folder = bench_run.made("column1890", {"contacts": "lean", "rest": "no", **end}, "targets", dry=True)
        a, b = (last_step(bench_run.alone(folder, lambda text, s=stock: contacts_by(text, law, s)))
                for stock in (False, True))
        return a / b, f"{1e6 * a:.0f} us a step, stock {1e6 * b:.0f} us; over the last tenth of the run"

    def packed_hertz(self):
        return self._packed_law("hertz tangential history")

    def packed_rolling(self):
        return self._packed_law("hertz tangential history rolling_friction epsd2")

    def resting_step(self):
        end = self._column()
        if "rest" not in casefile.Case("column1890").values:
            raise Missing("the case column1890 has no key 'rest'")
        # at 1 s some spheres still move; at 2 s it is a bed at rest
        end["end"] = 2 * end["end"]
        folder = bench_run.made("column1890", {"contacts": "lean", "rest": "yes", **end}, "targets", dry=True)
        a, b = last_step(bench_run.alone(folder)), last_step(self._column_runs()[2])
        return a / b, (f"{1e6 * a:.1f} us a step over the last tenth of {end['end']:g} s, "
                       f"stock {1e6 * b:.0f} us at the end of half of it")

    # ---- loose clumps

    def _clumps(self):
        if "clumps" not in self._kept:
            end = 0.02 if self.quick else 0.1
            # few rows of the curve, as in a run of 7 s or 64 s
            window = {"end": end, "curve_rows": 200}
            free = bench_run.made("clump-half", {"charge": 0, **window}, "targets", dry=True)
            charged = bench_run.made("clump-half", window, "targets", dry=True)
            # in turn, so that all see the same machine
            made = [[], [], []]
            for _ in range(1 if self.quick else 3):
                for k, (folder, change) in enumerate(((free, None), (free, stock_clumps), (charged, None))):
                    made[k].append(mean_step(bench_run.alone(folder, change)))
            self._kept["clumps"] = [sorted(m)[len(m) // 2] for m in made]
        return self._kept["clumps"]

    def loose_step(self):
        ours, stock, _ = self._clumps()
        return ours / stock, f"{1e6 * ours:.1f} us a step, stock styles {1e6 * stock:.1f} us"

    def coulomb_share(self):
        ours, _, charged = self._clumps()
        return charged / ours - 1, f"{1e6 * charged:.1f} us a step with charges, {1e6 * ours:.1f} us without"

    # ---- the exchange

    def _coupled(self):
        """A coupled run to look at: of the column of 1890 spheres, else of clumps;
        (name, folder, seconds of its DEM half alone)."""
        if "coupled" not in self._kept:
            try:
                folder, lean, _ = self._column_runs()
                self._kept["coupled"] = "column1890", folder, lean[-1][1]
            except Missing:
                folder = bench_run.made("sphere-half", {"end": 0.02 if self.quick else 0.3}, "targets")
                self._kept["coupled"] = "sphere-half", folder, bench_run.alone(folder)[-1][1]
        return self._kept["coupled"]

    def exchange_cost(self):
        name, folder, _ = self._coupled()
        s = _summary(folder)
        seconds = s["mapping_s"] + s["exchange_s"]
        each = 1e6 * seconds / (s["particles"] * s["exchanges"])
        return each, f"{name}: mapping, drag and both halves' exchange, {seconds:.3g} s in {s['exchanges']} exchanges"

    def waiting_share(self):
        name, folder, _ = self._coupled()
        s = _summary(folder)
        wall = bench_run.wall(folder)
        share = min(s["exchange_dem_s"] + s["waiting_dem_s"], s["exchange_cfd_s"] + s["waiting_cfd_s"]) / wall
        return share, f"{name}: of the half that has more to do"

    def coupled_over_longer(self):
        name, folder, dem = self._coupled()
        s = _summary(folder)
        wall, cfd = bench_run.wall(folder), s["cfd_s"]
        return wall / max(dem, cfd), (f"{name}: coupled {wall:.2f} s, DEM alone {dem:.2f} s, "
                                      f"CFD half's solving {cfd:.2f} s")

    # ---- 64 s of the paper's columns

    def _paper(self, case, full):
        window = 0.05 if self.quick else 64.0 if full else 1.0
        folder = bench_run.made(case, {"end": window, "curve_rows": 200}, "targets")
        minutes = bench_run.wall(folder) * 64.0 / window / 60
        # the full size has the settings of the half
        error, known = _error("clump-half"), "no error is known: validation/bench measures it"
        if error is not None:
            known = f"error of clump-half {100 * error:.2g} % by the last validation/bench"
        how = ("all of it run" if window == 64.0 else
               f"from the first {window:g} s in proportion, too much: the bed comes to rest")
        return minutes, f"{how}; {known}", error is not None and error <= 0.01

    def half_size(self):
        return self._paper("clump-half", True)

    def full_size(self):
        return self._paper("clump-full", self.full)


TARGETS = (
    ("column of 1890 spheres, 1 s: coupled over stock LIGGGHTS alone", 0.45, Measurements.coupled_over_stock),
    ("the same, DEM step once packed, over stock", 0.2, Measurements.packed_step),
    ("the same with hertz", 0.2, Measurements.packed_hertz),
    ("the same with hertz and rolling friction epsd2", 0.2, Measurements.packed_rolling),
    ("the same, bed at rest, skipping on, over stock", 0.05, Measurements.resting_step),
    ("loose half-size clump column, DEM step without charges, over stock styles", 0.5, Measurements.loose_step),
    ("Coulomb at r_c = 12 mm adds to that", 0.25, Measurements.coulomb_share),
    ("exchange, mapping and drag [us a particle and coupling]", 0.5, Measurements.exchange_cost),
    ("exchange and waiting, share of the wall time", 0.05, Measurements.waiting_share),
    ("coupled over the longer of DEM alone and CFD alone", 1.10, Measurements.coupled_over_longer),
    ("charged clumps, half size, 64 s simulated [min], at <= 1 % error", 5.0, Measurements.half_size),
    ("charged clumps, full size, 64 s simulated [min], at <= 1 % error", 45.0, Measurements.full_size),
)


def measure(quick, full, tell):
    """A row for each target."""
    m, rows = Measurements(quick, full), []
    for target, gate, how in TARGETS:
        tell(f"{target} ...")
        row = {"target": target, "measured": None, "gate": gate, "passed": False, "note": ""}
        try:
            measured, note, *also = how(m)
            row.update(measured=measured, note=note, passed=bool(measured <= gate and all(also)))
        except (Missing, Broken) as e:
            row["note"] = f"not measured: {e}"
        rows.append(row)
    return rows


def table(rows):
    lines = []
    for r in rows:
        value = "-" if r["measured"] is None else f"{r['measured']:.3g}"
        lines.append(f"{'met   ' if r['passed'] else 'MISSED'} {r['target']:<76}{value:>9}  "
                     f"<= {r['gate']:g}\n       {r['note']}")
    return "\n".join(lines)


def last_step(rows, part=0.1):
    """Seconds a step over the last part of a run, of [(step, seconds)]."""
    end = rows[-1][0]
    first = max((r for r in rows if r[0] <= (1 - part) * end), key=lambda r: r[0])
    return (rows[-1][1] - first[1]) / (end - first[0])


def mean_step(rows):
    """Seconds a step over a whole run."""
    return (rows[-1][1] - rows[0][1]) / (rows[-1][0] - rows[0][0])


def contacts_by(text, law, stock):
    """column1890's script with another law of contact, in the lean loops or in LIGGGHTS's own."""
    before = text
    text = text.replace("hooke tangential history", law)
    text = text.replace("include contacts_${contacts}.liggghts",
                        "fix m6 all property/global coefficientRollingFriction peratomtypepair 3" + 9 * " 0.1" +
                        "\nvariable wall_style string wall/gran\npair_style gran model " + law +
                        (" lean no" if stock else " lean yes"))
    if text == before or "contacts_$" in text or "hooke" in text:
        raise Broken("column1890's script has changed: its contacts were not found")
    return text


def stock_clumps(text):
    """The clump columns' script in LIGGGHTS's own styles, without charges."""
    text = re.sub(r"pair_style hybrid/overlay gran/lean (.*?) coul/clump.*", r"pair_style gran \1 lean no", text)
    text = re.sub(r"pair_coeff \* \* gran/lean", "pair_coeff * *", text)
    text = re.sub(r"pair_coeff .*coul/clump.*\n", "", text)
    return "variable wall_style string wall/gran\n" + text.replace("multisphere/clump", "multisphere")


def _summary(folder):
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as f:
        return json.load(f)


def _error(case):
    """The error of what is shipped by the last validation/bench; None if there is none."""
    try:
        with open(os.path.join(bench_run.PLACE, "bench.json"), encoding="utf-8") as f:
            rows = json.load(f)
    except (OSError, ValueError):
        return None
    return next((r["error"] for r in rows if r["case"] == case and r["setting"] == "baseline"), None)
