#!/bin/sh
# assimp_ply_colour_types.sh - assimp's binary PLY with colours is not what its header says
#
# Software: Debian's assimp-utils 5.2.5~ds0-1+b1 (Assimp 5.2.5). Input: an OBJ of one triangle
# with colours behind the coordinates, which assimp reads.
# Behaviour: `assimp export -fplyb` declares red, green, blue and alpha as uchar, one byte each,
# and writes four floats per vertex, 16 bytes. With the header's types the body is 36 bytes too
# long, faces are sought among colours, and no reader can know. The same mesh as ASCII PLY
# (-fply) has whole numbers that fit the header. One would guess that the writer of a header and
# the writer of its body agree.
# Output seen: "property uchar red", "61 bytes by the header, 97 written", "ascii: 0 0 0 255 0 51
# 255".
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
printf '%s\n' 'v 0 0 0 1 0 0.2' 'v 1 0 0 0 1 0' 'v 0 1 0 0 0 1' 'f 1 2 3' >"$folder/in.obj"
for kind in ply plyb; do
    assimp export "$folder/in.obj" "$folder/$kind.ply" -f$kind >/dev/null || exit 2
done
start=$(grep -a -b '^end_header' "$folder/plyb.ply" | cut -d: -f1)
written=$(($(wc -c <"$folder/plyb.ply") - start - 11))
seen="$(grep -a '^property' "$folder/plyb.ply" | sed -n 4p)
$((3 * (3 * 4 + 4) + 1 + 3 * 4)) bytes by the header, $written written
ascii: $(sed -n '/^end_header/{n;p;}' "$folder/ply.ply")"
echo "$seen"
[ "$seen" = "property uchar red
61 bytes by the header, 97 written
ascii: 0 0 0 255 0 51 255" ]
