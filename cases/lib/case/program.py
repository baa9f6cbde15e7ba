# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""How a program of cases/ ends."""

import os
import sys

from cases.lib.case.errors import CaseError


def guarded(work, program):
    """A program's exit code; bad input is said in one line."""
    try:
        return work()
    except CaseError as e:
        print(f"{program}: {e}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print(f"{program}: interrupted; what was finished is kept", file=sys.stderr)
        return 130
    except BrokenPipeError:
        os._exit(1)
    except OSError as e:
        print(f"{program}: {e.filename}: {e.strerror}" if e.filename else f"{program}: {e}", file=sys.stderr)
        return 2
