# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Profiles of a sphere and a clump column: what carries the weight above, and the fluxes."""

import os

import numpy as np

from cases.lib.output import profile
from cases.lib.theory import carrying
from validation.lib.checks import coupled

TITLE = "settling profiles: contacts, charges, walls and pore pressure carry the weight above"
LONG = True

_CASES = (("sphere-half", "2.4"), ("clump-half", "1.6"))


def run(checks):
    for name, end in _CASES:
        folder = coupled.finished(name, "settling-profile/" + name, "--end", end, "--set", "profile_rows=120",
                                  limit=1200)
        for picture in ("profile_map.png", "profile_stress.png"):
            checks.true(f"{name}: {picture}", os.path.getsize(os.path.join(folder, picture)) > 0)
        columns = profile.read(folder)
        off = profile.imbalance(columns, 10)
        checks.at_most(f"{name}, at rest: contacts, charges, walls and pore pressure less the weight above, largest at "
                       "any height over the whole weight", float(np.max(np.abs(off))), 0.01)
        t = columns["time_s"]
        times, _, begin, full = carrying.of_profile(columns)
        checks.true(f"{name}: consolidation begins at the bottom and comes to the top",
                    begin is not None and full is not None and begin <= full, (begin, full))
        falling = (t > 0.02) & (t < 0.5 * (full or t[-1]))
        weight = np.max(columns["weight_Pa"])
        apart = columns["excess_pressure_Pa"][falling] - columns["fluid_Pa"][falling]
        checks.at_most(f"{name}, settling: excess pore pressure less what the fluid does to the particles above, mean "
                       "size over the whole weight", float(np.nanmean(np.abs(apart))) / weight, 0.1)
        # over the layers' thickness, which the fluid's fluxes are means of
        solids, fluid = columns["flux_m_s"][falling], columns["fluid_flux_m_s"][falling]
        net = np.mean(solids + fluid, axis=1)
        checks.at_most(f"{name}, settling: net flux through the column over the largest flux of solids",
                       float(np.nanmean(np.abs(net)) / np.max(np.abs(solids))), 0.05)
        checks.at_least(f"{name}: slices and times with a permeability",
                        float(np.count_nonzero(np.isfinite(columns["permeability_m2"]))), 100)
