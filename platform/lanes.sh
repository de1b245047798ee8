#!/bin/sh
# lanes.sh - what platform/lanes.txt says of a compiler
#
#   lanes.sh usual CC [FLAG...]          the NAME that a build for this machine takes
#   lanes.sh offered CC [FLAG...]        "NAME HEADER FLAGS" of each line that it can compile
#   lanes.sh lacks MACRO CC [FLAG...]    which macro of MACRO it does not predefine; nothing if none
#
# A compiler that refuses a flag of a line has not what the line asks for.
# SPDX-License-Identifier: MIT
what=$1
shift
table=platform/lanes.txt

predefined() { # CC FLAG...
    "$@" -dM -E -x c /dev/null 2>/dev/null
}
lacking() { # MACRO, with the predefined macros as input
    awk -v wanted="$1" '
        { text = $3; for (i = 4; i <= NF; i++) { text = text " " $i } value[$2] = text; seen[$2] }
        END {
            n = split(wanted == "-" ? "" : wanted, macro, ",")
            for (i = 1; i <= n; i++) {
                given = split(macro[i], part, "=")
                if (!(part[1] in seen) || (given > 1 && value[part[1]] != part[2])) {
                    print macro[i]
                    exit
                }
            }
        }'
}

case $what in
lacks)
    macro=$1
    shift
    predefined "$@" | lacking "$macro"
    ;;
usual | offered)
    bare=$(predefined "$@")
    sed '/^#/d' "$table" | while read -r name header macro flags; do
        if [ -z "$(echo "$flags" | sed 's/-D[^ ]*//g; s/ //g')" ]; then
            macros=$bare
        elif [ "$what" = usual ]; then
            continue
        else
            # shellcheck disable=SC2086
            macros=$(predefined "$@" $flags)
        fi
        [ -z "$(printf '%s\n' "$macros" | lacking "$macro")" ] || continue
        if [ "$what" = offered ]; then
            echo "$name $header $flags"
        elif [ "$name" != scalar ]; then
            echo "$name"
        fi
    done | if [ "$what" = usual ]; then
        read -r name || name=scalar
        echo "$name"
    else
        cat
    fi
    ;;
*)
    echo "lanes.sh: usual, offered or lacks, not '$what'" >&2
    exit 2
    ;;
esac
