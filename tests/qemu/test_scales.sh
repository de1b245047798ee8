#!/bin/sh
# test_scales.sh - boards with vectors render the host's frame, at any scale of the scene
#
# Such vectors may flush subnormals, where the host keeps them (DESIGN.md, 8.2). By groups of four
# rays, as frames by beams use no lanes: a sheet of which some coordinates are tiny, or subnormal,
# at five scales; with the board's lanes and with scalar ones. And what they take per ray.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
export BUILD
planelet=$BUILD/host/planelet
folder=$BUILD/scales
mkdir -p "$folder"

sheet() { # SCALE: 24 x 24 squares; heights, and what is added to the zeros of their middle, vary
    awk -v s="$1" 'BEGIN {
        n = 24
        for (j = 0; j <= n; j++) {
            for (i = 0; i <= n; i++) {
                x = i - n / 2
                y = j - n / 2
                z = 3 * sin(i * 0.7) * cos(j * 0.9)
                if (i % 3 == 0) { z = z * 1e-22 }
                if (i % 3 == 1) { z = z * 1e-12 }
                printf "v %.9g %.9g %.9g\n", s * (x == 0 ? 1e-30 * (j + 1) : x),
                    s * (y == 0 ? 1e-20 * i : y), s * z
            }
        }
        for (j = 0; j < n; j++) {
            for (i = 1; i <= n; i++) {
                a = j * (n + 1) + i
                print "f " a, a + 1, a + n + 2
                print "f " a, a + n + 2, a + n + 1
            }
        }
    }'
}

value() { # NAME
    echo "$text" | sed -n "s/^$1[ =]//p" | tail -n 1
}

boards_with_lanes=0
for board in $(boards); do
    grep -q '^LANES := scalar' "board/$board/board.mk" && continue
    needs "$(cross_of "$board")gcc" || continue
    boards_with_lanes=$((boards_with_lanes + 1))
    parts='render thesis'
    make_board "$board" PARTS="$parts" || continue
    make_board "$board" PARTS="$parts" LANES=scalar BUILD="$BUILD/scalar-lanes" || continue
    own=$BUILD/$board-render-thesis
    scalar=$BUILD/scalar-lanes/$board-render-thesis
    for scale in 1 1e-6 1e6 1e-12 1e-20; do
        sheet "$scale" >"$folder/sheet.obj"
        "$planelet" pack "$folder/sheet.obj" -o "$folder/sheet.plt" >/dev/null 2>"$folder/said" ||
            verdict "a sheet of scale $scale is packed" "$(cat "$folder/said")"
        for firmware in "$own" "$scalar"; do
            kind=$([ "$firmware" = "$own" ] && echo "its lanes" || echo "scalar lanes")
            text=$(FIRMWARE=$firmware QEMU_SECONDS=100 sh board/tools/run_like_host.sh "$board" \
                "$folder/sheet.plt" 64x48 2>&1)
            verdict "$board, $kind, scale $scale: the host's frame, \
$(value instructions_per_ray) instructions per ray" "$(
                echo "$text" | grep -q '^the host renders the same frame' || echo "$text")"
        done
    done
    "$planelet" make knot --triangles 20000 -o "$folder/knot.ply" >/dev/null &&
        "$planelet" pack "$folder/knot.ply" -o "$folder/knot.plt" >/dev/null
    text=$(FIRMWARE=$own sh board/tools/run_like_host.sh "$board" "$folder/knot.plt" 160x120 2>&1)
    with=$(value instructions_per_ray)
    verdict "$board: a knot is the host's, too" "$(
        echo "$text" | grep -q '^the host renders the same frame' || echo "$text")"
    text=$(FIRMWARE=$scalar sh board/tools/run_like_host.sh "$board" "$folder/knot.plt" 160x120 \
        2>&1)
    without=$(value instructions_per_ray)
    verdict "$board: groups take $with instructions per ray, $without with scalar lanes: at most \
0.45 of them" "$(awk -v a="$with" -v b="$without" 'BEGIN { exit !(a > 0 && a <= 0.45 * b) }' ||
        echo "more")"
done
verdict "boards with lanes were tried: $boards_with_lanes" "$(
    [ "$boards_with_lanes" -ge 1 ] || echo "none")"
rm -rf "$folder"
finish
