#!/bin/sh
# demo.sh [serve option ...] - a board in QEMU renders, its frames are shown as they come
#
# The board starts empty: scene and views go to it over its serial line, frames
# come back over the same line. BUILD, MAKE as in the Makefile; BOARD: one that has a
# wired.sh (the first); SCENE: a packed scene (marbles); FRAMES: how many, once
# around it (25); SIZE: of a frame (320x240); PARTS: of the engine, and FIRMWARE: the folder
# where it is built then; BOARD_LOG: keeps what the firmware prints. Without options the frames
# are drawn in the terminal.
# SPDX-License-Identifier: MIT
build=${BUILD:-build}
name=$BOARD
[ -n "$name" ] || for script in board/*/wired.sh; do
    name=$(basename "$(dirname "$script")")
    break
done
say() {
    echo "demo-firmware: $1" >&2
    exit 1
}
for tool in arm-none-eabi-gcc qemu-system-arm; do
    command -v "$tool" >/dev/null 2>&1 || say "there is no $tool here; run: make setup"
done
[ -e "board/$name/wired.sh" ] || say "there is no board/$name/wired.sh, which would start it"
[ -z "$SCENE" ] || [ -r "$SCENE" ] || say "$SCENE cannot be read; planelet pack makes scenes"
set -e
scene=$SCENE
planelet=$build/host/planelet
demo=$build/demo
${MAKE:-make} -s BUILD="$build" BOARD="$name" PROGRAM=wired PARTS="$PARTS"
if [ -z "$scene" ]; then
    scene=$demo/marbles-compact.plt
    mkdir -p "$demo"
    "$planelet" make marbles -o "$demo/marbles.ply"
    # Compact, so that scene and engine fit into 256 KiB together.
    "$planelet" pack "$demo/marbles.ply" -o "$scene" --nodes compact --geometry lattice:14
    [ $# -gt 0 ] || set -- --show --eye 9,17,30 --look 0,-1.5,0.5 --fov 33
fi
[ $# -gt 0 ] || set -- --show

folder=$(mktemp -d) # a socket's path must be short
board=
end() {
    [ -z "$board" ] || { kill "$board" && wait "$board"; } 2>/dev/null || :
    rm -rf "$folder"
}
trap end EXIT
trap 'exit 130' INT TERM
BUILD=$build sh "board/$name/wired.sh" "$folder/wire" >"${BOARD_LOG:-/dev/null}" 2>&1 &
board=$!
"$planelet" serve "$scene" --socket "$folder/wire" --size "${SIZE:-320x240}" \
    --orbit "${FRAMES:-25}" "$@"
