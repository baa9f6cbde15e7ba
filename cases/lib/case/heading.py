# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What a run is called: its case's title while it has the case's settings, else what it has in their place."""

from cases.lib.case.casefile import text

# of these a run's title need not speak
_ASIDE = {"end", "frames", "curve_rows", "seed", "checkpoint", "checkpoint_steps", "accuracy", "overlap", "quiet_fluid",
          "keep_mapping", "tolerance", "time_scale", "rest"}
# nor of these where the regime sets them
_OF_REGIME = {"viscosity", "prototype_viscosity", "stiffness", "dem_step", "coupling_steps", "coulomb_steps"}
_MOST = 4


def _millimetres(*lengths):
    return " x ".join(f"{1e3 * x:.4g}" for x in lengths) + " mm"


def _particles(v):
    """60 charged clumps of illite."""
    if "clumps" in v:
        share = v["illite_share"]
        kind = {0: " of kaolinite", 1: " of illite"}.get(share, f", {100 * share:.3g} % of them illite")
        return f"{v['clumps']:.0f} {'charged' if v['charge'] else 'uncharged'} clumps{kind}"
    return f"{v['spheres']:.0f} spheres" if isinstance(v.get("spheres"), (int, float)) else ""


def _room(v):
    """in a tube of 32.5 mm, 150 mm high."""
    if "tube_radius" in v:
        return f"in a tube of {_millimetres(2 * v['tube_radius'])}, {_millimetres(v['tube_height'])} high"
    if "size_x" in v:
        return f"in a box of {_millimetres(v['size_x'], v['size_y'], v['size_z'])}"
    return ""


def of(case, derived):
    """The title of a run of the case with its values and those that follow from them."""
    said = _changes(case)
    if not said:
        return case.title
    what = " ".join(filter(None, (_particles({**case.values, **derived}), _room({**case.values, **derived}))))
    return "; ".join(filter(None, (what, f"{case.name} with {said}")))


def of_several(case, varied):
    """The title of runs of a case that differ in some keys; case has what is alike."""
    said = _changes(case)
    return f"{case.name}, {' and '.join(varied)} varied" + (f", with {said}" if said else "")


def _changes(case):
    """The values that are not the case's own, as words."""
    aside = _ASIDE | (_OF_REGIME if "regime" in case.changed() else set())
    changed = [k for k in case.changed() if k not in aside]
    said = []
    for key in changed[:_MOST]:
        unit = case.parameters[key].get("unit", "1")
        said.append(f"{key} = {text(case.values[key])}" + (f" {unit}" if unit not in ("1", "name") else ""))
    return ", ".join(said + ([f"{len(changed) - _MOST} more"] if len(changed) > _MOST else []))


def days(case):
    """Time in the laboratory over time in the model, for pictures; None where nobody calibrated it: the scale holds
    for the material that case.json names, with the values it has there, or is one's own."""
    changed = case.changed()
    known = case.calibrated and not changed.keys() & set(case.calibrated)
    return case.values["time_scale"] if known or "time_scale" in changed else None
