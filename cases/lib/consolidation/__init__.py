# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Large-strain consolidation of a run by the laws of its own profiles."""
