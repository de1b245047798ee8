#!/bin/sh
# write_slic3r.sh SHAPES OUT - Slic3r: OBJ of a repaired mesh, STL of its halves
#
# SPDX-License-Identifier: MIT
for mesh in "$1"/*.stl; do
    copy=$2/$(basename "$mesh")
    cp "$mesh" "$copy" && slic3r --repair "$copy" >/dev/null 2>&1 &&
        slic3r --cut 0.1 "$copy" >/dev/null 2>&1 || exit 1
    rm "$copy"
done
