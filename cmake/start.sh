#!/usr/bin/env bash
# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#
# Sets the project up, unless --no-setup comes first, and runs one of its programs.
# Usage: cmake/start.sh MODULE [--no-setup] [ARGUMENT ...]
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
module=$1
shift
if [ "${1:-}" = --no-setup ]; then shift; else "$top/cmake/setup.sh"; fi
# Debian's own python3, by itself: another one on the PATH may lack numpy, and
# neither the user's settings nor the current folder are to change what is loaded
exec /usr/bin/python3 -E -s -B "$top" "$module" "$@"
