# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Layers of uniform suspension in a closed box, each drag law: the settling
velocity in the frame of no net volume flux."""

import glob
import os

import numpy as np

from cases.lib.theory.flux import DragLawFlux, rz_exponent
from validation.lib.checks import coupled, plots, reference

from .layers import CELL, LAYERS

TITLE = "uniform suspensions fall as each drag law implies, without net volume flux"
D, RHO_P, RHO_F, MU = 1e-3, 1200.0, 1000.0, 1.0
STOKES = (RHO_P - RHO_F) * 9.81 * D**2 / (18 * MU)
# the solver's name of a law, its column in the table (None: the formula itself)
LAWS = (("WenYu", "v_WenYu"), ("DiFelice", "v_DiFelice"), ("Ergun", "v_Ergun"), ("Gidaspow", "v_Gidaspow"),
        ("Beetstra", "v_Beetstra"), ("KochHill", "v_KochHill"), ("ergunWenYu", None), ("ergunWenYuBlended", None))
# at finite Re, by Di Felice: viscosity, time to settle into the fall, DEM step
FINITE = ((9.7e-3, "0.032", "1e-4"), (2.5e-3, "0.096", "2e-4"), (4.9e-4, "0.128", "2e-4"))


def velocities(folder, cells):
    """Mean velocity downwards [m/s] of the spheres in the middle `cells` of each layer."""
    last = sorted(glob.glob(os.path.join(glob.escape(folder), "DEM", "spheres.*.dump")))[-1]
    table = np.loadtxt(last, skiprows=9)
    z, v, found, bottom = table[:, 5], -table[:, 8], [], 0.0
    for _, height in LAYERS:
        low = bottom + 0.5 * (height - cells) * CELL
        found.append(v[(z >= low) & (z < low + cells * CELL)].mean())
        bottom += height * CELL
    return np.array(found)


def run(checks):
    table = reference.table("hindered_settling_by_drag_law_formula")
    phi = np.array([share for share, _ in LAYERS])
    row = [int(np.argmin(np.abs(table["phi"] - share))) for share in phi]
    series = []
    for law, column in LAWS:
        folder = coupled.finished("hindered-settling", f"hindered-settling/{law}", "--no-pictures", "--set",
                                  f"drag={law}")
        found = velocities(folder, 3) / STOKES
        expected = (table[column][row] if column else
                    DragLawFlux(law, D, RHO_P, RHO_F, MU / RHO_F, phi_m=0.7).velocity(phi) / STOKES)
        for share, a, b in zip(phi, found, expected):
            checks.close(f"{law}: v/v_Stokes at phi = {share:g}", a, b, 0.02)
        if law == "WenYu":
            zaki = reference.table("richardson_zaki_exponents")
            fit = float(np.polyfit(np.log(1 - phi), np.log(found), 1)[0])
            checks.close("WenYu: exponent n of (1 - phi)^n, Richardson and Zaki's at low Re", fit,
                         float(zaki["n_Richardson_Zaki"][0]), 0.02)
        series += [(law, phi, found, "dots")]
        if column:
            series += [(None, table["phi"], np.where(table["phi"] < 0.02, np.nan, table[column]), "line")]
    for viscosity, end, step in FINITE:
        folder = coupled.finished("hindered-settling", f"hindered-settling/viscosity-{viscosity:g}", "--no-pictures",
                                  "--set", "drag=DiFelice", "--set", f"viscosity={viscosity}", "--set", f"end={end}",
                                  "--set", f"dem_step={step}", "--set", "stiffness=0.3")
        # the lowest and the topmost layer change by then: the floor fills, the dense one loosens
        law = DragLawFlux("DiFelice", D, RHO_P, RHO_F, viscosity / RHO_F, phi_m=0.7)
        inner, found = phi[1:-1], velocities(folder, 3)[1:-1]
        alone = float(law.velocity(1e-9))
        re = alone * D * RHO_F / viscosity
        for share, a, b in zip(inner, found, law.velocity(inner)):
            checks.close(f"DiFelice, Re_t = {re:.2g}: v/v_t at phi = {share:g}", a / alone, b / alone, 0.02)
        fit, own = (float(np.polyfit(np.log(1 - inner), np.log(v), 1)[0]) for v in (found, law.velocity(inner)))
        checks.close(f"DiFelice, Re_t = {re:.2g}: exponent n of (1 - phi)^n, the law's", fit, own, 0.02)
        checks.close(f"DiFelice, Re_t = {re:.2g}: exponent n, Richardson and Zaki's", fit, float(rz_exponent(re)), 0.15)
    checks.picture(plots.compare(
        os.path.join(coupled.RUNS, "hindered-settling", "hindered.png"), series, "solid fraction",
        "settling velocity over Stokes's", "uniform suspensions at low Re: coupled runs (circles), formulas (lines)",
        logy=True))
