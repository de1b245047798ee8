#!/bin/sh
# test_compact.sh - compact blocks built by a Cortex-M4F in 256 KiB, in QEMU
#
# Reduced landscapes of at least 35,000 (two per list) and 45,000 triangles (four)
# are built and rendered by the firmware; the picture is that of the host, which
# builds the same image, and that of the image which the host has built.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
planelet=$BUILD/host/planelet
out=$BUILD/mps2_an386/tests
mkdir -p "$out"
needs arm-none-eabi-gcc qemu-system-arm && make_board mps2_an386 || { finish; exit; }

value() { # NAME: of the first NAME=value in the text
    echo "$text" | tr ' ' '\n' | sed -n "s/^$1=//p" | head -n 1
}

# scene NAME [pack option ...]: of the landscape, on a lattice of 14 bits.
scene() {
    name=$1
    shift
    "$planelet" pack "$out/landscape.ply" -o "$out/$name.plt" --nodes compact \
        --geometry lattice:14 "$@" >/dev/null 2>"$out/$name.txt" ||
        verdict "$name is packed" "$(cat "$out/$name.txt")"
}

# built K LEAST MOST: what the firmware builds and renders.
built() {
    scene "compact$1" --leaf "$1" --reduce "$3" --build device
    scene "host$1" --leaf "$1" --reduce "$3" --numbers none
    view=$(sh board/tools/host_view.sh "$out/compact$1.plt" 320x240 "$out/host.ppm" --view box)
    whole=$(sh board/tools/host_view.sh "$out/host$1.plt" 320x240 "$out/host.ppm" --view box)
    # shellcheck disable=SC2086
    text=$(sh board/mps2_an386/run.sh "$out/compact$1.plt" size=320x240 ${view#* } \
        "frame=$out/device.ppm" 2>&1)
    status=$?
    triangles=$(value triangles)
    verdict "$1 per list: $triangles triangles, $2 or more, are built in $(value bytes) bytes" "$(
        [ "$status" -eq 0 ] || echo "status $status: $text"
        [ "${triangles:-0}" -ge "$2" ] || echo "$triangles triangles"
        [ "$(value bytes)" -eq 262144 ] || echo "an arena of $(value bytes) bytes")"
    verdict "... and rendered at 320x240: hash and picture are the host's" "$(
        [ "$(value frame_hash)" = "${view%% *}" ] ||
            echo "$(value frame_hash) on the device, ${view%% *} on the host"
        [ "${whole%% *}" = "${view%% *}" ] || echo "${whole%% *} of the image built by the host"
        [ "$(tail -c 230400 "$out/host.ppm" | cksum)" = \
            "$(tail -c 230400 "$out/device.ppm" | cksum)" ] || echo "the pixels differ")"
    # What the peak is made of: the image, the engine with its scratch, one block.
    info=$("$planelet" info "$out/host$1.plt" --json)
    image=$(echo "$info" | sed -n 's/^  "\(tree\|geometry\)_bytes": \([0-9]*\),$/\2/p' |
        awk '{ s += $1 } END { print s }')
    verdict "... the peak is the finished image, scratch and at most a block: $(value peak)" "$(
        [ "$(value peak)" -le "$((image + 33000))" ] || echo "$(value peak), image $image")"
    verdict "... the stack stays below its bound" "$(
        [ "$(value painted)" -gt 0 ] && [ "$(value painted)" -le "$(value worst)" ] ||
            echo "painted $(value painted), bound $(value worst)")"
    echo "$text" | awk -v k="$1" -v n="$triangles" -v image="$image" '
        /^instructions total/ { split($3, open, "="); split($4, render, "=") }
        /^arena / { split($3, peak, "=") }
        END {
            printf "    %d per list: %d triangles, %.3f bytes each; ", k, n, image / n
            printf "peak %d; ", peak[2]
            printf "%.0f instructions per triangle to build, ", open[2] / n
            printf "%.0f per pixel to render\n", render[2] / 76800
        }'
}

"$planelet" make terrain --triangles 100000 -o "$out/landscape.ply" >/dev/null ||
    verdict "the landscape is made" "planelet failed"
built 2 35000 36000
built 4 45000 46000

scene toomany --reduce 60000 --build device
text=$(sh board/mps2_an386/run.sh "$out/toomany.plt" size=32x24 2>&1)
status=$?
verdict "too many triangles for the arena: status 1, the bytes they need" "$(
    [ "$status" -eq 1 ] || echo "status $status: $text"
    echo "$text" | grep -q '^error: .*need_bytes=[1-9]' || echo "$text")"
finish
