# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What a measured curve says: stages, scaling, charge and time scale."""
