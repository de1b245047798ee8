#!/bin/sh
# meshio_obj_negative.sh - meshio takes an OBJ's relative indices for other vertices, unsaid
#
# Software: Debian's python3-meshio 7.0.0-3 (upstream 5.0.0).
# Input: an OBJ of two triangles, each directly behind its three vertices, as "f -3 -2 -1": OBJ
# counts negative indices back from the last vertex read so far. One triangle lies at z = 0, the
# other at z = 5.
# Behaviour: one is taken from each number, whatever its sign, so both triangles are -4 -3 -2. As
# numpy counts negative indices from an array's end, all that looks up points works, and has the
# same, wrong triangle twice: it has corners at z = 0 and at z = 5. The PLY that meshio makes of it
# lists -4 -3 -2 as its faces. One would guess 0 1 2 and 3 4 5, or an error.
# Output seen: "read: [[-4, -3, -2], [-4, -3, -2]]", "z: [[0.0, 5.0, 5.0], [0.0, 5.0, 5.0]]",
# "written: 3 -4 -3 -2".
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
printf '%s\n' 'v 0 0 0' 'v 1 0 0' 'v 0 1 0' 'f -3 -2 -1' \
    'v 0 0 5' 'v 1 0 5' 'v 0 1 5' 'f -3 -2 -1' >"$folder/in.obj"
cat >"$folder/read.py" <<'END'
import sys
import meshio

mesh = meshio.read(sys.argv[1] + "/in.obj")
triangles = mesh.cells_dict["triangle"]
print("read:", triangles.tolist())
print("z:", mesh.points[triangles][:, :, 2].tolist())
meshio.write(sys.argv[1] + "/out.ply", mesh, binary=False)
END
seen=$(LD_LIBRARY_PATH=$libraries:$libraries/blas:$libraries/lapack \
    PYTHONPATH=$folder/tree/usr/lib/python3/dist-packages \
    /usr/bin/python3 "$folder/read.py" "$folder" 2>/dev/null) || exit 2
seen="$seen
written: $(tail -n 1 "$folder/out.ply")"
echo "$seen"
[ "$seen" = "read: [[-4, -3, -2], [-4, -3, -2]]
z: [[0.0, 5.0, 5.0], [0.0, 5.0, 5.0]]
written: 3 -4 -3 -2" ]
