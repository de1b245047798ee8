#!/bin/sh
# vtk_obb_corner_lost.sh - a line goes into a closed mesh at a corner, and VTK has it stay there
#
# Software: Debian's python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1 (VTK 9.1.0), vtkOBBTree.
# Input: octahedra with points (1 0 0), (0 1 0), (0 0 z) and their opposites, of type double, with z
# from 0.1 to 4, and a line from (0 0 5) to (0 0 -5), which is their axis.
# Behaviour: IntersectWithLine promises points of entry and exit by turns, and has a tolerance, 0.01
# by default, for what rounding loses at edges. But it bounds only how far line and edge pass each
# other; where on the edge that is, a fraction, is held against 0 and 1 without any. In a corner the
# last bit decides, alike for all edges that meet there. So at z = 0.7 the line goes in and never
# comes out; at 0.6 it only comes out, and the return value says that it began inside. A tenth of
# the tolerance beside the axis, all lines have two points. One would guess that a corner, which is
# on four triangles, is hit as surely as the middle of one.
# Output seen: "z 0.6: returns -1, -0.6", "z 0.7: returns 1, 0.7", "z 1: returns 1, 1.0 -1.0",
# "axis: 5 of 40 without two points, beside it: 0".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
mkdir -p "$folder/archives/partial" "$folder/tree"
apt-get install -y -qq --no-install-recommends --download-only \
    -o "Dir::Cache::archives=$folder/archives" "python3-vtk9=$version" >/dev/null 2>&1 ||
    { echo "cannot get python3-vtk9 $version"; exit 2; }
for package in "$folder"/archives/*.deb; do
    [ ! -e "$package" ] || dpkg-deb -x "$package" "$folder/tree" || exit 2
done
libraries=$folder/tree/usr/lib/$(uname -m)-linux-gnu
cat >"$folder/hit.py" <<'END'
import vtk

FACES = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]


def octahedron(z):
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for point in (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, z), (0, 0, -z):
        points.InsertNextPoint(point)
    cells = vtk.vtkCellArray()
    for face in FACES:
        cells.InsertNextCell(3, face)
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    return mesh


def hits(mesh, x):
    tree = vtk.vtkOBBTree()
    tree.SetDataSet(mesh)
    tree.BuildLocator()
    points = vtk.vtkPoints()
    side = tree.IntersectWithLine((x, x / 2, 5), (x, x / 2, -5), points, None)
    return side, [round(points.GetPoint(at)[2], 2) for at in range(points.GetNumberOfPoints())]


meshes = {at / 10: octahedron(at / 10) for at in range(1, 41)}
for z in 0.6, 0.7, 1:
    returned, places = hits(meshes[z], 0)
    print(f"z {z}: returns {returned},", *places)
axis = sum(len(hits(mesh, 0)[1]) != 2 for mesh in meshes.values())
beside = sum(len(hits(mesh, 0.001)[1]) != 2 for mesh in meshes.values())
print(f"axis: {axis} of {len(meshes)} without two points, beside it: {beside}")
END
seen=$(LD_LIBRARY_PATH=$libraries:$libraries/blas:$libraries/lapack \
    PYTHONPATH=$folder/tree/usr/lib/python3/dist-packages \
    /usr/bin/python3 "$folder/hit.py" 2>&1)
echo "$seen"
[ "$seen" = "z 0.6: returns -1, -0.6
z 0.7: returns 1, 0.7
z 1: returns 1, 1.0 -1.0
axis: 5 of 40 without two points, beside it: 0" ]
