# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
# Completes the words behind `clay` in bash; in a project folder, once for a
# shell: source cmake/clay.bash. What it offers is what clay itself says.

_clay()
{
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} clay=${COMP_WORDS[0]}
    local command=${COMP_WORDS[1]} offered
    if [ "$COMP_CWORD" = 1 ]; then
        offered=$("$clay" --help 2> /dev/null | sed -nE 's/^  (-?-?[a-z]+) .*/\1/p')
    elif [ "$before" = --set ]; then
        compopt -o nospace 2> /dev/null
        offered=$("$clay" run "${COMP_WORDS[2]}" --keys 2> /dev/null | sed -nE 's/^  ([a-z_]+) .*/\1=/p')
    elif [ "$before" = --out ] || [ "$before" = --store ]; then
        mapfile -t COMPREPLY < <(compgen -d -- "$word")
        return
    elif [[ $word == -* ]]; then
        offered="$("$clay" "$command" --help 2> /dev/null | grep -oE -- '--[a-z][a-z0-9-]*' | sort -u) --json --quiet"
    else
        case $command in
            run | pack | calibrate | sweep | kynch)
                offered=$("$clay" run --list 2> /dev/null | sed -nE 's/^([^ ]+) .*/\1/p') ;;
        esac
        mapfile -t COMPREPLY < <(compgen -W "$offered" -- "$word"; compgen -d -- "$word")
        return
    fi
    mapfile -t COMPREPLY < <(compgen -W "$offered" -- "$word")
}
complete -o filenames -F _clay clay cases/clay
