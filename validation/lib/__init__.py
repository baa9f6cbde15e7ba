# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Packages: checks, on which the programs bench, stress and growth stand."""
