# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A run on one page of HTML."""
