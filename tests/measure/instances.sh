#!/bin/sh
# instances.sh - bodies that matrices place, beside the same triangles as a sequence
#
# Bytes per frame and of arenas, and instructions (callgrind) per frame that is shown, and that
# is rendered at 480x240: marbles of 80 triangles each, and KNOTS knots of 20,000.
# SPDX-License-Identifier: MIT
PLANELET=${PLANELET:-build/host/planelet}
case $PLANELET in /*) ;; *) PLANELET=$PWD/$PLANELET ;; esac
command -v valgrind >/dev/null || {
    echo "instances.sh counts instructions with valgrind; install it" >&2
    exit 2
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
KNOTS=${KNOTS:-12}
FRAMES=4

# planelet ARGUMENT...: quietly; nothing is measured where it fails.
planelet() {
    "$PLANELET" "$@" >said 2>&1 || {
        cat said >&2
        exit 1
    }
}

# counted FUNCTION SCENE FLAG...: instructions in FUNCTION and what it calls, per frame.
counted() {
    function=$1
    shift
    valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect="$function" \
        "$PLANELET" render "$@" -o x.y4m --frames 0:$FRAMES --size 480x240 --view box 2>&1 |
        awk -v frames=$FRAMES '/Collected/ { printf "%.1f", $4 / frames / 1e6 }'
}

# field NAME: of the info in `info`.
field() {
    sed -n 's/^ *"'"$1"'": \([0-9.]*\),*$/\1/p' info
}

# row NAME SCENE FLAG...
row() {
    name=$1 scene=$2
    shift 2
    "$PLANELET" info "$scene" --json >info
    arena=$("$PLANELET" info "$scene" | sed -n 's/^arena with frames  \([0-9]*\) .*/\1/p')
    [ -n "$arena" ] || arena=$(field arena_bytes_needed)
    printf '| %s | %d | %d | %d | %s | %s |\n' "$name" \
        "$(($(field frame_bytes) / $(field frames)))" "$(wc -c <"$scene")" "$arena" \
        "$(counted plt_sequence_show "$scene" "$@")" "$(counted plt_render_step "$scene" "$@")"
}

planelet make marbles --instances --frames $FRAMES -o marbles.txt
planelet pack --instances marbles.txt -o marbles.plt
planelet make marbles --frames $FRAMES -o 'marbles_{}.ply'
planelet pack --sequence marbles_00?.ply -o marbles_16.plt
planelet pack --sequence marbles_00?.ply --geometry float -o marbles_float.plt

# Knots on a circle, which go up and down: the same corners both ways, but for rounding.
planelet make knot --triangles 20000 -o knot.ply
planelet pack knot.ply -o knot.plt
"$PLANELET" info knot.plt | sed -n 's/^box *//p' | tr -d '(),' | sed 's/ to / /' |
    awk -v knots="$KNOTS" -v frames=$FRAMES '{
    print "body knot knot.ply" >"knots.txt"
    for (i = 0; i < knots; i++) print "instance k" i " knot" >"knots.txt"
    size = $4 - $1 > $6 - $3 ? $4 - $1 : $6 - $3
    size = $5 - $2 > size ? $5 - $2 : size
    for (f = 0; f < frames; f++) for (i = 0; i < knots; i++) {
        at = 6.2831853 * i / knots
        x = 16 * cos(at); y = sin(3 * at + f / 5); z = 16 * sin(at)
        printf "frame %d k%d 1 0 0 %.6f 0 1 0 %.6f 0 0 1 %.6f\n", f, i, x, y, z >"knots.txt"
        printf "knot.ply %.6f %.6f %.6f %.6f\n", size, x + ($1 + $4) / 2, y + $2,
            z + ($3 + $6) / 2 >("knots_00" f ".txt")
    }
}'
planelet pack --instances knots.txt -o knots.plt
planelet pack --sequence knots_00?.txt -o knots_16.plt

near='--eye 9,17,30 --look 0,-1.5,0.5 --fov 33'
far='--eye 8,16,38 --look 0,0,0 --fov 45'
echo "| | bytes per frame | image | arena | shown, million instructions | rendered |"
echo "|---|---:|---:|---:|---:|---:|"
# shellcheck disable=SC2086
{
    row "marbles, 110 instances" marbles.plt $near
    row "... a sequence, 16 bits" marbles_16.plt $near
    row "... floats" marbles_float.plt $near
    row "$KNOTS knots" knots.plt $far
    row "... a sequence, 16 bits" knots_16.plt $far
}
