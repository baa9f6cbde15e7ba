# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Waves of the solid fraction, two, four and eight cells long, in uniform
suspensions that settle: kinematic theory has them neither grow nor decay."""

import os

import numpy as np

from cases.lib.output import spheres
from cases.lib.theory.flux import DragLawFlux
from validation.lib.checks import coupled, plots

TITLE = "waves of two to eight cells in uniform suspensions: none grows, solid fractions 0.05 to 0.55"
LONG = True

D, RHO_P, RHO_F, MU, G, STEP = 1e-3, 2600.0, 1000.0, 0.132, 9.81, 4e-5
CELLS, ACROSS, FRAMES, INTERVAL = 8, 6, 40, 10
FRACTIONS = (0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.55)
LENGTHS = (2, 4, 8)  # cells
KERNELS = {"kernel": ("smoothing=diffusion", "bandwidth=auto"), "none": ("smoothing=none",)}
V_T = float(DragLawFlux("WenYu", D, RHO_P, RHO_F, MU / RHO_F).velocity(1e-9))


def rates(phi, kernel):
    """Growth rates of the waves [v_t/d], as LENGTHS, by the lines through the logarithms of
    their amplitudes from a quarter of the time on."""
    a = (2 * np.pi / 6 * D**3 / phi) ** (1 / 3)
    high = round(CELLS * 2 * D / a)
    length, width = high * a, ACROSS * a
    slip = V_T * (1 - phi) ** 3.65
    every = STEP * INTERVAL * FRAMES
    words = [w for s in (f"across={ACROSS}", f"high={high}", f"spacing={a:.17g}", f"size_x={width:.17g}",
                         f"size_y={width:.17g}", f"size_z={length:.17g}", f"cells_z={CELLS}",
                         # no net volume flux, no net weight
                         f"speed_z={-(1 - phi) * slip:.17g}", f"start_velocity={phi * slip:.17g}",
                         f"push={phi / (1 - phi) * (RHO_P / RHO_F - 1) * G:.17g}",
                         f"end={round(10 * D / V_T / every) * every:.6g}", f"frames={FRAMES}", *KERNELS[kernel])
             for w in ("--set", s)]
    folder = coupled.finished("wave-scene", f"suspension-waves/{kernel}-{phi:g}", "--no-pictures", *words)
    times, sizes = [], []
    for step, path in spheres.dumps(folder):
        z = spheres.read(path)["z"]
        times.append(step * STEP * V_T / D)
        sizes.append([2 * abs(np.mean(np.exp(-2j * np.pi * z / length * CELLS / k))) for k in LENGTHS])
    later = slice(len(times) // 4, None)
    return np.polyfit(times[later], np.log(sizes[later]), 1)[0], coupled.cfd(folder)


def run(checks):
    found = {}
    for kernel in KERNELS:
        for phi in FRACTIONS:
            found[kernel, phi], cfd = rates(phi, kernel)
            for k, rate in zip(LENGTHS, found[kernel, phi]):
                say = f"{kernel}, phi {phi:g}, {k} cells: growth rate [v_t/d]"
                if kernel == "kernel":
                    checks.at_most(say, float(rate), 0.01)
                    checks.at_least(say + ", decay", float(rate), -0.1)
                else:
                    checks.note(f"{say} {rate:+.4f}")
        if kernel == "none":
            checks.at_least("none, phi 0.3, 2 cells: the wave that a kernel takes away is seen",
                            float(found[kernel, 0.3][0]), 0.1)
    lines = [(f"smoothing diffusion, bandwidth auto, {k} cells", FRACTIONS,
              [found["kernel", phi][i] for phi in FRACTIONS], "line") for i, k in enumerate(LENGTHS)]
    lines.append(("smoothing none, 2 cells", FRACTIONS, [found["none", phi][0] for phi in FRACTIONS], "dashed"))
    lines.append(("kinematic waves", FRACTIONS, [0] * len(FRACTIONS), "dots"))
    checks.picture(plots.compare(os.path.join(coupled.RUNS, "suspension-waves", "suspension-waves.png"), lines,
                                 "solid fraction", "growth rate, v_t/d",
                                 "waves of the solid fraction in uniform suspensions"))
