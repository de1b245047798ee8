#!/bin/sh
# bench.sh - rays per second of this machine, on scenes that need no download
#
# Primary rays of whole frames, one thread, shading included; the best of
# three. SPDX-License-Identifier: MIT
BUILD=${BUILD:-build}
planelet=${PLANELET:-$BUILD/host/planelet}
out=$BUILD/bench
mkdir -p "$out"

# scene NAME KIND [option ...]
scene() {
    name=$1
    shift
    [ -e "$out/$name.plt" ] && return
    "$planelet" make "$@" -o "$out/$name.ply" >/dev/null &&
        "$planelet" pack "$out/$name.ply" -o "$out/$name.plt" >/dev/null
}

# figure NAME SIDE: "mrays_per_s node_visits triangle_tests rays" of the best of three.
figure() {
    for _ in 1 2 3; do
        "$planelet" render "$out/$1.plt" -o "$out/$1.ppm" --size 1024x1024 --packet "$2" \
            --json - | awk -F '[:,]' '
            /"mrays_per_s"/ { m = $2 } /"node_visits"/ { n = $2 }
            /"triangle_tests"/ { t = $2 } /"rays"/ { r = $2 }
            END { printf "%.2f %.4f %.4f\n", m, n / r, t / r }'
    done | sort -rn | head -n 1
}

scene marbles marbles
scene knot100k knot --triangles 100000
scene terrain1m terrain --triangles 1000000
printf '%-10s %6s %8s %12s %18s\n' scene packet Mray/s visits/ray triangle-tests/ray
for name in marbles knot100k terrain1m; do
    for side in 2 4 8 16; do
        # shellcheck disable=SC2046
        printf '%-10s %4dx%-2d %8s %12s %18s\n' "$name" $side $side $(figure "$name" $side)
    done
done
