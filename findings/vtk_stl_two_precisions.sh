#!/bin/sh
# vtk_stl_two_precisions.sh - vtkSTLWriter writes one point as two, by the polygon it belongs to
#
# Software: Debian's python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1 (VTK 9.1.0), vtkSTLWriter,
# ASCII. Input: a quad and a triangle on one of its sides, points of type double.
# Behaviour: corners of a polygon that was a triangle already have 17 digits, those of one that
# the writer itself has cut have six. The points on the common side are written as two points
# each, so whoever welds equal corners gets a gap there. One would guess one precision per file.
# Output seen: "0.333333 0.142857 0" and "0.33333333333333331 0.14285714285714285 0" for one point.
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
cat >"$folder/write.py" <<'END'
import sys
import vtk

points = vtk.vtkPoints()
points.SetDataTypeToDouble()
for point in [(1 / 3, 0, 0), (4 / 3, 0, 0), (4 / 3, 1 / 7, 0), (1 / 3, 1 / 7, 0), (2 / 3, 2, 0)]:
    points.InsertNextPoint(point)
polygons = vtk.vtkCellArray()
for polygon in [0, 1, 2, 3], [3, 2, 4]:
    polygons.InsertNextCell(len(polygon), polygon)
data = vtk.vtkPolyData()
data.SetPoints(points)
data.SetPolys(polygons)
writer = vtk.vtkSTLWriter()
writer.SetFileTypeToASCII()
writer.SetFileName(sys.argv[1])
writer.SetInputData(data)
writer.Write()
END
LD_LIBRARY_PATH=$libraries:$libraries/blas:$libraries/lapack \
    PYTHONPATH=$folder/tree/usr/lib/python3/dist-packages \
    /usr/bin/python3 "$folder/write.py" "$folder/out.stl" || exit 2
seen=$(grep -o 'vertex 0.333.* 0.14.*' "$folder/out.stl" | sort -u)
echo "$seen"
[ "$seen" = "vertex 0.333333 0.142857 0
vertex 0.33333333333333331 0.14285714285714285 0" ]
