#!/bin/sh
# vtk_ply_float_colours.sh - VTK reads a PLY's float colours as black, or as one step from it
#
# Software: Debian's python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1 (VTK 9.1.0), vtkPLYReader.
# Input: a PLY of three points and one triangle, whose colours are float properties from 0 to 1, and
# the same with uchar properties from 0 to 255.
# Behaviour: the header gives each property a type, and VTK converts it to the one it wants, by a
# cast: 1.0 becomes 1 of 255, all below 0. The array is there, named RGB, of bytes, without a
# warning, so the mesh is drawn black, and the PLY that VTK writes of it is black for all others,
# too. assimp, three.js, PCL and OpenMesh scale by the property's type or keep the floats. One would
# guess that a reader that looks at the type knows the range that goes with it.
# Output seen: "uchar: 255 128 64, 0 255 0, 10 20 30", "float: 1 0 0, 0 1 0, 0 0 0".
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
cat >"$folder/read.py" <<'END'
import sys
import vtk

colours = [(255, 128, 64), (0, 255, 0), (10, 20, 30)]
points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
for kind, scale in ("uchar", 1), ("float", 255):
    lines = ["ply", "format ascii 1.0", "element vertex 3"]
    lines += ["property float " + name for name in ("x", "y", "z")]
    lines += ["property %s %s" % (kind, name) for name in ("red", "green", "blue")]
    lines += ["element face 1", "property list uchar int vertex_indices", "end_header"]
    for point, colour in zip(points, colours):
        lines.append(" ".join("%g" % number for number in
                              point + tuple(channel / scale for channel in colour)))
    lines += ["3 0 1 2", ""]
    name = "%s/%s.ply" % (sys.argv[1], kind)
    with open(name, "w") as file:
        file.write("\n".join(lines))
    reader = vtk.vtkPLYReader()
    reader.SetFileName(name)
    reader.Update()
    array = reader.GetOutput().GetPointData().GetScalars()
    print(kind + ": " + ", ".join("%d %d %d" % array.GetTuple(at) for at in range(3)))
END
seen=$(LD_LIBRARY_PATH=$libraries:$libraries/blas:$libraries/lapack \
    PYTHONPATH=$folder/tree/usr/lib/python3/dist-packages \
    /usr/bin/python3 "$folder/read.py" "$folder" 2>&1) || exit 2
echo "$seen"
[ "$seen" = "uchar: 255 128 64, 0 255 0, 10 20 30
float: 1 0 0, 0 1 0, 0 0 0" ]
