#!/usr/bin/env bash
# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#
# Sets the project up and runs one of its programs. Nothing is set up when
# --no-setup comes first, nor where a list or help is asked for. --yes, wherever
# it stands, is for the set-up alone.
# Usage: cmake/start.sh MODULE [--no-setup] [--yes] [ARGUMENT ...]
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
module=$1
shift
what=()  # of the set-up: tests, too, for the programs of validation/
case $module in cases.*) what=(--programs) ;; esac
case "$module ${*:1}" in cases.lib.page.* | "cases.lib.clay."*" report "*) what+=(--reports) ;; esac
setup=1
if [ "${1:-}" = --no-setup ]; then
    shift
    setup=0
fi
words=()
for word; do
    case $word in
        -h | --help | --list | --counts | --keys | --version) setup=0 ;;
        --yes) what+=(--yes); continue ;;
    esac
    words+=("$word")
done
[ "$setup" = 0 ] || "$top/cmake/setup.sh" "${what[@]}"
[ -x /usr/bin/python3 ] || {
    echo "/usr/bin/python3 is not there; cmake/setup.sh installs it" >&2
    exit 1
}
# Debian's own python3, by itself: another one on the PATH may lack numpy, and
# neither the user's settings nor the current folder are to change what is loaded
exec /usr/bin/python3 -E -s -B "$top" "$module" "${words[@]}"
