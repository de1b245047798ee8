#!/bin/sh
# check_readme.sh - README's promises: its program, its picture, its length
# SPDX-License-Identifier: MIT
. tests/check/report.sh
out=$BUILD/check
mkdir -p "$out"

verdict "README has at most 200 lines" "$(
    lines=$(wc -l <README.md)
    [ "$lines" -le 200 ] || echo "$lines lines")"

trouble=$($MAKE -s demo 2>&1 >"$out/demo.txt")
verdict "make demo makes a picture and a film and says nothing wrong" "$(
    echo "$trouble" | grep .
    [ -s "$BUILD/demo/marbles.png" ] || echo "no picture"
    [ "$(head -c 9 "$BUILD/demo/knot.y4m")" = YUV4MPEG2 ] || echo "no film")"
verdict "README's picture is the one that make demo makes" "$(
    cmp tests/golden/marbles.png "$BUILD/demo/marbles.png" 2>&1)"
verdict "... and has the hash that pictures.txt has" "$(
    hash=$(sed -n 's/.*"frame_hash": "\([^"]*\)".*/\1/p' "$BUILD/demo/marbles.json")
    grep -q "^marbles.png 640 320 $hash\$" tests/golden/pictures.txt ||
        echo "it has ${hash:-none}")"
verdict "README shows the pictures whose hashes pictures.txt has, and no others" "$(
    sed -n 's/^!\[..*\](tests\/golden\/\(.*\))$/\1/p' README.md | sort >"$out/shown.txt"
    sed -n 's/^\([a-z]*\.png\) .*/\1/p' tests/golden/pictures.txt | sort | diff - "$out/shown.txt")"
verdict "make demo draws the picture in the terminal" "$(
    [ "$(grep -c '[-=+*#]\{4\}' "$out/demo.txt")" -ge 5 ] || cat "$out/demo.txt")"

awk '/^```c$/ { on = 1; next } /^```$/ { on = 0 } on' README.md >"$out/first.c"
verdict "README's program compiles without a warning" "$(
    $CC -std=c11 -Wall -Wextra -I. "$out/first.c" "$BUILD/host/libplanelet.a" -o "$out/first" 2>&1)"
"$out/first" >"$out/first.txt" 2>&1
status=$?
verdict "README's program traces a ray and renders a frame" "$(
    [ "$status" -eq 0 ] || echo "status $status"
    [ "$(head -n 1 "$out/first.txt" | grep -c '^triangle [0-9]* at distance')" -eq 1 ] ||
        head -n 1 "$out/first.txt"
    [ "$(grep -c '^tile of 16 x 16' "$out/first.txt")" -eq 12 ] || cat "$out/first.txt")"
verdict "make help says every target in a sentence" "$(
    $MAKE -s help >"$out/help.txt"
    for target in all demo setup test check sizes bench scenes peers clean; do
        grep -q "^$target: ..* ..*" "$out/help.txt" || echo "not a word about $target"
    done)"
finish
