#!/usr/bin/env bash
# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the project ready to run: installs the Debian packages that are missing
# and builds both halves and their tests when a source is newer than the build;
# with --programs what a run needs and no more; with --reports what its page, too;
# with --docs the manual's tools alone. Silent when nothing is to be
# done, else it shows how far it is. On a terminal it asks before it installs
# with sudo, unless --yes is given. A sourced OpenFOAM environment is used as it is.
#
# Usage: cmake/setup.sh [--programs] [--reports] [--docs] [--yes] [JOBS]
set -euo pipefail

what=tests ask=yes reports=
while :; do
    case ${1:-} in
        --programs) what=programs ;;
        --reports) reports=python3-jinja2 ;;
        --docs) what=docs ;;
        --yes) ask=no ;;
        *) break ;;
    esac
    shift
done
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
stamp="$top/build/.ready"
# The OpenFOAM that FindOpenFOAM.cmake will take: all that it reads of a sourced
# environment; the package's own folder is none
flavour=packaged
foam=${WM_PROJECT_DIR:-}
while [ "${foam%/}" != "$foam" ]; do foam=${foam%/}; done
if [ -n "$foam" ] && ! dpkg -L openfoam 2> /dev/null | grep -Fx "$foam/etc/controlDict" > /dev/null; then
    flavour="$foam ${WM_PROJECT_VERSION:-} ${WM_PRECISION_OPTION:-} ${WM_LABEL_SIZE:-} ${FOAM_LIBBIN:-} ${FOAM_MPI:-}"
fi
inputs=("$top/CMakeLists.txt" "$top/CMakePresets.json" "$top/cmake"
        "$top/exchange" "$top/liggghts-fix" "$top/foam-coupling")

there() { [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2> /dev/null)" = installed ]; }

# the stamp says which OpenFOAM the build is for, and whether it has the tests
made=$(cat "$stamp" 2> /dev/null || true)
if { [ "$made" = "$flavour tests" ] || [ "$made" = "$flavour $what" ]; } &&
   [ -x "$top/build/bin/liggghts-clay" ] && [ -x "$top/build/bin/clayFoam" ] &&
   { [ -z "$reports" ] || there "$reports"; } &&
   [ -z "$(find "${inputs[@]}" -newer "$stamp" ! -name '*.md' -print -quit)" ]; then
    exit 0
fi

fail() { echo "setup: $*" >&2; exit 1; }

# One line, renewed in place on a terminal; elsewhere each is a line of its own
width=0
show() {
    if [ -t 1 ]; then printf '\r%-*s' "$width" "$1"; width=${#1}; else printf '%s\n' "$1"; fi
}
shown() { [ "$width" = 0 ] || echo; }

# Keeps what apt-get says in a file, and shows how many packages are there
installing() {
    local line all='?' fetched=0 ready=0
    while IFS= read -r line; do
        printf '%s\n' "$line" >> "$1"
        case $line in
            *" newly installed,"*) all=${line% newly installed,*} all=${all##* } ;;
            Get:*) fetched=$((fetched + 1)) ;;
            "Setting up "*) ready=$((ready + 1)) ;;
            *) continue ;;
        esac
        if [ -t 1 ] || [ $(((fetched + ready) % 20)) = 0 ]; then
            show "setup: installing: $fetched fetched, $ready of $all packages are set up"
        fi
    done
    shown
}

# Keeps what the build says in a file, and shows its per cent
building() {
    local line part last=-10
    while IFS= read -r line; do
        printf '%s\n' "$line" >> "$1"
        case $line in
            "openfoam-headers: fetching"*) show "setup: ${line#openfoam-headers: }" ;;
            "["*"%] "*)
                part=${line%%\%*} part=${part#[} part=${part// /}
                if [ "$part" -ge $((last + 10)) ] || { [ -t 1 ] && [ "$part" -gt "$last" ]; }; then
                    show "setup: building: $part %"
                    last=$part
                fi ;;
        esac
    done
    shown
}

packages=(cmake g++ make liggghts libliggghts-dev openmpi-bin libopenmpi-dev
    libeigen3-dev zlib1g-dev nlohmann-json3-dev librandom123-dev packmol
    python3 python3-numpy python3-matplotlib python3-scipy python3-meshio)
[ "$what" != tests ] ||
    packages+=(libgtest-dev libbenchmark-dev valgrind python3-pytest python3-jinja2
        clang-format clang-tidy shellcheck python3-flake8
        chromium python3-sphinx python3-myst-parser)
[ -z "$reports" ] || packages+=("$reports")
[ "$what" != docs ] || packages=(python3-sphinx python3-myst-parser) flavour=none
# the headers of the package come from its source, a compressed tar file
[ "$flavour" != packaged ] || packages+=(openfoam libopenfoam bzip2 xz-utils)

command -v dpkg-query > /dev/null ||
    fail "this is no Debian system; install by hand: ${packages[*]}"
missing=()
for p in "${packages[@]}"; do
    there "$p" || missing+=("$p")
done

if [ "${#missing[@]}" != 0 ]; then
    root=()
    if [ "$(id -u)" != 0 ]; then
        command -v sudo > /dev/null ||
            fail "these packages are missing, and neither root nor sudo is at hand: ${missing[*]}"
        root=(sudo)
    fi
    if [ "${#root[@]}" != 0 ] && [ "$ask" = yes ] && [ -t 0 ] && [ -t 2 ]; then
        read -r -p "setup: install with sudo: ${missing[*]}? [Y/n] " answer || answer=no
        case $answer in
            "" | [Yy]*) ;;
            *) fail "nothing was installed; these packages are missing: ${missing[*]}" ;;
        esac
    fi
    echo "setup: installing ${missing[*]}"
    apt_log=$(mktemp)
    trap 'rm -f "$apt_log"' EXIT
    "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq update > "$apt_log" 2>&1 ||
        fail "apt-get update failed: $(tail -n 1 "$apt_log")"
    # -y: what it does is shown, what it asks has been asked
    "${root[@]}" env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -q -y \
        --no-install-recommends install "${missing[@]}" < /dev/null 2>&1 | installing "$apt_log" ||
        fail "cannot install ${missing[*]}: $(grep '^E:' "$apt_log" | tail -n 1)"
fi

[ "$what" != docs ] || exit 0

# The line of a build's log that tells most: the first complaint of a program,
# or CMake's own words for its error; else make's.
complaint() {
    awk '/^openfoam-headers: (fetching|done)/ { next }
         told && /^Call Stack/ { exit }
         told && NF { $1 = $1; text = text (text == "" ? "" : " ") $0; next }
         told && text != "" { exit }
         /^openfoam-headers: |Cannot exec|^ *Could NOT find|error:/ { text = $0; exit }
         /^CMake Error/ { told = 1; head = $0; next }
         END { if (text == "") text = head; if (text == "") exit 1; sub(/^ */, "", text); print text }' "$1" ||
        grep -m1 -E 'Error [0-9]' "$1" || tail -n 1 "$1"
}

mkdir -p "$top/build"
# what CMake found for another OpenFOAM must not be mixed with this one
last=$(cat "$top/build/.flavour" 2> /dev/null || echo "$flavour")
[ "$last" = "$flavour" ] || rm -f "$top/build/CMakeCache.txt"
# nor what it found where this folder was before it was moved or copied
home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$top/build/CMakeCache.txt" 2> /dev/null || true)
if [ -n "$home" ] && [ "$home" != "$top" ]; then
    echo "setup: this folder was moved or copied from $home: configuring anew"
    rm -rf "$top/build/CMakeCache.txt" "$top/build/CMakeFiles"
fi
echo "$flavour" > "$top/build/.flavour"
began=$(mktemp "$top/build/.ready.XXXXXX")
log="$top/build/setup.log"
echo "setup: building (log in build/setup.log)"
: > "$log"
cd "$top"
options=(-DCLAYFOAM_TESTS=ON) targets=()
if [ "$what" = programs ]; then
    targets=(--target liggghts-clay clayFoam)
    # a build folder that has the tests keeps them, for the next time
    options=()
    [ -f build/CMakeCache.txt ] || options=(-DCLAYFOAM_TESTS=OFF)
fi
if ! { cmake --preset release "${options[@]}" &&
       cmake --build --preset release -j"${1:-$(nproc)}" "${targets[@]}"; } 2>&1 | building "$log"; then
    rm -f "$began"
    fail "the build failed: $(complaint "$log") (log in build/setup.log)"
fi
echo "$flavour $what" > "$began.text"
touch -r "$began" "$began.text"
mv "$began.text" "$stamp"
rm -f "$began"
