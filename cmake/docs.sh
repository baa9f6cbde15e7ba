#!/usr/bin/env bash
# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the manual in build/manual; warnings are errors. Its tools are installed
# here, when they are needed, and by nothing else. On a terminal it asks before
# it installs with sudo, unless --yes is given.
# Usage: cmake/docs.sh [--yes] [FOLDER]
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
words=()
if [ "${1:-}" = --yes ]; then words=(--yes); shift; fi
"$top/cmake/setup.sh" --docs "${words[@]}"
out=${1:-$top/build/manual}
cd "$top"
sphinx-build -q -W --keep-going -n -b html -c manual -d "$out.trees" . "$out"
echo "the manual: $out/manual/index.html"
