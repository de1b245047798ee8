#!/bin/sh
# test_boards.sh - every board renders the host's frame, bit for bit, in its own memory
#
# One scene for all: as large as the smallest flash. At the end a table, and boards.csv in build/:
# bytes of code and constants of the engine and of the firmware, RAM, arena, stack, and what a ray
# takes. SPDX-License-Identifier: MIT
. tests/check/report.sh
export BUILD
planelet=$BUILD/host/planelet
folder=$BUILD/boards
scene="$folder/a knot, of 600.plt" # a blank and a comma, which QEMU and the firmware end words by
size=80x60
mkdir -p "$folder"
"$planelet" make knot --triangles 600 -o "$folder/knot.ply" >/dev/null &&
    "$planelet" pack "$folder/knot.ply" -o "$scene" >/dev/null ||
    verdict "the scene is made" "planelet failed"

value() { # NAME: of the last NAME=value in the text
    echo "$text" | tr ' ' '\n' | sed -n "s/^$1=//p" | tail -n 1
}
bytes_of() { # COLUMN OBJECT...: sum of a column of size: 1 code and constants, 2 data, 3 bss
    column=$1
    shift
    "$(cross_of "$board")size" "$@" | awk -v c="$column" 'NR > 1 { s += $c } END { print s + 0 }'
}

table=$BUILD/boards.csv
echo "board,engine_code,engine_data,engine_bss,firmware_code,ram_without_arena_and_stack,\
arena_bytes,arena_peak,stack_bytes,stack_worst,stack_painted,instructions_per_ray,frame_hash" \
    >"$table"
wanted=
for board in $(boards); do
    out=$BUILD/$board
    make_board "$board" || continue
    verdict "$board: gcc compiles the firmware without a warning" "$(
        find "$out" -name '*.log' -size +0 -exec cat {} +)"
    text=$(FIRMWARE=$out sh board/tools/run_like_host.sh "$board" "$scene" "$size" 2>&1)
    status=$?
    hash=$(value frame_hash)
    wanted=${wanted:-$hash}
    verdict "$board: the frame is the host's, and that of all boards: $hash" "$(
        [ "$status" -eq 0 ] && echo "$text" | grep -q '^the host renders the same frame' ||
            echo "status $status: $text"
        [ -n "$hash" ] && [ "$hash" = "$wanted" ] || echo "of another board $wanted")"
    verdict "$board: the stack stays below its bound, $(value painted) of $(value worst)" "$(
        [ "$(value painted)" -gt 0 ] && [ "$(value painted)" -le "$(value worst)" ] &&
            [ "$(value stored)" -le "$(value worst)" ] || echo "$text")"
    engine=$(sed -n "s|^LOAD \\($out/engine/.*\\.o\\)\$|\\1|p" "$out/firmware.map")
    stack=$(echo "$text" | sed -n 's/^stack painted=.* bytes=//p')
    arena=$(echo "$text" | sed -n 's/^arena .* bytes=//p')
    # shellcheck disable=SC2086
    data=$(bytes_of 2 $engine) bss=$(bytes_of 3 $engine) code=$(bytes_of 1 $engine)
    verdict "$board: the engine has no data and no bss" "$(
        [ "$data" -eq 0 ] && [ "$bss" -eq 0 ] || echo "data $data, bss $bss")"
    other=$(($(bytes_of 2 "$out/firmware.elf") + $(bytes_of 3 "$out/firmware.elf")))
    echo "$board,$code,$data,$bss,$(bytes_of 1 "$out/firmware.elf"),$((other - arena - stack)),\
$arena,$(value peak),$stack,$(value worst),$(value painted),\
$(echo "$text" | sed -n 's/^instructions_per_ray //p'),$hash" >>"$table"
done

text=$(FIRMWARE=$out sh "board/$board/run.sh" "$scene" size=16x12 arena=1000 2>&1)
verdict "an arena that is too small: both sizes are said" "$(
    echo "$text" | grep -q '^error: .*need_bytes=[1-9][0-9]* arena_bytes=1000$' || echo "$text")"
head -c 16777216 /dev/zero >"$folder/large.plt"
text=$(FIRMWARE=$out sh "board/$board/run.sh" "$folder/large.plt" size=16x12 2>&1)
verdict "a scene that is too large: both sizes are said" "$(
    echo "$text" |
        grep -q '^error: the scene has 16777216 bytes, and this board has room for [1-9]' ||
        echo "$text")"
text=$(SOURCE=file FIRMWARE=$out sh "board/$board/run.sh" "$scene" size=16x12 2>&1)
verdict "a file whose name has a blank and a comma is opened by semihosting" "$(
    echo "$text" | grep -q '^scene triangles=600 ' || echo "$text" | grep -q need_bytes ||
        echo "$text")"
rm -f "$folder/large.plt"
awk -F, '{ printf "    %-17s %7s %8s %7s %7s %6s %6s %8s  %s\n", $1, $2, $5, $7, $8, $10, $11,
    $12, $13 }' "$table"
finish
