# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""Sphinx: the manual is made of the project's pages where they stand, and of those in this folder."""

import os
import re

_TOP = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
with open(os.path.join(_TOP, "CMakeLists.txt"), encoding="utf-8") as f:
    release = version = re.search(r"project\(\w+ VERSION ([\d.]+)", f.read()).group(1)

project = "clayFoam"
author = "the authors of clayFoam"
root_doc = "manual/index"
extensions = ["myst_parser"]
source_suffix = {".md": "markdown"}
include_patterns = ["manual/*.md", "README.md", "CONTRIBUTING.md", "CHANGELOG.md", "cases/*.md", "exchange/README.md",
                    "foam-coupling/README.md", "liggghts-fix/doc/*.md", "validation/*.md"]
exclude_patterns = ["build", "results", "validation/RESULTS.md", "validation/CLAIMS.md"]
highlight_language = "none"
html_theme = "alabaster"
html_theme_options = {"description": "Clay settling in water, by LIGGGHTS and OpenFOAM", "page_width": "1100px",
                      "sidebar_width": "260px"}
html_show_copyright = False
html_copy_source = False
