#!/bin/sh
# test_sequence.sh - pack --sequence and render --frames: frames that an image holds
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/wave.sh
begin sequence
waves 9
echo 'wave_{}.ply*9 1 0 0 0' >wave.txt
view='--size 61x47 --eye 1,1.5,3 --look 0.2,0,0.2'

# alone FRAME...: pictures of frames that are packed alone, from wave.txt or by name, without
# the header of a Y4M.
alone() {
    for frame in "$@"; do
        "$PLANELET" pack wave_00$frame.ply -o fresh.plt 2>/dev/null
        # shellcheck disable=SC2086
        "$PLANELET" render fresh.plt -o fresh.y4m $view 2>/dev/null
        tail -n +2 fresh.y4m
    done
}

# ---- the same pictures ------------------------------------------------------------------

works "a list of meshes" pack --sequence wave_00?.ply --geometry float -o list.plt --json pack.json
verdict "... what is packed is told" "$(
    [ "$(number frames <pack.json)" = 9 ] || cat pack.json)"
works "a name with {}" pack --sequence 'wave_{}.ply' --frames 0:9 --geometry float -o name.plt
same list.plt name.plt "... is the same image"
"$PLANELET" pack wave_000.ply --checks off -o plain.plt 2>/dev/null
verdict "... which has the sections of the first frame packed alone" "$(
    size=$(($(wc -c <plain.plt) - 256))
    tail -c +257 plain.plt >one
    tail -c +257 list.plt | head -c "$size" | cmp - one)"
# shellcheck disable=SC2086
for kind in '' '--source read' '--workers 3' '--walk two-stage' '--packet 2' '--records never' \
    '--records never --source read --walk two-stage' '--beside --packet 16 --workers 3'; do
    works "frames 0 to 8 $kind" render list.plt -o all.y4m --frames 0:9 $view $kind
    tail -n +2 all.y4m >all.frames
    alone 0 1 2 3 4 5 6 7 8 >due.frames
    same due.frames all.frames "... are the pictures of the frames packed alone"
done
# shellcheck disable=SC2086
works "some of them" render list.plt -o some.y4m --frames 5:7 $view
tail -n +2 some.y4m >some.frames
alone 5 6 >due.frames
same due.frames some.frames "... are theirs"
# shellcheck disable=SC2086
works "statistics of them" render list.plt --frames 5:7 $view --json some.json
verdict "... have the hash of each frame, and that of all" "$(
    for frame in 5 6; do
        "$PLANELET" render list.plt --frames $frame:$((frame + 1)) $view --json one.json 2>/dev/null
        sed -n 's/^  "frame_hash": \(.*\),$/\1/p' one.json
    done | paste -s -d , | sed 's/,/, /; s/.*/  "frame_hashes": [&],/' >hashes
    grep '"frame_hashes"' some.json | cmp hashes - 2>&1
    [ "$(grep -c '"frame_hash"' some.json)" -eq 1 ] || cat some.json)"
# shellcheck disable=SC2086
works "... and without records" render list.plt --frames 5:7 $view --json never.json --records never
verdict "... the same hashes, and say so" "$(
    grep '"frame_hashes"' never.json | cmp hashes - 2>&1
    [ "$(number over_vertices <never.json) $(number beside <never.json)" = '1 0' ] || cat never.json
    [ "$(number over_vertices <some.json) $(number beside <some.json)" = '0 0' ] || cat some.json)"
# shellcheck disable=SC2086
works "... and with nodes beside" render list.plt --frames 5:7 $view --json beside.json --beside
verdict "... likewise" "$(
    grep '"frame_hashes"' beside.json | cmp hashes - 2>&1
    [ "$(number over_vertices <beside.json) $(number beside <beside.json)" = '1 1' ] ||
        cat beside.json)"
works "a picture per frame" render list.plt -o 'picture_{}.ppm' --frames 3:6 $view
for frame in 3 4 5; do
    "$PLANELET" pack wave_00$frame.ply -o fresh.plt 2>/dev/null
    # shellcheck disable=SC2086
    "$PLANELET" render fresh.plt -o fresh.ppm $view
    same fresh.ppm picture_00$frame.ppm "... the one of frame $frame"
done
verdict "... and no others" "$(ls picture_* | grep -v '_00[345].ppm$')"
# shellcheck disable=SC2086
works "of one frame, too, as jobs render that share the work" \
    render list.plt -o 'single_{}.ppm' --frames 4:5 $view
same single_004.ppm picture_004.ppm "... the same, with its number"
# shellcheck disable=SC2086
works "without --frames" render list.plt -o first.ppm $view
# shellcheck disable=SC2086
works "... and without the frames" render plain.plt -o plain.ppm $view
same plain.ppm first.ppm "... it is the first frame"
works "a recipe" pack --sequence wave.txt --frames 2:5 --geometry float -o recipe.plt
# shellcheck disable=SC2086
works "... shown" render recipe.plt -o recipe.y4m --frames 0:3 $view
for frame in 2 3 4; do
    "$PLANELET" pack wave.txt --frame $frame -o fresh.plt 2>/dev/null
    # shellcheck disable=SC2086
    "$PLANELET" render fresh.plt -o fresh.y4m $view 2>/dev/null
    tail -n +2 fresh.y4m
done >due.frames
tail -n +2 recipe.y4m >recipe.frames
same due.frames recipe.frames "... is its frames"

# ---- compact blocks -------------------------------------------------------------------------

works "thesis nodes on a lattice" pack --sequence wave_00?.ply --geometry lattice:14 -o thesis.plt
for kind in '' '--numbers none' '--leaf 4' '--quality high' '--splits median --key 2'; do
    # shellcheck disable=SC2086
    works "compact blocks $kind" pack --sequence wave_00?.ply --geometry lattice:14 \
        --nodes compact $kind -o blocks.plt
    for how in '' '--source read' '--workers 3' '--packet 4'; do
        # shellcheck disable=SC2086
        works "... shown $how" render blocks.plt -o blocks.y4m --frames 0:9 $view $how
        # shellcheck disable=SC2086
        works "... and records" render thesis.plt -o thesis.y4m --frames 0:9 $view $how
        same thesis.y4m blocks.y4m "... the same pictures"
    done
done
verdict "info tells what of blocks moves" "$(
    "$PLANELET" info blocks.plt --json >json
    grep -q '"geometry_format": "moving"' json && [ "$(number frames <json)" = 9 ] || cat json)"
# shellcheck disable=SC2086
works "without --frames" render blocks.plt -o first.ppm $view
# shellcheck disable=SC2086
works "... of records" render thesis.plt -o plain.ppm $view
same plain.ppm first.ppm "... it is the first frame"

for kind in '' '--numbers none --leaf 4'; do
    # shellcheck disable=SC2086
    works "stills $kind" pack --sequence wave_00?.ply --geometry lattice:14 --nodes compact \
        --stills $kind -o stills.plt
    for how in '' '--arena 262144' '--schedule batch'; do
        # shellcheck disable=SC2086
        works "... streamed $how" render stills.plt -o stills.y4m --residency streamed \
            --frames 0:9 $view $how
        # shellcheck disable=SC2086
        works "... and records" render thesis.plt -o thesis.y4m --frames 0:9 $view
        same thesis.y4m stills.y4m "... the same pictures"
    done
done
# shellcheck disable=SC2086
works "stills without --frames" render stills.plt -o first.ppm $view
same plain.ppm first.ppm "... are the first frame"
works "info of stills" info stills.plt
verdict "... says what each takes, and of no key frames or topology" "$(
    "$PLANELET" info stills.plt >text
    "$PLANELET" info stills.plt --json >json
    each=$(($(number tree_bytes <json) + $(number geometry_bytes <json)))
    grep -q "^frame bytes  *$each each, of tree and geometry\$" text || cat text
    grep -E '^(key frames|topology|arena with frames)' text
    [ "$(number topology_bytes <json)" -eq 0 ] || cat json)"

# ---- a lattice, rates, key frames ---------------------------------------------------------

works "a lattice" pack --sequence wave_00?.ply -o lattice.plt --rate 30 --key 4
verdict "... is the default, and info tells it all" "$(
    "$PLANELET" info lattice.plt >text
    "$PLANELET" info lattice.plt --json >json
    grep -q '^sequence  *9 frames, 30 per second, of 81 vertices, on a lattice of 16 bits$' text &&
        grep -q '^key frames  *every 4$' text || cat text
    flat_json json frames vertices frame_rate key_every frame_bytes frame_bytes_per_vertex \
        topology_bytes
    [ "$(number vertices <json)" = 81 ] && [ "$(number key_every <json)" = 4 ] || cat json)"
# shellcheck disable=SC2086
works "... its pictures" render lattice.plt -o lattice.y4m --frames 0:9 $view
verdict "... come at that rate" "$(
    head -n 1 lattice.y4m | grep -q 'F30:1' || head -n 1 lattice.y4m)"
# On a lattice of powers of two, that all coordinates are on, no vertex moves.
for frame in 0 1 2 3; do
    awk 'NF == 3 && $1 ~ /^[-.0-9]/ {
            printf "%.6f %.6f %.6f\n", int($1 * 64) / 64, int($2 * 64) / 64, int($3 * 64) / 64
            next } { print }' wave_00$frame.ply >even_00$frame.ply
done
works "coordinates in 64ths" pack --sequence even_00?.ply -o even.plt
works "... as floats" pack --sequence even_00?.ply --geometry float -o floats.plt
# shellcheck disable=SC2086
works "... shown" render even.plt -o even.y4m --frames 0:4 $view
# shellcheck disable=SC2086
works "... both" render floats.plt -o floats.y4m --frames 0:4 $view
same floats.y4m even.y4m "... are the same pictures"
verdict "... and half the bytes, or less" "$(
    even=$("$PLANELET" info even.plt --json | number frame_bytes)
    floats=$("$PLANELET" info floats.plt --json | number frame_bytes)
    [ $((2 * even)) -le "$floats" ] || echo "$even and $floats")"
works "more bits" pack --sequence wave_00?.ply --geometry lattice:20 -o fine.plt
works "... by a tolerance" pack --sequence wave_00?.ply --tolerance 1e-4 -o coarse.plt
verdict "... are what was asked for" "$(
    [ "$("$PLANELET" info fine.plt --json | number lattice_bits)" = 20 ] || echo fine
    [ "$("$PLANELET" info coarse.plt --json | number lattice_bits)" = 14 ] || {
        echo coarse; "$PLANELET" info coarse.plt; })"
works "meshes far from the origin" pack --sequence wave_00?.ply --geometry float \
    --origin 0.5,0,0.25 -o moved.plt
verdict "... are all moved" "$(
    "$PLANELET" info moved.plt | grep -q '^shift  *(0.5, 0, 0.25)' || "$PLANELET" info moved.plt)"
works "... and shown" render moved.plt -o x.ppm --frames 8:9 --size 8x8
works "a tree that the engine builds" pack --sequence wave_00?.ply --geometry float --build device \
    -o device.plt
# shellcheck disable=SC2086
works "... shows the frames" render device.plt -o device.y4m --frames 0:9 $view
same all.y4m device.y4m "... as they are"
works "a better tree" pack --sequence wave_00?.ply --geometry float --quality high -o high.plt
# shellcheck disable=SC2086
works "... shows them" render high.plt -o high.y4m --frames 0:9 $view
same all.y4m high.y4m "... as they are"

# ---- one tree for all frames --------------------------------------------------------------

works "a tree for all frames" pack --sequence wave_00?.ply --geometry float --tree-for all \
    -o tree.plt --json tree.json
# shellcheck disable=SC2086
works "... shows them" render tree.plt -o tree.y4m --frames 0:9 $view
same all.y4m tree.y4m "... as they are"
works "... a second time" pack --sequence wave_00?.ply --geometry float --tree-for all \
    -o again.plt
same tree.plt again.plt "... is the same image"
verdict "... of 8 frames, it says" "$(
    grep -A 1 '"quality"' tree.json | grep -q '"frames": 8,' || cat tree.json)"
works "... of one frame" pack --sequence wave_00?.ply --geometry float -o first.plt \
    --tree-for first
same list.plt first.plt "... is the one that is the default"
works "... of two" pack --sequence wave_00[07].ply --tree-for all -o two.plt --json two.json
verdict "... likewise" "$(grep -A 1 '"quality"' two.json | grep -q '"frames": 2,' || cat two.json)"
for frame in 0 20 40 60 80 100; do
    run make city --frame $frame -o city_$frame.ply
done
set -- city_0.ply city_20.ply city_40.ply city_60.ply city_80.ply city_100.ply
for tree in first all; do
    works "people who leave a lift, --tree-for $tree" pack --sequence "$@" -o city_$tree.plt \
        --tree-for $tree
    run render city_$tree.plt -o city_$tree.y4m --frames 0:6 --size 160x120 --eye 60,80,120 \
        --look 0,20,0 --json city_$tree.json
done
same city_first.y4m city_all.y4m "... are the same pictures"
verdict "... for a tenth fewer visits with one tree for all" "$(
    first=$(number node_visits <city_first.json) all=$(number node_visits <city_all.json)
    [ "$first" -gt 0 ] && [ $((10 * all)) -lt $((9 * first)) ] || echo "$all, and $first")"
run make room --triangles 400000 -o room.ply
works "--quality-time 1 of two large rooms" pack --sequence room.ply room.ply -o x.plt \
    --tree-for all --quality-time 1 --json room.json
verdict "... is soon over" "$(
    grep -q '"out_of_time": true' room.json || cat room.json
    seconds=$(sed -n 's/^ *"seconds": \([0-9.]*\),$/\1/p' room.json)
    echo "$seconds" | awk '{ exit !($1 > 0 && $1 < 20) }' || echo "$seconds s")"
works "... and shown" render x.plt -o x.y4m --frames 1:2 --size 8x8
rm -f room.ply x.plt

# ---- memory -------------------------------------------------------------------------------

# peak FRAMES: bytes that packing so many marbles takes, of which each frame's mesh has 161,040.
run make marbles -o 'marbles_{}.ply' --frames 12
peak() {
    "$PLANELET" pack --sequence 'marbles_{}.ply' --frames 0:"$1" -o marbles.plt --json - \
        2>/dev/null | number memory_peak_bytes
}
verdict "ten frames more take their code, and not their meshes" "$(
    more=$(($(peak 12) - $(peak 2)))
    [ "$more" -gt 100000 ] && [ "$more" -lt 800000 ] || echo "$more bytes")"

# ---- machines that share the frames -------------------------------------------------------

# joined: the parts as README joins them.
joined() {
    { head -n 1 part_000.y4m; tail -q -n +2 part_???.y4m; } >joined.y4m
    rm -f part_*
}
PATH=${PLANELET%/*}:$PATH
if needs parallel; then
    # shellcheck disable=SC2086
    verdict "two GNU parallel jobs" "$(
        parallel --will-cite -j 2 planelet render list.plt $view \
            --frames {1}:{2} -o part_{1}.y4m ::: 000 003 006 :::+ 003 006 009 2>&1)"
    joined
    same all.y4m joined.y4m "... give parts that are joined to what one run gives"
fi
job='a=$(printf %03d $((3 * SLURM_ARRAY_TASK_ID))) && planelet render list.plt '$view'
    --frames $a:$((3 * SLURM_ARRAY_TASK_ID + 3)) -o part_$a.y4m'
verdict "the tasks of a Slurm array" "$(
    for SLURM_ARRAY_TASK_ID in 2 0 1; do
        export SLURM_ARRAY_TASK_ID
        echo "$job" | tr '\n' ' ' | sh 2>&1
    done)"
joined
same all.y4m joined.y4m "... likewise"

# ---- what goes wrong ----------------------------------------------------------------------

none_left() {
    verdict "... and leaves no file" "$(ls x.* 2>/dev/null; left_behind)"
}
rm -f x.*
mv wave_003.ply hidden.ply
refused "a frame that is missing" "frame 3" "wave_003.ply" \
    pack --sequence 'wave_{}.ply' --frames 0:6 -o x.plt
none_left
refused "... in a recipe" "frame 3" "wave_003.ply" pack --sequence wave.txt --frames 0:6 -o x.plt
none_left
wave 3 8 >wave_003.ply
refused "a frame of other triangles" "frame 3" "wave_003.ply: has 64 vertices and 98 triangles" \
    pack --sequence wave_00?.ply -o x.plt
none_left
awk '$1 == 3 && !done { print 3, $3, $2, $4; done = 1; next } { print }' hidden.ply >wave_003.ply
refused "a frame of another topology" "frame 3" "wave_003.ply: triangle 0 has other vertices" \
    pack --sequence wave_00?.ply -o x.plt
none_left
sed '12s/^[^ ]*/nan/' hidden.ply >wave_003.ply
refused "a frame with a corner that is no number" "frame 3" "wave_003.ply: line 12" \
    pack --sequence wave_00?.ply -o x.plt --json x.json
none_left
mv hidden.ply wave_003.ply
refused "the first frame, too" "frame 9" "wave_009.ply" \
    pack --sequence 'wave_{}.ply' --frames 9:11 -o x.plt
none_left
refused "frames that the image does not have" list.plt "has 9 frames; use --frames 0:9" \
    render list.plt -o x.y4m --frames 5:10 --size 8x8
none_left
refused "an image without frames" plain.plt "has no frames" \
    render plain.plt -o x.y4m --frames 0:2 --size 8x8
none_left
# damaged FRAME FILE: list.plt with a byte of that frame changed.
damaged() {
    section=$(od -An -tu4 -j156 -N4 list.plt | tr -d ' ')
    at=$(od -An -tu4 -j$((section + 4 * $1)) -N4 list.plt | tr -d ' ')
    cp list.plt "$2"
    printf '\252\125' | dd of="$2" bs=1 seek=$((section + at + 40)) conv=notrunc 2>/dev/null
}
damaged 4 damaged.plt
for source in map read; do
    refused "a frame that is damaged, --source $source" "frame 4" \
        "damaged.plt: byte [0-9]*: a block of a frame is damaged (checksum) (I25)" \
        render damaged.plt -o x.y4m --frames 2:9 --size 8x8 --source $source
    none_left
done
# shellcheck disable=SC2086
works "frames before it are shown" render damaged.plt -o x.y4m --frames 0:4 $view
tail -n +2 x.y4m >x.frames
alone 0 1 2 3 >due.frames
same due.frames x.frames "... as they are"
rm -f x.*
refused "info looks at each frame" "frame 4" "damaged.plt: byte" info damaged.plt
works "a scene that stands still needs none of them" render damaged.plt -o still.ppm --size 8x8
misused "--sequence of one mesh alone" "takes --frames A:B" pack --sequence wave.txt -o x.plt
misused "--frames of several" "--frames A:B is for one MESH" \
    pack --sequence wave_00?.ply --frames 0:2 -o x.plt
misused "--frames without --sequence" "go with --sequence" pack wave.txt --frames 0:2 -o x.plt
misused "--key 0" "--key" pack --sequence wave_00?.ply --key 0 -o x.plt
misused "--rate 1001" "--rate" pack --sequence wave_00?.ply --rate 1001 -o x.plt
misused "compact nodes as floats" "takes --geometry lattice" \
    pack --sequence wave_00?.ply --nodes compact --geometry float -o x.plt
misused "standard input" "standard input" pack --sequence - wave_000.ply -o x.plt
for flag in '--weld 0.1' '--reduce 10' '--memory 100000000' '--frame 1'; do
    # shellcheck disable=SC2086
    misused "$flag" "${flag%% *} is for one mesh" pack --sequence wave_00?.ply $flag -o x.plt
done
misused "two films" "--frames and --orbit" render list.plt --frames 0:2 --orbit 3 -o x.y4m
misused "several frames in one picture" "NAME_{}.png" render list.plt --frames 0:2 -o x.png
refused "a streamed scene" list.plt "stills of compact blocks move alone; pack frames with" \
    render list.plt --frames 0:2 -o x.y4m --residency streamed
none_left
finish
