#!/bin/sh
# test_boards.sh - every board renders the host's frame, bit for bit, in its own memory
#
# One scene for all: as large as the smallest flash. What does not fit is refused with both sizes.
# At the end a table, and boards.csv in build/: bytes of code and constants of the engine and of the
# firmware, RAM, arena, stack, the longest step, and what a ray takes (rows.sh). tests/golden/
# boards.csv is the budget, 1 % more at most: what is above it fails, and a change that is meant
# copies lines of the new table there. A board that ON names needs none yet.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
export BUILD
. tests/boards/rows.sh
folder=$BUILD/boards
scene="$folder/a knot, of 600.plt" # a blank and a comma, which QEMU and the firmware end words by
mkdir -p "$folder"
"$planelet" make knot --triangles 600 -o "$folder/knot.ply" >/dev/null &&
    "$planelet" pack "$folder/knot.ply" -o "$scene" >/dev/null ||
    verdict "the scene is made" "planelet failed"

room_for() { # scene|frame: bytes of the board's memory for it
    "$(cross_of "$board")nm" "$built/firmware.elf" | awk -v from="plt_$1_start" -v to="plt_$1_end" '
        function number(digits,    i, sum) {
            for (i = 1; i <= length(digits); i++) {
                sum = 16 * sum + index("0123456789abcdef", substr(digits, i, 1)) - 1
            }
            return sum
        }
        $3 == from { first = number($1) }
        $3 == to { last = number($1) }
        END { printf "%d\n", last - first }'
}
run() { # SCENE [key=value ...]: sets text
    text=$(FIRMWARE=$built sh "board/$board/run.sh" "$@" 2>&1)
}
said() { # SENTENCE PATTERN
    verdict "$board: $1" "$(echo "$text" | grep -q "$2" || echo "$text")"
}

# What does not fit the board is refused with both sizes, and a name with a blank is opened.
sizes_are_said() {
    run "$scene" size=16x12 arena=1000
    said "an arena that is too small: both sizes are said" \
        '^error: .*need_bytes=[1-9][0-9]* arena_bytes=1000$'
    most=$(room_for scene)
    head -c $((most + 1)) /dev/zero >"$folder/large.plt"
    run "$folder/large.plt" size=16x12
    rm -f "$folder/large.plt"
    said "a scene that is too large: both sizes are said" \
        "^error: the scene has $((most + 1)) bytes, and this board has room for $most\$"
    most=$(room_for frame)
    if [ "$most" -gt 0 ]; then
        run "$scene" size=9000x5000
        said "a frame that is too large: both sizes are said" \
            "^error: the frame has 135000000 bytes, and this board has room for $most\$"
    fi
    text=$(SOURCE=file FIRMWARE=$built sh "board/$board/run.sh" "$scene" size=16x12 2>&1)
    verdict "$board: a file whose name has a blank and a comma is opened by semihosting" "$(
        echo "$text" | grep -q '^scene triangles=600 ' || echo "$text" | grep -q need_bytes ||
            echo "$text")"
    text=$($MAKE -s BOARD="$board" PROGRAM=faults BUILD="$folder/refused" \
        ARENA_BYTES=67108864 2>&1) && text="linked: $text"
    rm -rf "$folder/refused"
    said "an arena that does not fit does not link: both sizes are said" \
        "arena of 67108864 bytes and a stack of [0-9]* do not fit on $board: of its [0-9]* bytes"
}

table=$BUILD/boards.csv
echo "$boards_header" >"$table"
wanted=
for board in $(boards); do
    built=$BUILD/$board
    make_board "$board" || continue
    verdict "$board: gcc compiles the firmware without a warning" "$(
        find "$built" -name '*.log' -size +0 -exec cat {} +)"
    board_row "$scene" >>"$table"
    hash=$(value frame_hash)
    wanted=${wanted:-$hash}
    verdict "$board: the frame is the host's, and that of all boards: $hash" "$(
        [ "$status" -eq 0 ] || echo "status $status: $text"
        [ -n "$hash" ] && [ "$hash" = "$wanted" ] || echo "of another board $wanted")"
    verdict "$board: the stack stays below its bound, $(value painted) of $(value worst)" "$(
        [ "$(value painted)" -gt 0 ] && [ "$(value painted)" -le "$(value worst)" ] &&
            [ "$(value stored)" -le "$(value worst)" ] || echo "$text")"
    verdict "$board: the longest step is shorter by one visit, in packets of 2x2" "$(
        awk -F, -v board="$board" '$1 == board { whole = $13; finest = $14 }
            END { if (!(finest > 0 && finest < whole)) { print finest " of " whole } }' "$table")"
    sizes_are_said
done

awk -F, 'NR > 1 { printf "    %-17s %7s %8s %7s %7s %6s %6s %8s %8s  %s\n",
    $1, $2 + $3, $6, $8, $9, $11, $12, $13, $15, $16 }' "$table"
compared=$(awk -v new="$ON" -f tests/boards/budget.awk tests/golden/boards.csv "$table" ||
    echo "error: not compared")
echo "$compared" | sed -n '/^error/!s/^./    &/p'
verdict "no figure is above its budget, tests/golden/boards.csv, which takes lines of $table, then \
make tables" "$(echo "$compared" | grep '^error')"
finish
