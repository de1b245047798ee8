#!/bin/sh
# test_panel.sh - what a board's own display shows is the host's frame, in its greys
#
# Of every board that has one. The emulator's picture of the display is compared, byte by byte,
# with one that is made here of the host's frame: luma, dither and place by another way, in floating
# point and by the recursion of Bayer's matrix. Displays of 128x64 in 16 greys, four times as large
# in the picture. SPDX-License-Identifier: MIT
. tests/check/report.sh
export BUILD
planelet=$BUILD/host/planelet
folder=$BUILD/panel
scene=$folder/knot.plt
mkdir -p "$folder"
"$planelet" make knot --triangles 600 -o "$folder/knot.ply" >/dev/null &&
    "$planelet" pack "$folder/knot.ply" -o "$scene" >/dev/null ||
    verdict "the scene is made" "planelet failed"

# expected WIDTH HEIGHT < HOST.ppm: the picture's pixels, "R G B" a line.
expected() {
    tail -c $((3 * $1 * $2)) | od -An -v -tu1 -w3 | awk -v width="$1" -v height="$2" '
        function matrix(x, y, side,    half) {
            if (side == 1) { return 0 }
            half = side / 2
            return 4 * matrix(x % half, y % half, half) + corner[int(y / half), int(x / half)]
        }
        BEGIN {
            corner[0, 0] = 0; corner[0, 1] = 2; corner[1, 0] = 3; corner[1, 1] = 1
            for (y = 0; y < 8; y++) for (x = 0; x < 8; x++) {
                above[y, x] = (matrix(x, y, 8) + 0.5) / 64
            }
            left = int((128 - width) / 4) * 2
            top = int((64 - height) / 2)
        }
        {
            x = (NR - 1) % width; y = int((NR - 1) / width)
            luma = int(($1 * 77 + $2 * 150 + $3 * 29) / 256 + 0.5)
            grey[top + y, left + x] = int(luma / 17 + above[y % 8, x % 8])
        }
        END {
            for (y = 0; y < 256; y++) for (x = 0; x < 512; x++) {
                value = 17 * grey[int(y / 4), int(x / 4)]
                print value, value, value
            }
        }'
}

# shows SENTENCE SIZE
shows() {
    rm -f "$folder/panel.ppm"
    text=$(PANEL=$folder/panel.ppm FIRMWARE=$out \
        sh board/tools/run_like_host.sh "$board" "$scene" "$2" 2>&1)
    status=$?
    expected "${2%x*}" "${2#*x}" <"$out/host.ppm" >"$folder/expected.txt"
    tail -c 393216 "$folder/panel.ppm" | od -An -v -tu1 -w3 |
        awk '{ print $1, $2, $3 }' >"$folder/panel.txt"
    greys=$(sort -u "$folder/panel.txt" | wc -l)
    verdict "$board: $1: $greys greys" "$(
        [ "$status" -eq 0 ] || echo "status $status: $text"
        [ "$(head -c 15 "$folder/panel.ppm" | tr '\n' ' ')" = "P6 512 256 255 " ] ||
            echo "the picture has another size"
        [ "$greys" -gt 8 ] || echo "$greys greys are no picture"
        cmp "$folder/panel.txt" "$folder/expected.txt")"
}

count=0
for board in $(boards); do
    grep -q 'PLT_BOARD_PANEL=1' "board/$board/board.mk" || continue
    count=$((count + 1))
    out=$BUILD/$board
    make_board "$board" || continue
    shows "a frame as large as the display is on it, dithered" 128x64
    shows "one of odd size is in the middle" 77x53
    text=$(PANEL=$folder/none.ppm FIRMWARE=$out \
        sh "board/$board/run.sh" "$scene" size=129x64 2>&1)
    status=$?
    verdict "$board: a frame that does not fit its display is refused with both sizes" "$(
        [ "$status" -eq 1 ] && [ ! -e "$folder/none.ppm" ] || echo "status $status: $text"
        echo "$text" |
            grep -q "^error: the frame has 129x64 pixels, and this board's panel 128x64\$" ||
            echo "$text")"
done
verdict "$count boards have a display" "$([ "$count" -gt 0 ] || echo "none has")"
board=$(for board in $(boards); do
    grep -q 'PLT_BOARD_PANEL=1' "board/$board/board.mk" || echo "$board"
done | head -n 1)
out=$BUILD/$board
make_board "$board"
text=$(PANEL=$folder/none.ppm FIRMWARE=$out sh "board/$board/run.sh" "$scene" size=16x12 2>&1)
verdict "$board, which has none, says so" "$(
    echo "$text" | grep -q '^error: this board has no panel' || echo "$text")"
finish
