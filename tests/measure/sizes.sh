#!/bin/sh
# sizes.sh - what the engine costs: code, data, stack, structures
#
# Fails when the engine has data or bss, or when its worst stack is not known.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
arm=$BUILD/mps2_an386
status=0

# sizes_of FOLDER SIZE [NAME]: bytes of every engine object in FOLDER and their sum; with
# a NAME the sum alone, in a line that ends in it. Fails on data, bss, or no object.
sizes_of() {
    objects_of "$1" o engine | xargs -r "$2" | awk -v folder="$1/" -v brief="${3:-}" '
        $1 !~ /^[0-9]+$/ { next }
        {
            name = $6
            sub(folder, "", name)
            if (brief == "") { printf "%8d %8d %8d  %s\n", $1, $2, $3, name }
            code += $1; data += $2; bss += $3; files++
        }
        END {
            printf "%8d %8d %8d  in all", code, data, bss
            if (brief != "") { printf ", %d files: %s", files, brief }
            printf "\n"
            if (data + bss > 0) { print "error: the engine has data or bss"; exit 1 }
            if (code == 0) { print "error: there is no engine object in " folder; exit 1 }
        }'
}

# table TITLE FOLDER SIZE
table() {
    echo "$1"
    printf "%8s %8s %8s\n" code data bss
    sizes_of "$2" "$3" || status=1
    echo
}

# totals TITLE SIZE FOLDER...: a line for each folder that is there.
totals() {
    echo "$1"
    printf "%8s %8s %8s\n" code data bss
    size=$2
    shift 2
    for folder in "$@"; do
        [ ! -d "$folder/engine" ] || sizes_of "$folder" "$size" "${folder#"$BUILD"/}" || status=1
    done
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

table "engine, x86-64 or what this host is, -O3, SSE where there is" "$BUILD/host" size
if [ ! -e "$arm/firmware.elf" ]; then
    echo "sizes: no firmware of mps2_an386; run: make setup" >&2
    exit 1
fi
table "engine, Cortex-M4F, -O2, scalar lanes" "$arm" arm-none-eabi-size
# Firmware of the same engine but for another program (wired, played) is not another engine.
parts=
for folder in "$arm"-*; do
    case $folder in
    "$arm-wired" | "$arm-played"*) ;;
    *) parts="$parts $folder" ;;
    esac
done
# shellcheck disable=SC2086
totals "the whole engine and parts of it, Cortex-M4F" arm-none-eabi-size "$arm" $parts

echo "worst C stack of the Cortex-M4F, bytes: frame by frame"
sed -n 's/^worst \([0-9]*\).*/\1 from start-up, the board and the source included/p;/^ /p' \
    "$arm/stack.txt"
echo "worst C stack of each public function (functions of a source not counted)"
lines=$(stack_of "$arm" "engine platform/bare platform/cortex_m" -v root="$(public_functions)" \
    -v outward=1) || status=1
printf '%s\n' "$lines" | awk '
    /^error/ { print }
    /^(worst|root)/ { printf "%8d %s\n", $2, $3 }' | sort -rn
echo
echo "packets, bytes per ray: slabs $(($(size_of plt_group_slabs) / 4)), rays and hits $(($(
    size_of plt_group_rays) / 4))"
echo
echo "public structures, bytes: here, Cortex-M4F"
structures arm-none-eabi-gcc arm-none-eabi-nm >"$arm/structures.txt"
structures "$CC" nm | while read -r name size; do
    while read -r other bytes; do
        [ "$name" = "$other" ] && printf '%8d %8d  %s\n' "0x$size" "0x$bytes" "$name"
    done <"$arm/structures.txt"
done
exit $status
