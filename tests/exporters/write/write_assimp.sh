#!/bin/sh
# write_assimp.sh SHAPES OUT - assimp: PLY, STL, OBJ; `assimp export` joins equal vertices
#
# SPDX-License-Identifier: MIT
for mesh in "$1"/*.obj; do
    stem=$2/$(basename "$mesh" .obj)
    for pair in ply:ascii.ply plyb:binary.ply stl:ascii.stl stlb:binary.stl obj:obj \
        objnomtl:nomtl.obj; do
        assimp export "$mesh" "$stem.${pair#*:}" -f"${pair%%:*}" >/dev/null || exit 1
    done
    # -tri cuts polygons, -jiv joins vertices, -cfull is the whole of assimp's steps.
    assimp export "$mesh" "$stem.cut.ply" -fply -tri -jiv >/dev/null || exit 1
    assimp export "$mesh" "$stem.full.ply" -fplyb -cfull >/dev/null || exit 1
done
