#!/bin/sh
# assimp_off_shifted.sh - with normals in an OFF, assimp takes the last of them for red
#
# Software: Debian's assimp-utils 5.2.5~ds0-1+b1 (Assimp 5.2.5).
# Input: OFF files of one triangle with colours (COFF), with texture coordinates (STOFF), and with
# normals before either (CNOFF, STNOFF), each with the same colour and coordinates.
# Behaviour: alone, colours and texture coordinates are right. Behind normals each is read one
# number early: the normal's z is red, red is green, green is blue and blue the alpha, while the
# alpha itself is not read. So whatever looks up is red, and whatever has no blue is invisible. The
# normals are right, and nothing is said. Geomview's text on OFF has normals, colours and texture
# coordinates in that order, for each of the letters N, C and ST that the header has. One would
# guess that a part is read alike, with another one before it or not.
# Output seen: "COFF: 31 63 127 255", "CNOFF: 204 31 63 127", "STOFF: 0.25 0.5", "STNOFF: 0.8 0.25".
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
# tell HEADER NUMBERS COLUMN... - those columns of the first point of assimp's PLY of such an OFF
tell() {
    header=$1 numbers=$2
    shift 2
    printf '%s\n' "$header" '3 1 0' "0 0 0 $numbers" "1 0 0 $numbers" "0 1 0 $numbers" '3 0 1 2' \
        >"$folder/in.off"
    assimp export "$folder/in.off" "$folder/out.ply" -fply >/dev/null || exit 2
    awk -v names="$*" -v header="$header" '
        $1 == "property" && $2 != "list" { column[$3] = ++count }
        seen { for (at = 1; at <= split(names, name, " "); at++)
            line = line " " sprintf("%g", $column[name[at]])
            print header ":" line; exit }
        $1 == "end_header" { seen = 1 }' "$folder/out.ply"
}
seen=$(
    tell COFF '0.125 0.25 0.5 1' red green blue alpha
    tell CNOFF '0 0.6 0.8 0.125 0.25 0.5 1' red green blue alpha
    tell STOFF '0.25 0.5' s t
    tell STNOFF '0 0.6 0.8 0.25 0.5' s t
) || exit 2
echo "$seen"
[ "$seen" = "COFF: 31 63 127 255
CNOFF: 204 31 63 127
STOFF: 0.25 0.5
STNOFF: 0.8 0.25" ]
