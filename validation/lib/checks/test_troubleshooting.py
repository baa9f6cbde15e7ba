# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The messages that the manual explains are those of the programs."""

import glob
import os
import re

from cases.lib.case.casefile import TOP


def test_every_message_is_one_of_the_programs():
    with open(os.path.join(TOP, "manual", "troubleshooting.md"), encoding="utf-8") as f:
        messages = re.findall(r"^\| `([^`]+)` \|", f.read(), re.M)
    assert len(messages) > 8
    sources = ""
    for pattern in ("cases/lib/*/*.py", "cmake/*.sh", "liggghts-fix/*/*.cpp", "liggghts-fix/*/*.h",
                    "foam-coupling/*/*.C", "exchange/*.cpp"):
        for path in glob.glob(os.path.join(TOP, pattern)):
            if os.path.basename(path).startswith("test_"):
                continue
            with open(path, encoding="utf-8") as f:
                sources += f.read()
    # a message may be broken into pieces of text
    sources = re.sub(r'"\s*\n\s*f?"', "", sources)
    lost = [m for m in messages if m not in sources]
    assert not lost
