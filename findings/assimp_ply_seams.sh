#!/bin/sh
# assimp_ply_seams.sh - assimp reads a PLY's texture coordinates per face, and keeps the last face's
#
# Software: Debian's assimp-utils 5.2.5~ds0-1+b1.
# Input: a PLY of two triangles that share an edge, whose faces have a list "texcoord" of six floats
# beside "vertex_indices", as MeshLab writes it; the two vertices of the edge have other coordinates
# in the second triangle than in the first, which is what such a list is for: a seam.
# Behaviour: assimp knows the list, but stores its numbers with the vertices of the file, one pair
# for each, so that the face read last overwrites those before it. All textures are torn at seams,
# and nothing is said. One would guess that corners are told apart, as the same program does for an
# OBJ of the same faces, where both coordinates arrive.
# Output seen: of the PLY "0.6 0 / 0.5 0 / 0.9 1 / 0.6 1", of the OBJ "0 0 / 0.5 0 / 0.5 1 / 0.6 0
# / 0.9 1 / 0.6 1".
# Exit status 1 when that changes, 2 when the package cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
version=5.2.5~ds0-1+b1
mkdir -p "$folder/archives/partial" "$folder/tree"
apt-get install -y -qq --no-install-recommends --download-only \
    -o "Dir::Cache::archives=$folder/archives" "assimp-utils=$version" >/dev/null 2>&1 ||
    { echo "cannot get assimp-utils $version"; exit 2; }
for package in "$folder"/archives/*.deb; do
    [ ! -e "$package" ] || dpkg-deb -x "$package" "$folder/tree" || exit 2
done
PATH=$folder/tree/usr/bin:$PATH
LD_LIBRARY_PATH=$folder/tree/usr/lib/$(uname -m)-linux-gnu
export PATH LD_LIBRARY_PATH
cd "$folder" || exit 2
cat >seam.ply <<'PLY'
ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 2
property list uchar int vertex_indices
property list uchar float texcoord
end_header
0 0 0
1 0 0
1 1 0
0 1 0
3 0 1 2 6 0 0 0.5 0 0.5 1
3 0 2 3 6 0.6 0 0.9 1 0.6 1
PLY
cat >seam.obj <<'OBJ'
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0 0
vt 0.5 0
vt 0.5 1
vt 0.6 0
vt 0.9 1
vt 0.6 1
f 1/1 2/2 3/3
f 1/4 3/5 4/6
OBJ
coordinates() {
    assimp export "$1" out.obj -fobj >assimp.txt || exit 2
    awk '$1 == "vt" { printf "%s%.1g %.1g", n++ ? " / " : "", $2, $3 } END { print "" }' out.obj
}
seen="PLY $(coordinates seam.ply)
OBJ $(coordinates seam.obj)"
echo "$seen"
[ "$seen" = "PLY 0.6 0 / 0.5 0 / 0.9 1 / 0.6 1
OBJ 0 0 / 0.5 0 / 0.5 1 / 0.6 0 / 0.9 1 / 0.6 1" ]
