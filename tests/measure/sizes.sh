#!/bin/sh
# sizes.sh - what the engine costs: code, constants, data, stack, arena, steps, structures
#
# Builds and runs the boards of ON, all if it is not given, and the PARTS of OF, which are rows of
# tests/golden/parts.csv ("render thesis, render compact frames"; all of them); `none` is none, and
# words without a row there end in status 2.
# Prints tables and how they differ from those of tests/golden/, and leaves boards.csv, parts.csv
# and structures.csv in build/sizes/. Fails above the budget (budget.awk), when a frame is not the
# host's, when the engine has data or bss, or when its worst stack is not known.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
export BUILD
. tests/boards/rows.sh
arm=$BUILD/mps2_an386 results=$BUILD/sizes
failures=0
mkdir -p "$results"

# of: the PARTS to build, a line of words each. Fails, naming what there is, if words have no row.
of() {
    if [ -z "$OF" ]; then
        all_parts
        return
    fi
    all_parts >"$results/rows.txt"
    echo "$OF" | tr ',' '\n' | sed 's/^ *//; s/ *$//' | awk -v rows="$results/rows.txt" '
        BEGIN { while ((getline row <rows) > 0) { there[row]; names = names ", " row } }
        $0 in there { print; next }
        {
            print "error: OF: tests/golden/parts.csv has no row \047" $0 "\047; it has" \
                substr(names, 2) >"/dev/stderr"
            wrong = 2
        }
        END { exit wrong }'
}
if [ "$OF" != none ]; then
    of >"$results/parts.txt" || exit 2
fi

# sizes_of FOLDER SIZE: bytes of every engine object in FOLDER and their sum. Fails on data, bss, or
# no object.
sizes_of() {
    objects_of "$1" o engine | xargs -r "$2" | awk -v folder="$1/" '
        $1 !~ /^[0-9]+$/ { next }
        {
            name = $6
            sub(folder, "", name)
            printf "%8d %8d %8d  %s\n", $1, $2, $3, name
            code += $1; data += $2; bss += $3
        }
        END {
            printf "%8d %8d %8d  in all\n", code, data, bss
            if (data + bss > 0) { print "error: the engine has data or bss"; exit 1 }
            if (code == 0) { print "error: there is no engine object in " folder; exit 1 }
        }'
}

# table TITLE FOLDER SIZE
table() {
    echo "$1"
    printf "%8s %8s %8s\n" code data bss
    sizes_of "$2" "$3" || failures=1
    echo
}

# The sizes of structures, from the types alone: an array as long as the
# structure, whose size nm prints.
structures() {
    source=$(mktemp) object=$(mktemp)
    echo '#include "engine/planelet.h"' >"$source"
    awk '/^} plt_[a-z_]+;/ { sub(/;.*/, "", $2)
        print "extern char " $2 "_size[]; char " $2 "_size[sizeof(" $2 ")];" }' \
        engine/planelet.h >>"$source"
    "$1" -x c -std=c11 -I. -c -fno-common -o "$object" "$source" &&
        "$2" -S "$object" | awk '/_size$/ { sub(/_size$/, "", $4); print $4, $2 }'
    rm -f "$source" "$object"
}

# size_of TYPE: bytes of a type of trace/packet.h, on the Cortex-M4F.
size_of() {
    object=$(mktemp)
    printf '#include "engine/trace/packet.h"\nextern char size[]; char size[sizeof(%s)];\n' "$1" |
        arm-none-eabi-gcc -x c -std=c11 -I. -c -fno-common -o "$object" - &&
        arm-none-eabi-nm -S "$object" | awk '$4 == "size" { print "0x" $2 }'
    rm -f "$object"
}

# fault SENTENCE: of a board or of parts, which then has no row.
fault() {
    echo "error: $1" >&2
    failures=1
}
# shown NAME: the columns of a table below each other, and what differs from the one that is kept.
shown() {
    sed 's/,/, /g' "$results/$1.csv" | awk -F ', ' '
        NR == 1 { for (i = 1; i <= NF; i++) { head[i] = $i } next }
        {
            printf "%s:", $1
            for (i = 2; i <= NF; i++) {
                printf "%s %s %s", i == 2 ? "" : ",", head[i], $i == "" ? "-" : $i
            }
            printf "\n"
        }'
    differences=$(awk -f tests/boards/budget.awk "tests/golden/$1.csv" "$results/$1.csv" ||
        echo "error: not compared")
    echo "beside tests/golden/$1.csv: ${differences:-no difference}"
    echo
    echo "$differences" | grep -q '^error' && failures=1
}

if [ "$ON" != none ]; then
    scene_of knot_600 600 || fault "no knot of 600 triangles"
    knot=$scene
    echo "$boards_header" >"$results/boards.csv"
    for board in ${ON:-$(boards)}; do
        built=$BUILD/$board text=
        make_board "$board" && board_row "$knot" >>"$results/boards.csv" && [ "$status" -eq 0 ] ||
            fault "$board: ${text:-not built}"
    done
    echo "boards, each with its parts: a knot of 600 triangles, 80x60"
    shown boards
fi
if [ "$OF" != none ]; then
    echo "$parts_header" >"$results/parts.csv"
    while read -r words; do
        built=$(folder_of "$words") text=
        make_board mps2_an386 PARTS="$([ "$words" = all ] || echo "$words")" &&
            parts_row "$words" >>"$results/parts.csv" && [ "$status" -eq 0 ] ||
            fault "$words: ${text:-not built}"
    done <"$results/parts.txt"
    echo "PARTS, Cortex-M4F: a knot of 2,000 triangles, 80x60"
    shown parts
fi

make_board mps2_an386 || exit 1
table "engine, x86-64 or what this host is, -O3, SSE where there is" "$BUILD/host" size
table "engine, Cortex-M4F, -O2, scalar lanes" "$arm" arm-none-eabi-size

echo "worst C stack of the Cortex-M4F, bytes: frame by frame"
sed -n 's/^worst \([0-9]*\).*/\1 from start-up, the board and the source included/p;/^ /p' \
    "$arm/stack.txt"
echo "worst C stack of each public function (functions of a source not counted)"
board=mps2_an386 built=$arm
stacks >"$results/stacks.txt"
awk '/^error/ { print; next } { printf "%8d %s\n", $1, $2 }' "$results/stacks.txt"
grep -q '^[0-9]' "$results/stacks.txt" && ! grep -q '^error' "$results/stacks.txt" || failures=1
echo
echo "packets, bytes per ray: slabs $(($(size_of plt_group_slabs) / 4)), rays and hits $(($(
    size_of plt_group_rays) / 4))"
echo
echo "the largest structures, bytes, Cortex-M4F"
structures_csv >"$results/structures.csv"
shown structures
echo "public structures, bytes: here, Cortex-M4F"
structures arm-none-eabi-gcc arm-none-eabi-nm >"$results/structures.txt"
structures "$CC" nm | while read -r name size; do
    while read -r other bytes; do
        [ "$name" = "$other" ] && printf '%8d %8d  %s\n' "0x$size" "0x$bytes" "$name"
    done <"$results/structures.txt"
done
exit $failures
