#!/bin/sh
# read_assimp.sh FILE... - assimp
#
# SPDX-License-Identifier: MIT
for mesh in "$@"; do
    assimp info "$mesh" -r | awk -v name="$(basename "$mesh")" '
        /^Vertices:/ { vertices = $2 }
        /^Faces:/ { faces = $2 }
        END { print name, faces, vertices }'
done
