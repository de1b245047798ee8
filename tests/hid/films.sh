#!/bin/sh
# films.sh FOLDER - marbles.ppm: marbles roll before a still camera, 25 per second;
# small.ppm: the same, 128x64; orbit.y4m: 1.2 degrees per frame about them, as at
# 30 per second in ten seconds
#
# 320x240 else. Streams of PPM keep every colour exact. Films that are newer than the
# program that makes them are kept. knot.plt: a scene, to be turned by keys.
# SPDX-License-Identifier: MIT
set -e
planelet=${OUT:-${BUILD:-build}/host}/planelet
folder=$1
mkdir -p "$folder/scene"
[ -n "$(find "$folder/orbit.y4m" -newer "$planelet" -newer "$0" 2>/dev/null)" ] && exit 0
rm -f "$folder/orbit.y4m"
"$planelet" make marbles --frames 36 -o "$folder/scene/{}.ply" >/dev/null
for mesh in "$folder"/scene/*.ply; do
    "$planelet" pack "$mesh" -o "${mesh%.ply}.plt" >/dev/null
    for size in 320x240 128x64; do
        "$planelet" render "${mesh%.ply}.plt" --size $size --eye 17.745,31.55,39.433 \
            --look 0,0.5,0 -o "${mesh%.ply}-$size.ppm" >/dev/null
    done
done
cat "$folder"/scene/*-320x240.ppm >"$folder/marbles.ppm"
cat "$folder"/scene/*-128x64.ppm >"$folder/small.ppm"
scene=$(ls "$folder"/scene/*.plt | head -n 1)
# The header, and 15 of 300 frames.
"$planelet" render "$scene" --view box --size 320x240 --orbit 300 --chroma 444 \
    -o "$folder/scene/orbit.y4m" >/dev/null
{
    head -n 1 "$folder/scene/orbit.y4m" | sed 's/ F25:1//' # no time of its own
    tail -n +2 "$folder/scene/orbit.y4m" | head -c $((15 * (6 + 3 * 320 * 240)))
} >"$folder/scene/last.y4m"
"$planelet" make knot --triangles 300 -o "$folder/scene/knot.ply" >/dev/null
"$planelet" pack "$folder/scene/knot.ply" -o "$folder/knot.plt" >/dev/null
mv "$folder/scene/last.y4m" "$folder/orbit.y4m" # all films are there
rm -r "$folder/scene"
