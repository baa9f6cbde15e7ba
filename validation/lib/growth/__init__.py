# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""How costs grow with the size: validation/growth."""
