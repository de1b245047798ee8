#!/bin/sh
# test_web.sh - the page in Chromium without a window, and its program's lanes in node
#
# Beside builders: it builds in build/web and build/host/tests/web alone.
#
# Frames are those of `planelet render`, reports those that planelet-hid sends. A machine without
# node, Chromium or clang fails it; make setup installs them. SPDX-License-Identifier: MIT
. tests/check/report.sh
clang=$($MAKE -s web-compiler)
needs node chromium "$clang" || finish || exit 1

planelet=$BUILD/host/planelet
folder=$BUILD/web/scenes
mkdir -p "$folder"
trouble=$($MAKE -s web-tests 2>&1 >/dev/null) ||
    verdict "the page builds" "${trouble:-make web-tests failed}"
verdict "clang compiles the page's programs without a warning" "$(
    find "$BUILD/web/scalar" "$BUILD/web/wasm" -name '*.log' -size +0 -exec cat {} +)"

# ---- lanes -----------------------------------------------------------------

said=$(node tests/web/lanes.js "$BUILD/web/lanes.wasm" 2>&1)
status=$?
verdict "SIMD128 is the scalar reference, bit for bit: $(echo "$said" | tail -n 1)" "$(
    [ "$status" -eq 0 ] || echo "$said")"
verdict "the lanes of relaxed SIMD, and min and max that know NaNs, are not used" "$(
    grep -nE 'relaxed_|f32x4_(min|max)\(' platform/lanes_wasm.h)"

# ---- the page --------------------------------------------------------------

"$planelet" make knot --triangles 3000 -o "$folder/knot.ply" >/dev/null
"$planelet" pack "$folder/knot.ply" -o "$folder/knot.plt" >/dev/null
"$planelet" pack "$folder/knot.ply" -o "$folder/smooth.plt" --smooth 40 >/dev/null
"$planelet" make knot --triangles 600 -o "$folder/boards.ply" >/dev/null
"$planelet" pack "$folder/boards.ply" -o "$folder/boards.plt" >/dev/null
"$planelet" make knot --triangles 20000 -o "$folder/large.ply" >/dev/null
"$planelet" pack "$folder/large.ply" -o "$folder/compact.plt" --nodes compact \
    --geometry lattice:14 >/dev/null 2>&1
head -c 20000 "$folder/knot.plt" >"$folder/cut.plt"
said=$(timeout 900 node tests/web/page_test.js chromium "$BUILD/web/planelet.html" "$folder" \
    "$planelet" "$BUILD/web/panel.wasm" "$OUT/tests/web/deck_reports" 2>&1)
echo "$said" | grep -v ' passed, '
count=$(echo "$said" | sed -n 's/^\([0-9]*\) passed, \([0-9]*\) failed$/\1 \2/p')
[ -n "$count" ] || verdict "the tests of the page end" "${said:-they said nothing}"
count=${count:-0 0}
passed=$((passed + ${count% *})) failed=$((failed + ${count#* }))
finish
