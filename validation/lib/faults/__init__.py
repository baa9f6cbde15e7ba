# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What is done to a run, and what comes of it."""
