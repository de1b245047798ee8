#!/bin/sh
# write_openfoam.sh SHAPES OUT - OpenFOAM's surfaceConvert: STL, OBJ
#
# SPDX-License-Identifier: MIT
export WM_PROJECT_DIR=/usr/share/openfoam
for mesh in "$1"/*.stl; do
    stem=$2/$(basename "$mesh" .stl)
    for kind in stl stlb obj; do
        surfaceConvert "$mesh" "$stem.$kind" >/dev/null 2>&1 || exit 1
    done
    mv "$stem.stlb" "$stem.binary.stl"
    surfaceMeshConvert "${mesh%.stl}.obj" "$stem.mesh.obj" >/dev/null 2>&1
    surfaceMeshConvert "${mesh%.stl}.obj" "$stem.mesh.stl" >/dev/null 2>&1
done
