#!/bin/sh
# unwrap.sh MESH OUT.obj - a mesh with texture coordinates and colours made up (unwrap.awk)
# SPDX-License-Identifier: MIT
set -eu
planelet=${PLANELET:-build/host/planelet}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$planelet" make mesh "$1" -o "$folder/mesh.ply" >/dev/null

# Of the PLY that planelet writes: floats x y z, then a count of one byte and three numbers.
head=$(LC_ALL=C grep -a -b -m 1 '^end_header$' "$folder/mesh.ply" | cut -d : -f 1)
vertices=$(head -c "$head" "$folder/mesh.ply" | sed -n 's/^element vertex //p')
{
    tail -c "+$((head + 12))" "$folder/mesh.ply" | head -c "$((12 * vertices))" |
        od -An -v -t f4 -w12
    # a triangle's bytes: the numbers from the second on, four bytes each
    tail -c "+$((head + 12 + 12 * vertices))" "$folder/mesh.ply" | od -An -v -t u1 -w13 |
        awk '{ for (k = 0; k < 3; k++) { i[k] = $(4 * k + 2) + 256 * ($(4 * k + 3) + 256 * \
            ($(4 * k + 4) + 256 * $(4 * k + 5))) }; print "t", $1, i[0], i[1], i[2] }'
} | awk -f "$(dirname "$0")/unwrap.awk" >"$2"
