#!/bin/sh
# read_draco.sh FILE... - Draco's encoder
#
# SPDX-License-Identifier: MIT
made=$(mktemp)
for mesh in "$@"; do
    # What it says of a mesh is in its own file again: as OBJ, a line per vertex and face.
    draco_encoder -i "$mesh" -o "$made" -qp 0 -method sequential >/dev/null &&
        draco_decoder -i "$made" -o "$made.obj" >/dev/null &&
        awk -v name="$(basename "$mesh")" '
            $1 == "v" { vertices++ }
            $1 == "f" { faces++ }
            END { print name, faces, vertices }' "$made.obj"
done
rm -f "$made" "$made.obj"
