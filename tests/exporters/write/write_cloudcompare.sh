#!/bin/sh
# write_cloudcompare.sh SHAPES OUT - CloudCompare: PLY, OBJ, STL
#
# SPDX-License-Identifier: MIT
export QT_QPA_PLATFORM=offscreen
for mesh in "$1"/*.obj; do
    stem=$(realpath "$2")/$(basename "$mesh" .obj)
    for kind in ply:PLY obj:OBJ stl:STL; do
        CloudCompare -SILENT -AUTO_SAVE OFF -O "$mesh" -M_EXPORT_FMT "${kind#*:}" -SAVE_MESHES \
            FILE "$stem.${kind%:*}" >/dev/null 2>&1 || exit 1
    done
done
