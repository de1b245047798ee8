#!/bin/sh
# write_openctm.sh SHAPES OUT - OpenCTM's ctmconv: PLY, STL, OBJ
#
# SPDX-License-Identifier: MIT
for mesh in "$1"/cut/*.obj; do
    stem=$2/$(basename "$mesh" .obj)
    for kind in ply stl obj; do
        ctmconv "$mesh" "$stem.$kind" >/dev/null || exit 1
    done
done
