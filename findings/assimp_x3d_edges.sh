#!/bin/sh
# assimp_x3d_edges.sh - an X3D's sharp edge comes out of assimp bent over one of its two faces
#
# Software: Debian's assimp-utils 5.2.5~ds0-1+b1 (Assimp 5.2.5).
# Input: an X3D of two triangles at a right angle that share an edge, as an IndexedFaceSet with two
# normals: once one for each face (normalPerVertex false), once by corner, with a normalIndex that
# is laid out as coordIndex. Both say the same: three corners look along z, three along -y.
# Behaviour: assimp keeps one normal for each point of the Coordinate node. The two points of the
# edge get the last face's normal or the first one's, by how the file says it, so one face is flat
# and the other has corners that look a right angle away, and is shaded as if it were round. A mesh
# of assimp's can have a point twice, and from OBJ with normals by corner it has. One would guess
# six corners with their own normals, which X3D has for both (ISO/IEC 19775-1, 13.3.6).
# Output seen: "by face: 0 -1 0, 0 -1 0, 0 0 1 and 0 -1 0, 0 -1 0, 0 -1 0", "by corner: 0 0 1, 0 0
# 1, 0 0 1 and 0 0 1, 0 0 1, 0 -1 0".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
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
# tell FIELDS - the normals at the corners of the two faces, with those fields in IndexedFaceSet
tell() {
    cat >"$folder/in.x3d" <<END
<?xml version="1.0" encoding="UTF-8"?>
<X3D profile="Interchange" version="3.3"><Scene><Shape>
<IndexedFaceSet coordIndex="0 1 2 -1 1 0 3 -1" $1>
<Coordinate point="0 0 0 1 0 0 0 1 0 0 0 -1"/><Normal vector="0 0 1 0 -1 0"/>
</IndexedFaceSet></Shape></Scene></X3D>
END
    assimp export "$folder/in.x3d" "$folder/out.obj" -fobj >/dev/null || exit 2
    awk '$1 == "vn" { normal[++count] = $2 " " $3 " " $4 }
        $1 == "f" { line = ""
            for (at = 2; at <= 4; at++) {
                split($at, index_of, "/")
                line = line (at > 2 ? ", " : "") normal[index_of[3]]
            }
            all = all (all ? " and " : "") line }
        END { print all }' "$folder/out.obj"
}
by_face=$(tell 'normalPerVertex="false"') || exit 2
by_corner=$(tell 'normalIndex="0 0 0 -1 1 1 1 -1"') || exit 2
seen="by face: $by_face
by corner: $by_corner"
echo "$seen"
[ "$seen" = "by face: 0 -1 0, 0 -1 0, 0 0 1 and 0 -1 0, 0 -1 0, 0 -1 0
by corner: 0 0 1, 0 0 1, 0 0 1 and 0 0 1, 0 0 1, 0 -1 0" ]
