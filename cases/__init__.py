# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The cases and, in lib, what runs and evaluates them."""
