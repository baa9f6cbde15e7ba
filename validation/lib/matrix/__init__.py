# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Short coupled runs on several ranks against one rank: validation/matrix."""
