# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Theory that the runs of clayFoam are held against.

drag     drag laws of the solver and the slip at which drag carries weight
flux     batch flux f(phi): Richardson-Zaki, tabulated, implied by a drag law
kynch    exact batch sedimentation for any initial solid fraction and flux
startup  from rest to the settling velocity
stages   near-linear stages of a settling curve (segments: its fit and search)
scaling  prototype and model particles, velocities, times
water    density and viscosity of water against temperature
tables   the reference tables in validation/data

SI units throughout. phi is the solid fraction, n = 1 - phi the void fraction.
Heights count from the bottom, velocities and fluxes of solids are positive
downwards. Functions take and return arrays of any shape unless they say
otherwise. Bad input raises ValueError naming the argument and its value.
"""
