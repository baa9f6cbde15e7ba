#!/usr/bin/env bash
# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes OpenFOAM's include folders for the installed Debian package, which
# ships none: they come from the source package of the same version. The
# machine's own apt configuration and package lists are left as they are.
#
# Usage: openfoam-headers.sh DIR     (prints nothing when DIR is up to date)
set -euo pipefail

fail() { echo "openfoam-headers: $*" >&2; exit 1; }

dest=$(mkdir -p "$1" && cd "$1" && pwd)
version=$(dpkg-query -W -f='${source:Version}' openfoam 2>/dev/null) ||
    fail "the package 'openfoam' is not installed"
stamp="$dest/version"
[ -f "$stamp" ] && [ "$(cat "$stamp")" = "$version" ] && exit 0

work=$(mktemp -d "${TMPDIR:-/tmp}/openfoam-headers.XXXXXX")
trap 'rm -rf "$work"' EXIT
chmod 755 "$work"
mkdir -p "$work"/{parts,lists/partial,archives/partial,source}

# the machine's own sources, as deb-src
: > "$work/sources.list"
for f in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [ -f "$f" ] && sed -n 's/^deb\(-src\)\{0,1\}[[:space:]]/deb-src /p' "$f" >> "$work/sources.list"
done
for f in /etc/apt/sources.list.d/*.sources; do
    [ -f "$f" ] && sed 's/^Types:.*/Types: deb-src/' "$f" > "$work/parts/${f##*/}"
done
sort -u -o "$work/sources.list" "$work/sources.list"

apt=(apt-get -qq
     -o "Dir::Etc::SourceList=$work/sources.list"
     -o "Dir::Etc::SourceParts=$work/parts"
     -o "Dir::State::Lists=$work/lists"
     -o "Dir::Cache=$work"
     -o "APT::Sandbox::User=$(id -un)"
     -o "Debug::NoLocking=1")

echo "openfoam-headers: fetching the source of openfoam $version (45 MB)"
# a source that offers no deb-src is no reason to stop; a missing one is
"${apt[@]}" update 2> "$work/update.log" || true
(cd "$work/source" && "${apt[@]}" source --download-only "openfoam=$version") || {
    cat "$work/update.log" >&2
    fail "no source package of openfoam $version can be had;" \
         "source an OpenFOAM environment with headers instead"
}

tarball=$(find "$work/source" -name 'openfoam_*.orig.tar.*' ! -name '*.asc' -print -quit)
[ -n "$tarball" ] || fail "the source package of openfoam $version holds no orig.tar file"
mkdir "$work/tree"
tar -xf "$tarball" -C "$work/tree" --strip-components=1 --wildcards '*/src/*' '*/wmake/*' \
    2> "$work/tar.log" || fail "cannot unpack ${tarball##*/}: $(head -n 1 "$work/tar.log")"

rm -rf "$dest"/src
mkdir -p "$dest/src"
libraries="OpenFOAM OSspecific/POSIX finiteVolume meshTools
    transportModels transportModels/incompressible transportModels/compressible
    TurbulenceModels/turbulenceModels TurbulenceModels/incompressible
    TurbulenceModels/compressible"
for lib in $libraries; do
    [ -d "$work/tree/src/$lib" ] || fail "the source package holds no src/$lib"
    mkdir -p "$dest/src/$lib"
    cp -r "$work/tree/src/$lib/." "$dest/src/$lib/"
    (cd "$work/tree" && WM_PROJECT_DIR="$work/tree" wmake/wmakeLnInclude -s "$dest/src/$lib") > "$work/wmake.log" 2>&1 ||
        fail "wmakeLnInclude failed for src/$lib: $(tail -n 1 "$work/wmake.log")"
done
# only headers and templates are wanted
find "$dest/src" -type d -name Make -prune -exec rm -rf {} +
echo "$version" > "$stamp"
echo "openfoam-headers: done, $dest"
