#!/bin/sh
# write_mm3d.sh SHAPES OUT - Maverick Model 3D: OBJ
#
# SPDX-License-Identifier: MIT
for mesh in "$1"/*.obj; do
    cp "$mesh" "$2/source.obj"
    (cd "$2" && xvfb-run -a mm3d --convert mm3d source.obj && mv source.obj source.was.obj &&
        xvfb-run -a mm3d --convert obj source.mm3d) >/dev/null 2>&1 || exit 1
    mv "$2/source.obj" "$2/$(basename "$mesh")" && rm -f "$2"/source.*
done
