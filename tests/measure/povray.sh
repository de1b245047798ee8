#!/bin/sh
# povray.sh [FOLDER] - pictures of `render --shader whitted` beside POV-Ray's of the same scenes
#
# A floor and three spheres, painted, of mirror and of glass, lit by one lamp and the sky; and the
# marbles of `make demo` in the sun: the same triangles, materials, camera and light for both.
# Pictures and their differences (16 times as bright) stay in FOLDER. Exit status 2 when povray, a
# Debian package, is not there. Set SIZE for another size, MOST for another bound, ONLY to
# spheres or marbles for one of them. SPDX-License-Identifier: MIT
set -u
planelet=${PLANELET:-build/host/planelet}
difference=${DIFFERENCE:-build/host/tests/measure/test_picture_difference}
folder=${1:-${BUILD:-build}/povray}
size=${SIZE:-640x480} most=${MOST:-3} only=${ONLY:-}
width=${size%x*} height=${size#*x}
aspect=$(awk "BEGIN { print $width / $height }")

if ! command -v povray >/dev/null 2>&1; then
    echo "povray.sh: there is no povray; install it (apt-get install povray)" >&2
    exit 2
fi
mkdir -p "$folder"

# compare NAME RENDER_FLAG...: renders NAME.plt and NAME.pov, and says how they differ.
compare() {
    name=$1
    shift
    rm -f "$folder/$name"-*.p?? || exit 1
    for picture in ppm png; do
        "$planelet" render "$folder/$name.plt" -o "$folder/$name-ours.$picture" --size "$size" \
            --shader whitted "$@" >/dev/null || exit 1
    done
    for format in P N; do
        povray "+I$folder/$name.pov" "+O$folder/$name-theirs" "+F$format" "+W$width" \
            "+H$height" -D -A File_Gamma=sRGB >"$folder/povray.log" 2>&1 || {
            tail -n 20 "$folder/povray.log" >&2
            exit 1
        }
    done
    echo "$name, $size: $folder/$name-ours.png, -theirs.png, -difference.png"
    "$difference" "$folder/$name-ours.ppm" "$folder/$name-theirs.ppm" \
        "$folder/$name-difference.png" "$most" || failed=1
}

spheres() {
    awk -v obj="$folder/spheres.obj" -v mtl="$folder/spheres.mtl" -v mtl_name=spheres.mtl \
        -v pov="$folder/spheres.pov" -v aspect="$aspect" -v fov=40 \
        -f tests/measure/povray_scene.awk || exit 1
    "$planelet" pack "$folder/spheres.obj" -o "$folder/spheres.plt" --materials keep \
        >/dev/null || exit 1
    compare spheres --fov 40 --eye 0.5,2.2,6 --look 0,0.7,0 --light point:3,5,4,30 \
        --sky 0.25,0.28,0.32 --ground 0.25,0.28,0.32 --depth 6
}

# The picture of README, with one sample and a sun without width: where the samples of a soft
# shadow lie is each renderer's own affair.
marbles() {
    "$planelet" make marbles --frame 60 -o "$folder/marbles.obj" >/dev/null || exit 1
    "$planelet" pack "$folder/marbles.obj" -o "$folder/marbles.plt" --materials keep \
        --smooth 40 >/dev/null 2>"$folder/marbles.txt" || exit 1
    awk -v crease=40 -v sky='0.4 0.58 0.9' -v ground='0.26 0.2 0.15' -v aspect="$aspect" \
        -v fov=35 -v eye=6,10,22 -v look=1.2,-0.6,5 -v sun=-0.8,0.9,-0.15 -v power=1.5 \
        -f tests/measure/povray_mesh.awk "$folder/marbles.mtl" "$folder/marbles.obj" \
        >"$folder/marbles.pov" || exit 1
    compare marbles --fov 35 --eye 6,10,22 --look 1.2,-0.6,5 --light sun:-0.8,0.9,-0.15,1.5 \
        --sky 0.4,0.58,0.9 --ground 0.26,0.2,0.15 --depth 6
}

failed=0
case $only in
'') spheres && marbles ;;
spheres | marbles) "$only" ;;
*)
    echo "povray.sh: ONLY=$only; it is spheres or marbles" >&2
    exit 2
    ;;
esac
exit "$failed"
