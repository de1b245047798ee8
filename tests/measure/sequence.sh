#!/bin/sh
# sequence.sh FOLDER... - bytes per vertex and frame of sequences, by geometry and key frames
#
# Each FOLDER holds the frames of one mesh, in the order of their names. Marbles come first: 40
# frames that need no download. `key` counts frames from one that depends on no other to the next.
# SPDX-License-Identifier: MIT
planelet=$(cd "$(dirname "${PLANELET:-${BUILD:-build}/host/planelet}")" && pwd)/planelet
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/marbles"
"$planelet" make marbles -o "$work/marbles/{}.ply" --frames 40 >/dev/null 2>&1

# row NAME GEOMETRY KEY FRAME...
row() {
    name=$1 geometry=$2 key=$3
    shift 3
    "$planelet" pack --sequence "$@" --geometry "$geometry" --key "$key" -o "$work/x.plt" \
        >/dev/null 2>"$work/err" || { cat "$work/err"; return 1; }
    "$planelet" info "$work/x.plt" --json | tr -d ' ,"' | awk -F: -v name="$name" \
        -v geometry="$geometry" '
        { value[$1] = $2 }
        END {
            printf "%-12s %-10s %4u %7u %7u %9.2f %9.2f %10u\n", name, geometry,
                value["key_every"], value["frames"], value["vertices"],
                value["frame_bytes_per_vertex"],
                value["topology_bytes"] / value["triangles"], value["image_bytes"]
        }'
}

printf '%-12s %-10s %4s %7s %7s %9s %9s %10s\n' scene geometry key frames vertices 'per v.' \
    'topology' 'image'
for folder in "$work/marbles" "$@"; do
    for geometry in float lattice:12 lattice:14 lattice:16 lattice:18 lattice:20; do
        row "${folder##*/}" $geometry 16 "$folder"/*.ply
    done
    for key in 1 4 8 100000; do
        row "${folder##*/}" lattice:16 $key "$folder"/*.ply
    done
done
