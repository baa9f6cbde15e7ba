# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""A case: its parameters, derived values, meshes, and OpenFOAM's programs and files."""
