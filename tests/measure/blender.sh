#!/bin/sh
# blender.sh [FOLDER] - the picture of `make demo` beside Blender's, by Cycles
#
# The same triangles, materials, camera, sun and sky for both, 16 samples per pixel of ours. Of
# Cycles two pictures: with what comes from lights and sky alone, and with light that goes from one
# surface to the next. Pictures and their differences (16 times as bright) stay in FOLDER. Exit
# status 2 when blender, a Debian package, is not there. Set SIZE for another size, SAMPLES for
# other than 64 of Cycles. SPDX-License-Identifier: MIT
set -u
planelet=${PLANELET:-build/host/planelet}
difference=${DIFFERENCE:-build/host/tests/measure/test_picture_difference}
folder=${1:-${BUILD:-build}/blender}
size=${SIZE:-320x240} samples=${SAMPLES:-64}
failed=0
most=255 # they may differ as they do: they are to be looked at

if ! command -v blender >/dev/null 2>&1; then
    echo "blender.sh: there is no blender; install it (apt-get install blender)" >&2
    exit 2
fi
mkdir -p "$folder"
rm -f "$folder"/ours.p?? "$folder"/theirs-?.p?? "$folder"/difference-?.png
"$planelet" make marbles --frame 60 -o "$folder/marbles.obj" >/dev/null || exit 1
"$planelet" pack "$folder/marbles.obj" -o "$folder/marbles.plt" --materials keep --smooth 40 \
    >/dev/null 2>"$folder/marbles.txt" || exit 1
for picture in ppm png; do
    "$planelet" render "$folder/marbles.plt" -o "$folder/ours.$picture" --size "$size" \
        --shader whitted --samples 16 --fov 35 --eye 6,10,22 --look 1.2,-0.6,5 \
        --light sun:-0.8,0.9,-0.15,1.5 --sky 0.4,0.58,0.9 --ground 0.26,0.2,0.15 --depth 6 \
        >/dev/null || exit 1
done
blender --version | head -n 1
for bounces in 0 4; do
    name=theirs-$bounces
    blender -b --factory-startup -noaudio -P tests/measure/blender_scene.py -- \
        "$folder/marbles.mtl" "$folder/marbles.obj" "$(realpath "$folder")/$name" \
        "${size%x*}" "${size#*x}" "$samples" "$bounces" "$(nproc)" >"$folder/blender.log" 2>&1
    if ! [ -s "$folder/$name.ppm" ]; then
        tail -n 20 "$folder/blender.log" >&2
        exit 1
    fi
    echo "marbles, $size, $bounces diffuse bounces: $folder/ours.png, $name.png, difference"
    "$difference" "$folder/ours.ppm" "$folder/$name.ppm" "$folder/difference-$bounces.png" \
        "$most" || failed=1 # below 320x240 hardly a pixel is apart from edges
done
exit "$failed"
