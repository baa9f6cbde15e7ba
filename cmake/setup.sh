#!/usr/bin/env bash
# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the project ready to run: installs the Debian packages that are missing
# and builds both halves when a source is newer than the build. Silent when
# nothing is to be done. A sourced OpenFOAM environment is used as it is.
#
# Usage: cmake/setup.sh [JOBS]
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
stamp="$top/build/.ready"
flavour=${WM_PROJECT_DIR:-packaged}
inputs=("$top/CMakeLists.txt" "$top/CMakePresets.json" "$top/cmake"
        "$top/exchange" "$top/liggghts-fix" "$top/foam-coupling")

if [ -f "$stamp" ] && [ "$(cat "$stamp")" = "$flavour" ] &&
   [ -x "$top/build/bin/liggghts-clay" ] && [ -x "$top/build/bin/clayFoam" ] &&
   [ -z "$(find "${inputs[@]}" -newer "$stamp" ! -name '*.md' -print -quit)" ]; then
    exit 0
fi

fail() { echo "setup: $*" >&2; exit 1; }

packages="cmake g++ make liggghts libliggghts-dev openmpi-bin libopenmpi-dev
    libeigen3-dev libcli11-dev nlohmann-json3-dev libgtest-dev libbenchmark-dev
    python3 python3-numpy python3-matplotlib python3-scipy python3-vtk9 packmol"
[ -n "${WM_PROJECT_DIR:-}" ] || packages="$packages openfoam libopenfoam"

command -v dpkg-query > /dev/null ||
    fail "this is no Debian system; install by hand: $(echo $packages)"
missing=""
for p in $packages; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$p" 2> /dev/null)" = installed ] ||
        missing="$missing $p"
done

if [ -n "$missing" ]; then
    root=()
    if [ "$(id -u)" != 0 ]; then
        command -v sudo > /dev/null ||
            fail "these packages are missing, and neither root nor sudo is at hand:$missing"
        root=(sudo)
    fi
    echo "setup: installing$missing"
    log=$(mktemp)
    trap 'rm -f "$log"' EXIT
    "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq update > "$log" 2>&1 ||
        fail "apt-get update failed: $(tail -n 1 "$log")"
    "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -y \
        --no-install-recommends install $missing > "$log" 2>&1 ||
        fail "cannot install$missing: $(grep '^E:' "$log" | tail -n 1)"
fi

mkdir -p "$top/build"
began=$(mktemp "$top/build/.ready.XXXXXX")
log="$top/build/setup.log"
echo "setup: building (log in build/setup.log)"
cd "$top"
if ! { cmake --preset release && cmake --build --preset release -j"${1:-$(nproc)}"; } \
        > "$log" 2>&1; then
    rm -f "$began"
    # the compiler's first complaint says more than make's last
    fail "the build failed: $(grep -m1 -E 'error:|Error at|no headers|Error [0-9]' "$log" ||
        tail -n 1 "$log")"
fi
echo "$flavour" > "$began.text"
touch -r "$began" "$began.text"
mv "$began.text" "$stamp"
rm -f "$began"
