#!/bin/sh
# surface.sh MESH... - bytes per triangle of normals, colours and texture coordinates
#
# Each mesh gets coordinates and colours that its file need not have (unwrap.sh), is packed as
# compact blocks on a lattice of 14 bits, and must take at most 1.5, 1.0 and 2.0 bytes per triangle
# more. What stands for colours, and how far coordinates are off, is pack's own word (--json).
# SPDX-License-Identifier: MIT
set -u
planelet=${PLANELET:-build/host/planelet}
work=${BUILD:-build}/surface
passed=0 failed=0
export PLANELET="$planelet"

[ $# -gt 0 ] && [ -e "$1" ] || {
    echo "use it as: make surface SCENES=folder-of-meshes, in which there is bunny.ply" >&2
    exit 2
}
mkdir -p "$work"

field() { # NAME FILE: of JSON
    sed -n "s/^ *\"$1\": \([0-9.e-]*\),*$/\1/p" "$2"
}

at_most() { # NUMBER BOUND SENTENCE
    if awk "BEGIN { exit !($1 > 0 && $1 <= $2) }"; then
        echo "pass $3"
        passed=$((passed + 1))
    else
        echo "FAIL $3"
        failed=$((failed + 1))
    fi
}

echo "| mesh | triangles | normals | colours | coordinates | in 32 bits | colours kept |" \
    "of | off by | on average | coordinates off by |"
echo "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|"
for mesh in "$@"; do
    name=$(basename "$mesh" .ply)
    for texcoords in fine keep; do
        sh tests/measure/unwrap.sh "$mesh" "$work/mesh.obj" &&
            "$planelet" pack "$work/mesh.obj" -o "$work/mesh.plt" --nodes compact \
                --geometry lattice:14 --smooth 40 --colours keep --texcoords $texcoords \
                --json "$work/pack.json" >"$work/said" 2>&1 &&
            "$planelet" info "$work/mesh.plt" --json >"$work/$texcoords.json" || {
            cat "$work/said" >&2
            exit 1
        }
    done
    echo "| $name | $(field triangles "$work/keep.json")" \
        "| $(field normal_bytes_per_triangle "$work/keep.json")" \
        "| $(field colour_bytes_per_triangle "$work/keep.json")" \
        "| $(field texcoord_bytes_per_triangle "$work/keep.json")" \
        "| $(field texcoord_bytes_per_triangle "$work/fine.json")" \
        "| $(field colours_kept "$work/pack.json") | $(field colours_distinct "$work/pack.json")" \
        "| $(field colours_off "$work/pack.json") | $(field colours_off_mean "$work/pack.json")" \
        "| $(field texture_coordinates_off "$work/pack.json") |"
    at_most "$(field normal_bytes_per_triangle "$work/keep.json")" 1.5 \
        "$name: normals take at most 1.5 bytes per triangle"
    at_most "$(field colour_bytes_per_triangle "$work/keep.json")" 1.0 \
        "$name: colours, which all differ, at most 1.0"
    at_most "$(field texcoord_bytes_per_triangle "$work/keep.json")" 2.0 \
        "$name: texture coordinates at most 2.0"
done
rm -f "$work/mesh.obj" "$work/mesh.plt"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
