#!/bin/sh
# write_draco.sh SHAPES OUT - Draco: PLY, OBJ, STL out of its own compressed form, unquantised
#
# SPDX-License-Identifier: MIT
for mesh in "$1"/cut/*.obj; do
    stem=$2/$(basename "$mesh" .obj)
    draco_encoder -i "$mesh" -o "$stem.drc" -qp 0 -qt 0 -qn 0 >/dev/null || exit 1
    for kind in ply obj stl; do
        draco_decoder -i "$stem.drc" -o "$stem.$kind" >/dev/null || exit 1
    done
    rm "$stem.drc"
done
