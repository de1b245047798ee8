#!/bin/sh
# read_admesh.sh FILE... - ADMesh, of the same mesh as STL
#
# SPDX-License-Identifier: MIT
for mesh in "$@"; do
    admesh --no-check "${mesh%.ply}.stl" | awk -v name="$(basename "$mesh")" '
        /^Number of facets/ { facets = $5 }
        END { print name, facets, "-" }'
done
