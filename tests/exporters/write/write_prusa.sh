#!/bin/sh
# write_prusa.sh SHAPES OUT - PrusaSlicer: binary STL, OBJ
#
# SPDX-License-Identifier: MIT
for mesh in "$1"/*.stl; do
    stem=$2/$(basename "$mesh" .stl)
    prusa-slicer --export-stl "$mesh" -o "$stem.stl" >/dev/null 2>&1 || exit 1
    prusa-slicer --export-obj "$mesh" -o "$stem.obj" >/dev/null 2>&1 || exit 1
done
