# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""This project's counterparts of the paper's figures."""
