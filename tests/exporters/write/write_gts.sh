#!/bin/sh
# write_gts.sh SHAPES OUT - GTS: gts2stl
#
# SPDX-License-Identifier: MIT
for mesh in "$1"/*.stl; do
    stem=$2/$(basename "$mesh" .stl)
    stl2gts <"$mesh" 2>/dev/null | gts2stl >"$stem.stl" || exit 1
done
