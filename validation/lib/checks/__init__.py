# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What the checks of validation/ROOM/NAME/check.py use, and validation/run."""
