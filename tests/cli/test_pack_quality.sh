#!/bin/sh
# test_pack_quality.sh - pack --quality high: a better tree of the same triangles, and its figures
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin pack_quality
run make room --triangles 30000 -o room.ply

# member PATH FILE: that value.
member() {
    awk -f "$CLI_TESTS/json.awk" "$2" | awk -F '\t' -v path="$1" '$1 == path { print $2 }'
}

works "pack --quality fast" pack room.ply -o fast.plt --quality fast --json fast.json
works "... which is the default" pack room.ply -o default.plt
same fast.plt default.plt "... byte for byte"
verdict "... has no figures of quality" "$(
    [ "$(member .quality fast.json)" = null ] || cat fast.json)"
works "pack --quality high" pack room.ply -o high.plt --quality high --json high.json
works "... a second time" pack room.ply -o again.plt --quality high
same high.plt again.plt "... gives the same bytes"
verdict "... JSON" "$(awk -f "$CLI_TESTS/json.awk" high.json | grep '^wrong')"
verdict "... and says what it gained" "$(
    before=$(member .quality.boxes_per_line_before high.json)
    after=$(member .quality.boxes_per_line high.json)
    echo "$before $after" | awk '{ exit !($2 > 1 && $2 < 0.8 * $1) }' || echo "$before to $after"
    [ "$(member .quality.passes high.json)" -ge 2 ] || echo "passes"
    [ "$(member .quality.moves high.json)" -ge 1000 ] || echo "moves"
    [ "$(member .quality.out_of_time high.json)" = false ] || echo "out of time")"
works "a median tree gets better, too" pack room.ply -o median.plt --splits median --quality high \
    --json median.json
verdict "... by more" "$(
    before=$(member .quality.boxes_per_line_before median.json)
    after=$(member .quality.boxes_per_line median.json)
    echo "$before $after" | awk '{ exit !($2 < 0.6 * $1) }' || echo "$before to $after")"

for geometry in lattice:16 float; do
    run pack room.ply -o compact.plt --nodes compact --geometry $geometry
    run pack room.ply -o better.plt --nodes compact --geometry $geometry --quality high \
        --json better.json
    verdict "compact blocks, $geometry: a better tree" "$(
        [ "$status" -eq 0 ] || cat err
        before=$(member .quality.boxes_per_line_before better.json)
        after=$(member .quality.boxes_per_line better.json)
        echo "$before $after" | awk '{ exit !($2 > 1 && $2 < 0.8 * $1) }' ||
            echo "$before to $after")"
    for image in compact better; do
        run render $image.plt -o $image.ppm --size 160x120 --eye 2.7,1.6,2.1 \
            --look -0.9,0.72,-0.7 --fov 60 --shader triangle
    done
    same compact.ppm better.ppm "... and the frame is the same, triangle by triangle"
done
run pack room.ply -o median.plt --nodes compact --geometry float --splits median --quality high \
    --json compact_median.json
verdict "compact blocks of a median tree begin with that, not with the other" "$(
    [ "$status" -eq 0 ] || cat err
    sah=$(member .quality.boxes_per_line_before better.json)
    median=$(member .quality.boxes_per_line_before compact_median.json)
    after=$(member .quality.boxes_per_line compact_median.json)
    echo "$sah $median $after" | awk '{ exit !($2 > 1.2 * $1 && $3 < 0.6 * $2) }' ||
        echo "$sah with sah; $median to $after with median")"
works "compact blocks of several meshes" pack room.ply room.ply -o two.plt --nodes compact \
    --geometry float --quality high
works "... are an image" info two.plt

# ---- the same hits, with fewer visits ------------------------------------------------------------

view='--eye 2.7,1.6,2.1 --look -0.9,0.72,-0.7 --fov 60'
for image in fast high; do
    # shellcheck disable=SC2086
    {
        run render $image.plt -o $image.ppm --size 160x120 $view
        run bench $image.plt --size 64x64 --repeat 1 --packets 8 $view --json $image.bench
    }
done
same fast.ppm high.ppm "the frame is the same"
# figure FIELD FILE: of every row, after its kind, hit and walk.
figure() {
    key='"kind": "\([a-z]*\)", "hit": "\([a-z]*\)".*"walk": "\([a-z-]*\)"'
    sed -n "s/.*$key.*\"$1\": \"*\([0-9a-f]*\).*/\1 \2 \3 \4/p" "$2"
}
figure hits_hash fast.bench >fast.hits
figure hits_hash high.bench >high.hits
same fast.hits high.hits "hits of seven kinds of rays are the same, bit for bit"
verdict "... of $(wc -l <high.hits) rows" "$([ "$(wc -l <high.hits)" -eq 56 ] || cat high.hits)"
verdict "... and the closest take fewer visits in the wave" "$(
    figure node_visits fast.bench >fast.visits
    figure node_visits high.bench | paste -d ' ' fast.visits - |
        awk '$2 == "closest" && $3 == "wave" && $8 > 0.85 * $4')"

# ---- time ----------------------------------------------------------------------------------------

run make room --triangles 3000000 -o large.ply
began=$(date +%s)
works "--quality-time 1 of a large room" pack large.ply -o large.plt --quality high \
    --quality-time 1 --json large.json
verdict "... is soon over" "$(
    took=$(($(date +%s) - began))
    seconds=$(member .quality.seconds large.json)
    echo "$seconds" | awk '{ exit !($1 < 20) }' || echo "$seconds s of $took s"
    [ "$(member .quality.out_of_time large.json)" = true ] || cat large.json)"
works "... and a tree" info large.plt
rm -f large.ply large.plt
finish
