# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Packages, none of which imports one below it in this list: theory; case; output; packing; run; kynch,
calibration; sweep; figures. Tests stand beside what they test."""
