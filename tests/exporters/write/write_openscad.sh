#!/bin/sh
# write_openscad.sh SHAPES OUT - OpenSCAD: STL of polyhedra
#
# SPDX-License-Identifier: MIT
for mesh in "$1"/*.off; do
    stem=$2/$(basename "$mesh" .off)
    echo "import(\"$(realpath "$mesh")\");" >"$stem.scad"
    openscad -q -o "$stem.stl" "$stem.scad" 2>/dev/null || exit 1
    # A union goes through CGAL's Nef polyhedra.
    echo "union() { import(\"$(realpath "$mesh")\"); translate([9, 9, 9]) cube(1); }" >"$stem.scad"
    openscad -q -o "$stem.union.stl" "$stem.scad" 2>/dev/null || exit 1
    rm "$stem.scad"
done
