#!/bin/sh
# boards.sh SCENES - what a ray takes on every board: bunny and toasters, 320x240, eye light
#
# Compact blocks, which every board that has room for anything has room for: mapped where the image
# fits the board's memory for scenes, else streamed from a file of the debugger's host. ON names
# some of them. A row of build/rays.csv for each, whose frames are the host's bit for bit, or why
# there is none; and how these differ from tests/golden/rays.csv: above it by 1 %, and at another
# place than there, is an error. SPDX-License-Identifier: MIT
. tests/check/report.sh
export BUILD
scenes=$1 size=${SIZE:-320x240}
planelet=$BUILD/host/planelet
folder=$BUILD/board-figures
mkdir -p "$folder"

value() { # NAME: of the last NAME=value in the text
    echo "$text" | tr ' ' '\n' | sed -n "s/^$1=//p" | tail -n 1
}
room() { # bytes for a scene in the board's memory
    "$(cross_of "$board")nm" "$out/firmware.elf" | awk '
        function number(digits,    i, sum) {
            for (i = 1; i <= length(digits); i++) {
                sum = 16 * sum + index("0123456789abcdef", substr(digits, i, 1)) - 1
            }
            return sum
        }
        $3 == "plt_scene_start" { from = number($1) }
        $3 == "plt_scene_end" { to = number($1) }
        END { print to - from }'
}
build() { # PARTS: of the board, into $out
    names=$(echo "$1" | tr ' ' '\n' | sort | tr '\n' '-')
    out=$BUILD/$board-${names%-}
    make_board "$board" PARTS="$1" >&2
}
# row HOW [key=value ...]: three cells: how, the arena that was used, instructions per ray.
row() {
    how=$1
    shift
    text=$(FIRMWARE=$out sh board/tools/run_like_host.sh "$board" "$image" "$size" "$@" 2>&1)
    if echo "$text" | grep -q '^the host renders the same frame'; then
        echo "$how,$(value peak),$(echo "$text" | sed -n 's/^instructions_per_ray //p')"
    elif [ -n "$(value need_bytes)" ]; then
        echo "$how: does not fit,$(value need_bytes),"
    else
        echo "$how: $(echo "$text" | grep -m 1 'error: ' | tr , ';'),,"
    fi
}
figures() { # SCENE: those cells of a board
    image=$folder/$1.plt
    if [ "$(wc -c <"$image")" -le "$most" ]; then
        row mapped
    elif build 'render compact frames stream'; then
        SOURCE=file row streamed residency=streamed
    else
        echo "not built,,"
    fi
}

for scene in bunny toasters; do
    "$planelet" pack "$scenes/$scene.ply" --nodes compact --geometry lattice:12 \
        -o "$folder/$scene.plt" >"$folder/$scene.txt" 2>&1 || {
        cat "$folder/$scene.txt" >&2
        exit 1
    }
    echo "$scene: $(wc -c <"$folder/$scene.plt") bytes"
done
table=$BUILD/rays.csv
echo "board,bunny,bunny_arena,bunny_per_ray,toasters,toasters_arena,toasters_per_ray" >"$table"
for board in $(boards); do
    build 'render compact frames' || {
        echo "$board,not built,,,not built,," | tee -a "$table"
        continue
    }
    most=$(room)
    echo "$board,$(figures bunny),$(figures toasters)" | tee -a "$table"
done
wrong=$(grep -E 'error: |not built' "$table")
[ "$size" = 320x240 ] || { [ -z "$wrong" ]; exit; }
compared=$(awk -f tests/boards/budget.awk tests/golden/rays.csv "$table" ||
    echo "error: not compared")
echo "beside tests/golden/rays.csv: ${compared:-no difference}"
[ -z "$wrong" ] && ! echo "$compared" | grep -q '^error'
