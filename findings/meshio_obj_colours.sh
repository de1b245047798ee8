#!/bin/sh
# meshio_obj_colours.sh - colours behind an OBJ's points are three more coordinates to meshio
#
# Software: Debian's python3-meshio 7.0.0-3 (upstream 5.0.0).
# Input: an OBJ of one triangle with colours behind the coordinates, "v 0 0 0 1 0 0", as MeshLab
# and Blender write them, and the same without.
# Behaviour: all numbers of the line are taken for the point, which then has six. Writers trust
# that: the ASCII VTK file declares three points and has 18 numbers where 9 belong, so whoever reads
# the first nine has the colour of point 0 for point 1, and then stops at a number where a keyword
# should be. meshio itself reads neither that file again nor its OFF, which it does without colours.
# One would guess that they become data of the points, as those of a PLY do, or are left out.
# Output seen: "plain: 3 points of 3 numbers, by vtk 3 of 3, by off 3 of 3", "coloured: 3 points of
# 6 numbers, by vtk none, by off none", "vtk: POINTS 3 double, 18 numbers".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
version=7.0.0-3
mkdir -p "$folder/archives/partial" "$folder/tree"
apt-get install -y -qq --no-install-recommends --download-only \
    -o "Dir::Cache::archives=$folder/archives" "python3-meshio=$version" >/dev/null 2>&1 ||
    { echo "cannot get python3-meshio $version"; exit 2; }
for package in "$folder"/archives/*.deb; do
    [ ! -e "$package" ] || dpkg-deb -x "$package" "$folder/tree" || exit 2
done
libraries=$folder/tree/usr/lib/$(uname -m)-linux-gnu
printf '%s\n' 'v 0 0 0' 'v 1 0 0' 'v 0 1 0' 'f 1 2 3' >"$folder/plain.obj"
printf '%s\n' 'v 0 0 0 1 0 0' 'v 1 0 0 0 1 0' 'v 0 1 0 0 0 1' 'f 1 2 3' >"$folder/coloured.obj"
cat >"$folder/read.py" <<'END'
import os
import sys
import meshio

os.chdir(sys.argv[1])


def copied(mesh, kind, **settings):
    meshio.write("out." + kind, mesh, **settings)
    try:
        shape = meshio.read("out." + kind).points.shape
    except (Exception, SystemExit):  # meshio leaves by sys.exit when no reader takes a file
        return "by %s none" % kind
    return "by %s %d of %d" % (kind, *shape)


for name in "plain", "coloured":
    mesh = meshio.read(name + ".obj")
    print("seen %s: %d points of %d numbers, %s, %s" % (
        name, *mesh.points.shape, copied(mesh, "vtk", binary=False), copied(mesh, "off")))
with open("out.vtk") as file:
    lines = file.read().splitlines()
at = [line.startswith("POINTS") for line in lines].index(True)
print("seen vtk: %s, %d numbers" % (lines[at], len(lines[at + 1].split())))
END
LD_LIBRARY_PATH=$libraries:$libraries/blas:$libraries/lapack \
    PYTHONPATH=$folder/tree/usr/lib/python3/dist-packages \
    /usr/bin/python3 "$folder/read.py" "$folder" >"$folder/told" 2>/dev/null || exit 2
seen=$(sed -n 's/^seen //p' "$folder/told")
echo "$seen"
[ "$seen" = "plain: 3 points of 3 numbers, by vtk 3 of 3, by off 3 of 3
coloured: 3 points of 6 numbers, by vtk none, by off none
vtk: POINTS 3 double, 18 numbers" ]
