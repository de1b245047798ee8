#!/bin/sh
# demo.sh [serve option ...] - marbles, rendered by a board in QEMU, shown as they come
#
# The board starts empty: scene and views go to it over its serial line, frames
# come back over the same. BUILD, MAKE as in the Makefile; FRAMES: how many, once
# around the scene (25); SIZE: of a frame (320x240); BOARD_LOG: keeps what the
# firmware prints. Without options the frames are drawn in the terminal.
# SPDX-License-Identifier: MIT
build=${BUILD:-build}
for tool in arm-none-eabi-gcc qemu-system-arm; do
    if ! command -v "$tool" >/dev/null 2>&1; then
        echo "demo-firmware: there is no $tool here; run: make setup" >&2
        exit 1
    fi
done
set -e
[ $# -gt 0 ] || set -- --show --eye 9,17,30 --look 0,-1.5,0.5 --fov 33
planelet=$build/host/planelet
demo=$build/demo
mkdir -p "$demo"
${MAKE:-make} -s BUILD="$build" BOARD=mps2_an386 PROGRAM=wired
"$planelet" make marbles -o "$demo/marbles.ply"
# Compact, so that scene and engine fit into 256 KiB together.
"$planelet" pack "$demo/marbles.ply" -o "$demo/marbles-compact.plt" \
    --nodes compact --geometry lattice:14

folder=$(mktemp -d) # a socket's path must be short
board=
end() {
    [ -z "$board" ] || { kill "$board" && wait "$board"; } 2>/dev/null || :
    rm -rf "$folder"
}
trap end EXIT
trap 'exit 130' INT TERM
BUILD=$build sh board/mps2_an386/wired.sh "$folder/wire" >"${BOARD_LOG:-/dev/null}" 2>&1 &
board=$!
"$planelet" serve "$demo/marbles-compact.plt" --socket "$folder/wire" \
    --size "${SIZE:-320x240}" --orbit "${FRAMES:-25}" "$@"
