#!/bin/sh
# write_osg.sh SHAPES OUT - OpenSceneGraph's osgconv: STL and OBJ of a scene
#
# SPDX-License-Identifier: MIT
for mesh in "$1"/*.obj; do
    stem=$2/$(basename "$mesh" .obj)
    osgconv "$mesh" "$stem.obj" >/dev/null 2>&1 || exit 1
    osgconv "$mesh" "$stem.stl" >/dev/null 2>&1 || exit 1
    osgconv -O separateFiles "$mesh" "$stem.part.stl" >/dev/null 2>&1 || exit 1
done
