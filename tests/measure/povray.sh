#!/bin/sh
# povray.sh [FOLDER] - a picture of `render --shader whitted` beside POV-Ray's of the same scene
#
# A floor and three spheres, painted, of mirror and of glass, lit by one lamp and the sky: the same
# triangles, camera and light for both. Pictures and their difference (16 times as bright) stay in
# FOLDER. Exit status 2 when povray, a Debian package, is not there. Set SIZE for another size and
# MOST for another bound. SPDX-License-Identifier: MIT
set -u
planelet=${PLANELET:-build/host/planelet}
difference=${DIFFERENCE:-build/host/tests/measure/test_picture_difference}
folder=${1:-${BUILD:-build}/povray}
size=${SIZE:-640x480} most=${MOST:-3}
width=${size%x*} height=${size#*x}

if ! command -v povray >/dev/null 2>&1; then
    echo "povray.sh: there is no povray; install it (apt-get install povray)" >&2
    exit 2
fi
mkdir -p "$folder"
rm -f "$folder"/ours.* "$folder"/theirs.* "$folder"/difference.png
awk -v obj="$folder/scene.obj" -v mtl="$folder/scene.mtl" -v mtl_name=scene.mtl \
    -v pov="$folder/scene.pov" -v aspect="$(awk "BEGIN { print $width / $height }")" -v fov=40 \
    -f tests/measure/povray_scene.awk || exit 1
"$planelet" pack "$folder/scene.obj" -o "$folder/scene.plt" --materials keep >/dev/null || exit 1
for picture in ours.ppm ours.png; do
    "$planelet" render "$folder/scene.plt" -o "$folder/$picture" --size "$size" --fov 40 \
        --eye 0.5,2.2,6 --look 0,0.7,0 --shader whitted --light point:3,5,4,30 \
        --sky 0.25,0.28,0.32 --ground 0.25,0.28,0.32 --depth 6 >/dev/null || exit 1
done
for format in P N; do
    povray "+I$folder/scene.pov" "+O$folder/theirs" "+F$format" "+W$width" "+H$height" -D -A \
        File_Gamma=sRGB >"$folder/povray.log" 2>&1 || {
        tail -n 20 "$folder/povray.log" >&2
        exit 1
    }
done
"$difference" "$folder/ours.ppm" "$folder/theirs.ppm" "$folder/difference.png" "$most"
