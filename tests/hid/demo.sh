#!/bin/sh
# demo.sh - marbles on a USB display; without one, on a panel in the terminal
#
# PLANELET, HID: the programs; DEMO: a folder for the scene; FRAMES: when to
# stop (200). SPDX-License-Identifier: MIT
set -e
mkdir -p "$DEMO"
"$PLANELET" make marbles -o "$DEMO/marbles.ply"
"$PLANELET" pack "$DEMO/marbles.ply" -o "$DEMO/marbles.plt"
program=$HID-emulated
if [ -e "$HID" ] && ! "$HID" list | grep -q '^no display'; then
    program=$HID
    "$HID" list
elif [ -t 1 ]; then
    printf '\033[2J'
fi
exec "$program" show "$DEMO/marbles.plt" --arena 4194304 --frames "${FRAMES:-200}"
