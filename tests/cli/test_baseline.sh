#!/bin/sh
# test_baseline.sh - planelet trace and render --baseline: the engine's hits and frames, bit for bit
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin baseline

run make knot -o knot.ply --triangles 1500
run make city -o city.ply
run pack knot.ply -o knot.plt
run pack knot.ply -o list.plt --build none
run pack knot.ply -o device.plt --build device
run pack city.ply -o city.plt --leaf 4
# rays: 500 from a point on a circle to one on another, of no order.
awk 'BEGIN { srand(5); while (i++ < 500) {
    a = 6.28 * rand(); b = 6.28 * rand()
    print 4 * cos(a), 2 * rand() - 1, 4 * sin(a), 0, cos(b) - 4 * cos(a), rand() - 0.5, \
        sin(b) - 4 * sin(a), 1e30 } }' | rays mixed

for scene in knot list device city; do
    for any in '' --any; do
        # shellcheck disable=SC2086
        run trace $scene.plt mixed due.hits $any
        for kind in kd kd-boxes kd-fast kd-lazy bvh wbvh bkd bih bph \
            bvh-treelets bkd-treelets bih-treelets; do
            # shellcheck disable=SC2086
            works "$scene by $kind $any" trace $scene.plt mixed got.hits $any --baseline $kind \
                --json $kind.json
            same due.hits got.hits "... has the hits of the engine"
        done
    done
    cp kd.json $scene.json
done
for kind in kd:8x8 bvh:sah,leaf-4,16x16,early,frustum wbvh:bits,4x4 \
    wbvh:median,leaf-1,no-early,no-frustum bph:naive,single \
    bph:sah,counts,range,left,early,frustum,16x16 bph:leaf-2,recompute,all,mixed,4x4 \
    bkd:exact,sah,single bkd:boxes,range,16x16,early \
    bih:leaf-4,4x4 bih:median,boxes,bits,frustum; do
    run trace city.plt mixed due.hits
    works "city by $kind" trace city.plt mixed got.hits --baseline $kind --json switched.json
    same due.hits got.hits "... has the hits of the engine"
done
works "sorted rays come back as they were" trace city.plt mixed got.hits --order sorted \
    --baseline kd --repeat 3
run trace city.plt mixed due.hits
same due.hits got.hits "... with the same hits"
verdict "its nodes, visits, tests and bytes are counted" "$(
    for kind in kd kd-boxes kd-fast kd-lazy; do
        for count in rays node_visits plane_tests triangle_tests build_work nodes leaves \
            references structure_bytes; do
            [ "$(number $count <$kind.json)" -gt 0 ] || echo "$kind: $count"
        done
    done)"
# ahead: 1024 rays from a point to a square of the city, neighbours beside each other.
awk 'BEGIN { while (i < 1024) {
    x = i % 4 + 4 * int(i / 16) % 32; y = int(i / 4) % 4 + 4 * int(i / 128); i++
    print 30, 40, 30, 0, x - 40, -40, y - 40, 1e30 } }' | rays ahead
run trace city.plt ahead due.hits
for kind in bvh wbvh bkd bih bph bvh-treelets bkd-treelets bih-treelets; do
    works "a view by $kind" trace city.plt ahead got.hits --baseline $kind --json $kind.json
    same due.hits got.hits "... has the hits of the engine"
done
works "a view by kd-trees" trace city.plt ahead got.hits --baseline kd:8x8 --json view.json
same due.hits got.hits "... has the hits of the engine"
verdict "... and of packets what the thesis counts" "$(
    for kind in bvh wbvh bkd bih bph bvh-treelets bkd-treelets bih-treelets; do
        for count in packets packet_node_intersections packet_triangle_intersections \
            thesis_bytes; do
            [ "$(number $count <$kind.json)" -gt 0 ] || echo "$kind: $count"
        done
    done
    [ "$(number packet_node_intersections <view.json)" -gt 0 ] || echo "kd: no nodes of packets"
    [ "$(number packet_triangle_intersections <view.json)" -gt 0 ] || echo "kd: no triangles"
    [ "$(number early_hits <wbvh.json)" -gt 0 ] || echo "wbvh: no early hits"
    [ "$(number frustum_misses <wbvh.json)" -gt 0 ] || echo "wbvh: no frustum misses"
    [ "$(number early_hits <bvh.json)" -eq 0 ] || echo "bvh: early hits")"
works "a view by a BPH of all short cuts" trace city.plt ahead got.hits \
    --baseline bph:early,frustum,recompute --json short.json
same due.hits got.hits "... has the hits of the engine"
verdict "... and what they took is counted" "$(
    for count in early_tests frustum_tests recomputed_boxes plane_matches intermediates; do
        [ "$(number $count <short.json)" -gt 0 ] || echo "$count"
    done
    [ "$(number early_tests <bph.json)" -eq 0 ] || echo "early tests without early hits"
    [ "$(number plane_tests <short.json)" -lt "$(number plane_tests <bph.json)" ] ||
        echo "$(number plane_tests <short.json) plane tests")"
verdict "... walls and boxes have no strays, a lazy tree has cells left, others have none" "$(
    [ "$(number strays <knot.json)" -gt 0 ] || echo "kd: no strays"
    [ "$(number strays <city.json)" -eq 0 ] || echo "kd, across an axis: strays"
    [ "$(number strays <kd-boxes.json)" -eq 0 ] || echo "kd-boxes: strays"
    [ "$(number unsplit <kd-fast.json)" -eq 0 ] || echo "kd-fast: cells"
    [ "$(number unsplit <kd-lazy.json)" -gt 0 ] || echo "kd-lazy: no cells")"
verdict "... and a lazy tree is no larger than the same one built whole" "$(
    [ "$(number nodes <kd-lazy.json)" -lt "$(number nodes <kd-fast.json)" ] ||
        echo "$(number nodes <kd-lazy.json) nodes")"
# ---- render ------------------------------------------------------------------------------

# frames FILE: what says which frames they were.
frames() {
    grep '"frame_hash' "$1"
}
for shader in eyelight normal triangle; do
    run render knot.plt -o due.y4m --size 53x41 --orbit 2 --shader $shader --json due.json
    frames due.json >due.frames
    for kind in kd bvh wbvh:4x4 wbvh:bits,16x16; do
        works "render by $kind, $shader" render knot.plt -o got.y4m --size 53x41 --orbit 2 \
            --shader $shader --baseline $kind --repeat 2 --json got.json
        frames got.json >got.frames
        same due.frames got.frames "... are the engine's frames, by their hashes"
        same due.y4m got.y4m "... and by their pixels"
    done
done
verdict "... with what was traced and counted" "$(
    [ "$(number rays <got.json)" -eq $((2 * 53 * 41)) ] || echo "rays"
    [ "$(number packets <got.json)" -eq 24 ] || echo "$(number packets <got.json) packets"
    for count in seconds packet_node_intersections packet_triangle_intersections masked_out \
        structure_bytes; do
        number $count <got.json | awk '{ exit !($1 > 0) }' || echo "$count"
    done)"
for flag in '--packet 4' '--schedule branch' '--workers 2' '--residency streamed'; do
    # shellcheck disable=SC2086
    misused "render --baseline with $flag" "is for the engine" \
        render knot.plt -o got.ppm --baseline bvh $flag
    # shellcheck disable=SC2086
    misused "trace --baseline with $flag" "is for the engine" \
        trace knot.plt mixed got.hits --baseline bvh $flag
done

# ---- what cannot be ------------------------------------------------------------------------

run pack knot.ply -o compact.plt --nodes compact
refused "lattice triangles are refused" compact.plt "pack it with --nodes thesis" \
    trace compact.plt mixed got.hits --baseline kd
# patch FILE OFFSET: the bytes of standard input.
patch() {
    dd of="$1" bs=1 seek="$2" conv=notrunc 2>dd.said || cat dd.said
}
# crc: of standard input, in four bytes, the least significant first (RFC 1952).
crc() {
    gzip -c | tail -c 8 | head -c 4
}
# at FILE OFFSET: a number of four bytes.
at() {
    od -An -v -t u4 -j "$2" -N 4 "$1" | tr -d ' '
}
# A forged image: its second record has the first one's id, and all checksums are right.
run pack knot.ply -o twice.plt --checks off
section=120 # the second entry of the table: kind, offset, bytes, checksum
records=$(at twice.plt $((section + 4))) bytes=$(at twice.plt $((section + 8)))
tail -c +$((records + 37)) twice.plt | head -c 3 >id # without the bit of its list's end
patch twice.plt $((records + 76)) <id
tail -c +$((records + 1)) twice.plt | head -c "$bytes" | crc >sum
patch twice.plt $((section + 12)) <sum
printf '\000\000\000\000' | patch twice.plt 20
head -c 256 twice.plt | crc >sum
patch twice.plt 20 <sum
works "an image with an id twice is traced" trace twice.plt mixed got.hits
refused "... and no structure is made of it" twice.plt \
    "two triangles have the same id; pack it again" \
    trace twice.plt mixed got.hits --baseline kd-boxes
for flag in '--packet 4' '--walk depth' '--structure grid' '--rays coherent' \
    '--residency streamed' '--workers 2' --turns; do
    # shellcheck disable=SC2086
    misused "--baseline with $flag" "is for the engine" \
        trace knot.plt mixed got.hits --baseline kd $flag
done
misused "another kind" "no structure is called 'bvhs'; choose tree, " \
    trace knot.plt mixed got.hits --baseline bvhs
misused "another switch" "wbvh has no switch 'k4'; choose median, " \
    trace knot.plt mixed got.hits --baseline wbvh:k4
misused "two of a kind" "give one of median or sah" \
    trace knot.plt mixed got.hits --baseline wbvh:sah,4x4,median
run trace --help
cp out help
verdict "the help has every structure with its switches, and says what they mean" "$(
    for line in '  wbvh  *hierarchy' '  kd  *kd-tree' '  *median|sah leaf-1|leaf-2' \
        '  bkd  *B-KD' '  bih  *bounding interval' '  exact  *planes are floats' \
        '  sah  *splits by the surface' '  16x16  *packets of 256' '  single  *rays one'; do
        grep -q -- "^$line" help || echo "no line: $line"
    done)"
finish
