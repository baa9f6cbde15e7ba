# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of a column against Kynch's theory."""
