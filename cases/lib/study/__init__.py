# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A study: what sets the second and third stage of a settling curve."""
