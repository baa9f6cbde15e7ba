# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""What a run has written: spheres and fields as files for ParaView and as pictures."""
