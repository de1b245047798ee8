#!/bin/sh
# readers.sh WORK - readers of others count what `planelet make` writes
#
# Those that read STL only get the same triangles as STL, written by Python. A reader counts when
# the exporter of its name is there. SPDX-License-Identifier: MIT
here=$(cd "$(dirname "$0")" && pwd)
made=$1/made
log=$1/log
rm -rf "$made" && mkdir -p "$made"
"$PLANELET" make ground -o "$made/ground.ply" &&
    "$PLANELET" make marbles -o "$made/marbles.ply" &&
    "$PLANELET" make knot --triangles 5000 -o "$made/knot.ply" &&
    "$PLANELET" make terrain --triangles 5000 -o "$made/terrain.ply" || exit 1
python3 "$here/counts.py" "$PLANELET" "$made"/*.ply >"$made/counts" || exit 1

# Where the exporter of that name could not be installed, there is no folder of its files.
readers=0 differences=0
for script in "$here"/read/read_*; do
    name=$(basename "${script#*/read/read_}")
    name=${name%.*}
    [ -d "$1/files/$name" ] || continue
    readers=$((readers + 1))
    timeout 300 sh "$here/run.sh" "$script" "$made"/*.ply >"$log/read_$name" 2>&1 </dev/null
    awk -v reader="$name" '
        FNR == NR { triangles[$1] = $2; vertices[$1] = $3; next }
        ($1 in triangles) && NF == 3 {
            seen++
            if ($2 != triangles[$1] || ($3 != "-" && $3 != vertices[$1])) {
                print "FAIL " reader ": " $1 ": " $2 " triangles, " $3 " vertices, not " \
                    triangles[$1] ", " vertices[$1]
                wrong++
            }
        }
        END {
            for (mesh in triangles) { meshes++ }
            if (seen != meshes) { print "FAIL " reader ": counted " seen + 0 " meshes"; wrong++ }
            exit wrong != 0
        }' "$made/counts" "$log/read_$name" || differences=$((differences + 1))
done
echo "$readers readers, $differences of them differ"
[ $differences -eq 0 ]
