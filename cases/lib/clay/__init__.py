# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""One program for all that programs of cases/ do."""
