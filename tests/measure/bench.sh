#!/bin/sh
# bench.sh [FLAG...] - rays per second of this machine, on scenes that need no download
#
# Makes three scenes and hands them to `planelet bench`, with its flags. One thread.
# SPDX-License-Identifier: MIT
BUILD=${BUILD:-build}
planelet=${PLANELET:-$BUILD/host/planelet}
out=$BUILD/bench
mkdir -p "$out"

# scene NAME KIND [option ...]
scene() {
    name=$1
    shift
    [ -e "$out/$name.ply" ] || "$planelet" make "$@" -o "$out/$name.ply" >/dev/null
}

scene marbles marbles
scene knot100k knot --triangles 100000
scene terrain1m terrain --triangles 1000000
"$planelet" bench "$out/marbles.ply" "$out/knot100k.ply" "$out/terrain1m.ply" "$@"
