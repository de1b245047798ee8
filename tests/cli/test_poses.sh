#!/bin/sh
# test_poses.sh - planelet make poses and mesh: frames between poses, and meshes as they are
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/wave.sh
begin poses
waves 3

# vertices FILE: a line of 3 numbers for each, of a PLY as the program writes it.
vertices() {
    count=$(sed -n 's/^element vertex \([0-9]*\)\r*$/\1/p;/^end_header/q' "$1")
    size=$(LC_ALL=C awk '{ n += length($0) + 1 } /^end_header/ { print n; exit }' "$1")
    tail -c "+$((size + 1))" "$1" | head -c $((12 * count)) | od -An -v -t f4 -w12
}

for pose in 0 1 2; do
    run make poses wave_00$pose.ply wave_00$pose.ply --frames 2 -o 'same_{}.ply'
    vertices same_001.ply >at_$pose
    same same_000.ply same_001.ply "from pose $pose to itself nothing moves"
done
works "three poses, seven frames" make poses wave_00?.ply --frames 7 -o 'way_{}.ply'
verdict "... are seven files" "$(
    [ "$(ls way_*.ply | tr '\n' ' ')" = "$(printf 'way_00%d.ply ' 0 1 2 3 4 5 6)" ] || ls way_*)"
for frame in 0 1 2 3 4 5 6; do
    from=$((frame / 3)) part=$((frame % 3))
    to=$((part > 0 ? from + 1 : from))
    vertices way_00$frame.ply >found
    verdict "... frame $frame is $part/3 of the way behind pose $from" "$(
        paste -d ' ' at_$from at_$to found | awk -v part=$part '
            function far(a, b) { return a - b > 1e-6 || b - a > 1e-6 }
            {
                for (i = 1; i <= 3; i++)
                    if (far($i + ($(i + 3) - $i) * part / 3, $(i + 6))) print NR ": " $0
            }
            END { if (NR != 81) print NR " vertices" }')"
done
for pose in 0 1 2; do
    "$PLANELET" pack wave_00$pose.ply -o due.plt 2>/dev/null
    "$PLANELET" pack way_00$((3 * pose)).ply -o found.plt 2>/dev/null
    same due.plt found.plt "... and packs as pose $pose does, bit for bit"
done
works "fewer frames than poses: the ends" make poses wave_00?.ply --frames 2 -o 'end_{}.ply'
same end_000.ply way_000.ply "... the first"
same end_001.ply way_006.ply "... the last"
works "they are a sequence" pack --sequence 'way_{}.ply' --frames 0:7 -o way.plt

# ---- a mesh as it is ----------------------------------------------------------------------

echo 'wave_{}.ply*3 2 0 0 0' >wave.txt
works "a mesh of another format" make mesh wave_001.ply -o mesh.ply
vertices mesh.ply >found
same at_1 found "... has its vertices"
works "frames of a recipe" make mesh wave.txt --frames 2 --frame 1 -o 'mesh_{}.ply'
for frame in 1 2; do
    "$PLANELET" pack wave.txt --frame $frame -o due.plt 2>/dev/null
    "$PLANELET" pack mesh_00$frame.ply -o found.plt 2>/dev/null
    same due.plt found.plt "... frame $frame packs as that of the recipe, bit for bit"
done
works "frames of a name" make mesh 'way_{}.ply' --frames 1 --frame 4 -o 'mesh_{}.ply'
same way_004.ply mesh_004.ply "... the one with that number"
cp wave_000.ply kept.ply
echo 'wave_{}.ply*3+1 2 0 0 0' >turned.txt
refused "frames over those that they are made of" wave_000.ply "input" \
    make mesh turned.txt --frames 3 -o 'wave_{}.ply'
same kept.ply wave_000.ply "... which stay as they were"
misused "a mesh of none" "planelet make mesh MESH" make mesh -o x.ply
misused "a mesh of two" "one MESH" make mesh wave_000.ply wave_001.ply -o x.ply
misused "a mesh of so many triangles" "no --triangles" make mesh wave_000.ply -o x.ply \
    --triangles 9
refused "a mesh that is not there" gone.ply "No such file" make mesh gone.ply -o x.ply

misused "one pose" "2 to 1000 MESHes" make poses wave_000.ply --frames 3 -o 'x_{}.ply'
misused "no number of frames" "poses take --frames N, 2 to 1000" \
    make poses wave_000.ply wave_001.ply -o 'x_{}.ply'
for frames in 1 1001; do
    misused "--frames $frames of poses" "poses take --frames N, 2 to 1000" \
        make poses wave_000.ply wave_001.ply --frames $frames -o 'x_{}.ply'
done
misused "frames without numbers" "'{}'" make poses wave_000.ply wave_001.ply --frames 3 -o x.ply
for flag in '--frame 1' '--seed 1' '--triangles 100'; do
    # shellcheck disable=SC2086
    misused "$flag of poses" "neither --frame, --seed nor --triangles" \
        make poses wave_000.ply wave_001.ply --frames 3 $flag -o 'x_{}.ply'
done
misused "meshes for another scene" "leave out 'wave_000.ply'" make knot wave_000.ply -o x.ply
refused "a pose that is not there" gone.ply "No such file" \
    make poses wave_000.ply wave_001.ply gone.ply --frames 3 -o 'x_{}.ply'
cp wave_002.ply over_002.ply
refused "a frame that would be written over a later pose" over_002.ply "same file as the input" \
    make poses wave_000.ply wave_001.ply over_002.ply --frames 6 -o 'over_{}.ply'
same wave_002.ply over_002.ply "... which is as it was"
verdict "nothing is left of what failed" "$(
    ls x_* 2>/dev/null
    left_behind)"
finish
