#!/bin/sh
# write_pcl.sh SHAPES OUT - PCL: PLY and OBJ of its own, and through VTK also STL
#
# Its own readers take polygons of at most four corners, and its ply2obj no colours: those
# shapes are left out. SPDX-License-Identifier: MIT
for mesh in "$1"/*.obj; do
    stem=$2/$(basename "$mesh" .obj)
    for format in 0:binary 1:ascii; do
        word=${format#*:}
        pcl_obj2ply -format "${format%:*}" "$mesh" "$stem.$word.ply"
        for kind in ply obj stl; do
            pcl_converter -f "$word" "$mesh" "$stem.vtk_$word.$kind"
        done
    done
    pcl_ply2obj "$stem.ascii.ply" "$stem.obj"
done >/dev/null 2>&1
find "$2" -empty -type f -exec rm {} +
