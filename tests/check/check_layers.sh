#!/bin/sh
# check_layers.sh - who knows whom: the order of folders, and circles of files
#
# The table is the order (DESIGN.md, "The house"). It holds for includes, and for what
# objects refer to, because a declaration can be written anywhere. The files of the
# product form no circles: neither by their includes nor by what their objects refer to.
# SPDX-License-Identifier: MIT
. tests/check/report.sh

# From the ground up: a file knows its own folder and those of lines above its own here.
# Folders of one line do not know each other; "*" is the name of a board. A folder
# that is not here is a failure, one that is only here is not.
table='engine/planelet*.h
engine/base
engine/lanes
engine/image
engine/tree
engine/tree/thesis engine/tree/compact
engine/builder
engine/grid
engine/instances
engine/memory
engine/texture
engine/surface
engine/scene
engine/trace
engine/schedule
engine/motion
engine/whitted
engine/shade
engine
platform
platform/bare platform/headers platform/soft_float platform/wire
platform/cortex_m/armv6m platform/cortex_m/armv7m platform/cortex_m/armv8m platform/riscv
platform/cortex_m
board
board/wired board/played
board/*
board/*/wired
host_tools/base
host_tools/picture
host_tools/mesh
host_tools/scenes
host_tools/treelets
host_tools/pack
host_tools/baselines/base
host_tools/baselines/packet
host_tools/baselines/planes host_tools/baselines/treelets
host_tools/baselines/kd host_tools/baselines/bvh host_tools/baselines/bph
host_tools/baselines/bkd host_tools/baselines/bih host_tools/baselines/treelet_trees
host_tools/baselines/counted
host_tools/baselines
host_tools/link
host_tools/app
host_tools/tables
host_tools/hid/device
host_tools/hid/drivers host_tools/hid/sources
host_tools/cli host_tools/hid host_tools/web host_tools/web/headers
tests'

# The one exception is the contract between a board and its start-up code: what a board
# gives to the firmware (board.h, "given by the board") and to the start-up (start.h),
# which therefore call up into it. start.h is read by all who keep the contract.
contract='^platform/bare/start$'
given_by_board='^(board_[a-z0-9_]*|machine_(main|print|exit))$'
# ... and a family of CPUs to what all of them share: how it stops for a debugger.
given_by_family='^semihost_call$'
# What a compiler calls on its own is nobody's choice.
given_to_all='^(memcpy|memmove|memset|memcmp|sqrtf)$'

product='engine platform board host_tools'
firmwares=${FIRMWARES-mps2_an386 mps2_an386-wired}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# includes FOLDER ALLOWED: "file:line: header" of every header not allowed.
includes() {
    find "$1" -name '*.[chS]' | sort | xargs awk -v allowed="$2" '
        /^[ \t]*#[ \t]*include/ {
            header = $0
            sub(/^[^"<A-Z]*/, "", header)
            sub(/[ \t].*$/, "", header)
            if (header !~ "^(" allowed ")$") {
                print FILENAME ":" FNR ": " header
            }
        }'
}

freestanding='<(stddef|stdint|stdbool|limits|float|string)\.h>'
verdict "engine includes only itself, freestanding headers and string.h" \
    "$(includes engine "\"engine/.*\"|$freestanding|PLT_LANES")"
verdict "PLT_LANES is named in one place" \
    "$(grep -rln 'include PLT_LANES' engine | grep -v '^engine/lanes/lanes.h$')"
verdict "platform includes only the engine's public headers and itself" \
    "$(includes platform '"engine/planelet[a-z0-9_]*\.h"|"platform/.*"|<.*>')"
verdict "board includes only the engine's public headers, platform and itself" \
    "$(includes board '"engine/planelet[a-z0-9_]*\.h"|"platform/.*"|"board/.*"|<.*>')"
verdict "host_tools includes nothing of tests" \
    "$(includes host_tools '"(engine|platform|board|host_tools)/.*"|<.*>')"
verdict "only programs of the host and tests allocate" \
    "$(grep -rnE '\b(malloc|calloc|realloc|free|alloca|strdup)[[:space:]]*\(' \
        --include='*.[ch]' --exclude-dir=tools engine platform board)"

# ---- the order of folders --------------------------------------------------

# "FROM TO WHAT WHERE" of every include of a file of the project.
# shellcheck disable=SC2086
find $product tests -name '*.[chS]' | sort | xargs awk '
    /^[ \t]*#[ \t]*include[ \t]*"/ {
        split($0, part, "\"")
        print FILENAME, part[2], part[2], FILENAME ":" FNR
    }' >"$work/includes"
# shellcheck disable=SC2086
find $product -name '*.[chS]' | sed 's|/[^/]*$||' | sort -u >"$work/folders"

verdict "every folder of the product is in the table" \
    "$(awk -v table="$table" -v folders=1 -f tests/check/layers.awk "$work/folders")"
verdict "of $(wc -l <"$work/includes") includes none is of a folder above or beside its own" \
    "$(awk -v table="$table" -f tests/check/layers.awk "$work/includes"
    [ -s "$work/includes" ] || echo "there are no includes to look at")"

# ---- circles ---------------------------------------------------------------

# A unit is x.c with x.h.
verdict "no includes form a circle" "$(
    awk -v contract="$contract" '
        $1 ~ /^tests\// { next }
        { sub(/\.[chS]$/, "", $1); sub(/\.[chS]$/, "", $2) }
        $2 !~ contract { print $1, $2, $4 }' "$work/includes" |
        awk -f tests/check/circles.awk)"

# linked NAME FOLDER NM: what the objects in FOLDER refer to.
linked() {
    # shellcheck disable=SC2086
    for object in $(objects_of "$2" o $product); do
        unit=${object#"$2"/}
        "$3" -g "$object" | awk -v unit="${unit%.o}" '
            NF == 2 && $1 == "U" { print "refers", $2, unit }
            NF == 3 { print "defines", $3, unit }'
    done | sort | awk -v given="$given_by_board" -v family="$given_by_family" \
        -v all="$given_to_all" '
        $1 == "defines" { definers[$2] = definers[$2] " " $3; next }
        $2 ~ all { next }
        {
            n = split(definers[$2], definer, " ")
            for (i = 1; i <= n; i++) {
                if (!(definer[i] ~ /^board\// && $2 ~ given) &&
                    !(definer[i] ~ /^platform\// && $2 ~ family)) {
                    print $3, definer[i], $2, $3 ".o"
                }
            }
        }' >"$work/links"
    verdict "$1: of $(wc -l <"$work/links") references none leads to a folder above or beside" "$(
        awk -v table="$table" -f tests/check/layers.awk "$work/links"
        [ -s "$work/links" ] || echo "there are no objects of $2 to look at")"
    verdict "$1: no references form a circle" \
        "$(awk -f tests/check/circles.awk "$work/links")"
}

linked host "$BUILD/host" nm
for firmware in $firmwares; do
    program=${firmware#*-}
    [ "$program" != "$firmware" ] || program=
    make_board "${firmware%%-*}" ${program:+PROGRAM="$program"} &&
        linked "$firmware" "$BUILD/$firmware" arm-none-eabi-nm
done
finish
