#!/bin/sh
# play.sh BOARD SCENE.plt WIDTHxHEIGHT [key=value ...] - a board in QEMU plays a sequence
#
# Gives the firmware of PROGRAM=played (board/played) the camera of `planelet render`, and prints
# what its frames took, the longest call of each function of the engine, what became of the arena,
# and whether the frames are the host's (play.awk). FRAMES=A:B are the frames to be played (all),
# MOST the instructions that a call may take at most while they are. Leaves in FIRMWARE, the folder
# where it was built: played.txt (what it printed), marks.txt (what the counter had), frames.txt (a
# row for each frame). SPDX-License-Identifier: MIT
board=$1 scene=$2 size=$3
shift 3
say() {
    echo "play: $1" >&2
    exit "$2"
}
[ -n "$scene" ] || say "which scene? make BOARD=$board play SCENE=x.plt [FRAMES=0:500]" 2
planelet=${BUILD:-build}/host/planelet
out=${FIRMWARE:?the folder of the firmware}
case ${MOST:-0} in
*[!0-9]*) say "MOST=$MOST is no number of instructions; use digits alone" 2 ;;
esac
count=$("$planelet" info "$scene" --json | sed -n 's/^  "frames": \([0-9]*\),*$/\1/p')
[ "${count:-0}" -gt 0 ] || say "$scene has no frames; planelet pack --sequence makes them" 1
frames=${FRAMES:-0:$count}
"$planelet" render "$scene" --view box --size "$size" --frames "$frames" \
    --json "$out/host.json" || exit 1
camera=$(awk -F '"' '$2 ~ /^(eye|look|up|tan)$/ { printf " %s=%s", $2, $4 }' "$out/host.json")
# shellcheck disable=SC2086
MARKS=$out/marks.txt QEMU_SECONDS=${QEMU_SECONDS:-7200} sh "board/$board/run.sh" "$scene" \
    "size=$size" $camera "frames=$frames" "$@" >"$out/played.txt" 2>&1
status=$?
grep -v '^played \|^instructions\|^bounds \|^arena ' "$out/played.txt"
[ $status -eq 0 ] || exit $status
awk -v table="$out/frames.txt" -v most="${MOST:-0}" -f board/tools/play.awk \
    "$out/host.json" "$out/marks.txt" "$out/played.txt" || exit 1
echo "a row for each frame is in $out/frames.txt"
