#!/bin/sh
# bunny.sh BUNNY.ply - README's second picture: the bunny on a slab, as a Cortex-M4F renders it
#
# The mesh is the user's own: Stanford's bunny of 69,451 triangles (bun_zipper.ply of
# graphics.stanford.edu/data/3Dscanrep) gives the picture of README. It is packed small, goes into
# the flash of a board in QEMU, and is lit by a soft sun and a sky, four samples per pixel. The
# host's picture is left in build/demo/bunny.png; it counts as the board's only if both have one
# hash. BUILD, MAKE as in the Makefile; SIZE: 320x240. SPDX-License-Identifier: MIT
build=${BUILD:-build} size=${SIZE:-320x240}
parts='render compact whitted samples'
say() {
    echo "demo-bunny: $1" >&2
    exit 1
}
for tool in arm-none-eabi-gcc qemu-system-arm; do
    command -v "$tool" >/dev/null 2>&1 || say "there is no $tool here; run: make setup"
done
[ -n "$1" ] || say "which bunny? make demo-bunny BUNNY=bunny.ply, or another mesh"
[ -r "$1" ] || say "$1 cannot be read; name a mesh: make demo-bunny BUNNY=bunny.ply"
set -e
planelet=$build/host/planelet demo=$build/demo
firmware=$build/mps2_an386-compact-render-samples-whitted
mkdir -p "$demo"
${MAKE:-make} -s BUILD="$build" BOARD=mps2_an386 PARTS="$parts" >/dev/null
"$planelet" make ground -o "$demo/slab.ply"
case $1 in /*) mesh=$1 ;; *) mesh=$PWD/$1 ;; esac
printf '%s\n' "slab.ply 20 0 -0.5 0" "$mesh 5 0 -0.01 0 0 20" >"$demo/bunny.txt"
"$planelet" pack "$demo/bunny.txt" -o "$demo/bunny.plt" --nodes compact --geometry lattice:14 \
    2>"$demo/bunny_lines.txt" # slivers, and where the mesh is open
view=$(sh board/tools/host_view.sh "$demo/bunny.plt" "$size" "$demo/bunny.png" --shader whitted \
    --eye 1.2,4.2,12 --look 0.15,2.3,0 --fov 27 --depth 0 --samples 4 \
    --light sun:-0.8,0.8,0.35,0.8,0.06,2 --sky 0.36,0.45,0.6 --ground 0.2,0.17,0.14)
# shellcheck disable=SC2086
FIRMWARE=$firmware sh board/mps2_an386/run.sh "$demo/bunny.plt" size="$size" arena=262144 \
    shader=whitted samples=4 depth=0 sun=-0.8,0.8,0.35,0.8,0.06,2 sky=0.36,0.45,0.6 \
    ground=0.2,0.17,0.14 ${view#* } >"$demo/bunny_run.txt" || {
    cat "$demo/bunny_run.txt" >&2
    exit 1
}
tr ' ' '\n' <"$demo/bunny_run.txt" | awk -F = -v hash="${view%% *}" -v picture="$demo/bunny.png" '
    !($1 in n) { n[$1] = $2 }
    END {
        if (n["frame_hash"] != hash) {
            print "the board has frame " n["frame_hash"] ", the host " hash; exit 1 }
        printf "%d triangles in %d bytes of flash, %d rays, %.0f million instructions of a ",
            n["triangles"], n["image_bytes"], n["rays"], n["render"] / 1e6
        printf "Cortex-M4F, %d bytes of arena\n", n["peak"]
        print picture " is its frame, " hash }'
