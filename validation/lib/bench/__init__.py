# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Run time against error, and the targets of speed: validation/bench."""
