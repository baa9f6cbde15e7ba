# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Where the particles are at the start."""
