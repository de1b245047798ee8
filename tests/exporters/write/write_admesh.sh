#!/bin/sh
# write_admesh.sh SHAPES OUT - ADMesh: STL, ASCII and binary, repaired on the way
#
# SPDX-License-Identifier: MIT
for mesh in "$1"/*.stl; do
    stem=$2/$(basename "$mesh" .stl)
    admesh -a "$stem.ascii.stl" -b "$stem.binary.stl" "$mesh" >/dev/null || exit 1
done
