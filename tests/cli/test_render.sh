#!/bin/sh
# test_render.sh - planelet render: formats, camera, hash, films, pictures in text
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin render
quad quad.ply
run pack quad.ply -o quad.plt
run make knot --triangles 2000 -o knot.ply
run pack knot.ply -o knot.plt

# text FROM COUNT FILE: those bytes, unprintable ones as octal numbers.
text() {
    dd if="$3" bs=1 skip="$1" count="$2" 2>/dev/null | od -An -v -c | tr -d ' \n'
}

# unsigned FROM COUNT FILE: those bytes as numbers.
unsigned() {
    dd if="$3" bs=1 skip="$1" count="$2" 2>/dev/null | od -An -v -t u1 | tr -s ' \n' ' ' |
        sed 's/^ //; s/ $//'
}

# pixels FILE: "x y r g b" lines of a PPM of planelet.
pixels() {
    width=$(sed -n 's/^\([0-9]*\) [0-9]*$/\1/p' "$1" | head -n 1)
    header=$(head -n 3 "$1" | wc -c)
    tail -c "+$((header + 1))" "$1" | od -An -v -t u1 | tr -s ' \n' '\n' | grep . | paste - - - |
        awk -v w="$width" '{ print (NR - 1) % w, int((NR - 1) / w), $1, $2, $3 }'
}

# ---- formats -----------------------------------------------------------------

works "a PPM" render knot.plt -o knot.ppm --size 40x30
verdict "... has its header and 3 bytes per pixel" "$(
    [ "$(head -n 3 knot.ppm | tr '\n' ' ')" = "P6 40 30 255 " ] || head -n 3 knot.ppm
    [ "$(wc -c <knot.ppm)" -eq $((13 + 3600)) ] || wc -c <knot.ppm)"
run render knot.plt -o - --size 40x30
same out knot.ppm "... the same on standard output"
works "a PNG" render knot.plt -o knot.png --size 40x30
verdict "... has its signature, its size, 8-bit RGB and its end" "$(
    [ "$(unsigned 0 8 knot.png)" = "137 80 78 71 13 10 26 10" ] || unsigned 0 8 knot.png
    [ "$(text 12 4 knot.png)" = IHDR ] || text 12 4 knot.png
    [ "$(unsigned 16 10 knot.png)" = "0 0 0 40 0 0 0 30 8 2" ] || unsigned 16 10 knot.png
    [ "$(text $(($(wc -c <knot.png) - 8)) 4 knot.png)" = IEND ] || echo "no IEND")"
works "a film" render knot.plt -o knot.y4m --size 40x30 --orbit 5
verdict "... has its header and 5 frames" "$(
    head -n 1 knot.y4m | grep -q '^YUV4MPEG2 W40 H30 F25:1 .*C420jpeg' || head -n 1 knot.y4m
    [ "$(wc -c <knot.y4m)" -eq $(($(head -n 1 knot.y4m | wc -c) + 5 * (6 + 1800))) ] ||
        wc -c <knot.y4m)"
run render knot.plt -o - --size 40x30 --orbit 5
same out knot.y4m "... the same on standard output"
run render knot.plt -o round.y4m --size 40x30 --orbit 5 --view box
run render knot.plt -o one.y4m --size 40x30 --view box
verdict "... its first frame is the picture, the others differ" "$(
    start=$(head -n 1 one.y4m | wc -c)
    cmp -n "$(wc -c <one.y4m)" one.y4m round.y4m
    i=0
    while [ $i -lt 5 ]; do
        tail -c +$((start + 1 + i * 1806)) knot.y4m | head -c 1806 | cksum
        i=$((i + 1))
    done | sort | uniq -d)"
for side in front back left right side top bottom iso 30,-20 box usual; do
    works "--view $side" render knot.plt -o "view.$side.ppm" --size 40x30 --view $side
done
same view.usual.ppm knot.ppm "usual is what is rendered without --view"
same view.side.ppm view.right.ppm "side is right"
rm view.side.ppm view.bottom.ppm # half a turn brings a knot's bottom to its top
verdict "all other views are different" "$(cksum view.*.ppm | cut -d " " -f 1 | sort | uniq -d)"
works "--background is a colour" render knot.plt -o red.ppm --size 40x30 --background fF8000
verdict "... of every pixel that no triangle has" "$(
    tail -c 3600 red.ppm | od -An -v -tu1 -w3 | sed -n '1p;40p;1161p;$p' | tr -s ' ' | sort -u |
        grep -vx ' 255 128 0'
    cmp -s red.ppm knot.ppm && echo "it is the sky")"
run render knot.plt -o black.ppm --size 40x30 --background 000000
verdict "... which may be black" "$(
    [ "$(tail -c 3600 black.ppm | head -c 3 | od -An -tu1 | tr -d ' ')" = 000 ] ||
        echo "not black")"
run render knot.plt -o sky.ppm --size 40x30 --background sky
same sky.ppm knot.ppm "... and sky is the sky"
works "a film with --chroma 444" render knot.plt -o full.y4m --size 41x31 --orbit 2 --chroma 444 \
    --json full.json
verdict "... has its header and 2 frames of 3 bytes per pixel" "$(
    head -n 1 full.y4m | grep -q '^YUV4MPEG2 W41 H31 F25:1 .*C444' || head -n 1 full.y4m
    [ "$(wc -c <full.y4m)" -eq $(($(head -n 1 full.y4m | wc -c) + 2 * (6 + 3 * 41 * 31))) ] ||
        wc -c <full.y4m)"
works "... and the same with 420" render knot.plt -o half.y4m --size 41x31 --orbit 2 --chroma 420 \
    --json half.json
verdict "... has chroma of 21 x 16 samples, and the same frame hash, which is of RGB" "$(
    [ "$(wc -c <half.y4m)" -eq $(($(head -n 1 half.y4m | wc -c) + 2 * (6 + 41 * 31 + 2 * 336))) ] ||
        wc -c <half.y4m
    grep frame_hash full.json >full.hash
    grep frame_hash half.json | cmp full.hash - 2>&1)"
works "the default is 512 x 512" render quad.plt -o default.ppm
verdict "... says its header" "$(
    [ "$(sed -n 2p default.ppm)" = "512 512" ] || head -n 3 default.ppm)"
works "an ending may be in capitals" render quad.plt -o QUAD.PNG --size 8x8
works "one pixel" render quad.plt -o pixel.ppm --size 1x1
works "a line of pixels" render quad.plt -o line.ppm --size 300x1
verdict "... of its length" "$([ "$(wc -c <line.ppm)" -eq $((13 + 900)) ] || wc -c <line.ppm)"

# ---- the camera --------------------------------------------------------------

# At 90 degrees from a distance of 1 the square covers half of each side.
works "a camera" render quad.plt -o camera.ppm --size 8x8 --shader triangle --fov 90 \
    --eye 0.5,0.5,1 --look 0.5,0.5,0
verdict "... 90 degrees see the square in 4 x 4 of 8 x 8 pixels, the right ones" "$(
    pixels camera.ppm | awk '
        { colour = $3 " " $4 " " $5 }
        $1 == 0 { sky = colour }
        (colour != sky) != ($1 >= 2 && $1 <= 5 && $2 >= 2 && $2 <= 5) { print "pixel " $0 }
        END { if (NR != 64) print NR " pixels" }')"
verdict "... y is up and x to the right: number 1 above the diagonal, 0 below" "$(
    pixels camera.ppm | awk '
        $1 >= 2 && $1 <= 5 && $2 >= 2 && $2 <= 5 {
            number = $1 - 2 >= 5 - $2 ? 0 : 1 # on the diagonal the lower one
            hue = int(10 * $4 / $3 + 0.5)     # the colour without its light
            if (hues[number] == "") hues[number] = hue
            if (hues[number] != hue) print "pixel " $0
        }
        END { if (hues[0] == hues[1]) print "both triangles have one colour" }')"
works "up may be another" render quad.plt -o turned.ppm --size 8x8 --shader triangle --fov 90 \
    --eye 0.5,0.5,1 --look 0.5,0.5,0 --up 0,-1,0
verdict "... and then the picture stands on its head" "$(
    pixels turned.ppm | awk '$1 >= 2 && $1 <= 5 && $2 >= 2 && $2 <= 5 {
        print 7 - $1, 7 - $2, $3, $4, $5 }' | sort >turned
    pixels camera.ppm | awk '$1 >= 2 && $1 <= 5 && $2 >= 2 && $2 <= 5' | sort | diff - turned
    [ "$(wc -l <turned)" -eq 16 ] || wc -l <turned)"
verdict "the default camera sees all of the scene, with sky on every side" "$(
    for up in 0,1,0 0,0,1 1,0,0 0,-1,0 1,2,3; do
        for size in 64x64 96x32 32x96; do
            run render knot.plt -o seen.ppm --size $size --up $up
            cat err
            pixels seen.ppm | awk -v what="$up at $size" -v w="${size%x*}" -v h="${size#*x}" '
                { colour[$1 " " $2] = $3 " " $4 " " $5; if ($1 == 0) sky[$2] = $3 " " $4 " " $5 }
                END {
                    for (y = 0; y < h; y++)
                        for (x = 0; x < w; x++)
                            if (colour[x " " y] != sky[y]) {
                                seen++
                                if (x == w - 1 || y == 0 || y == h - 1) touched++
                            }
                    if (touched) print what ": " touched " pixels at the border"
                    if (seen < 0.04 * w * h) print what ": only " seen + 0 " pixels"
                }'
        done
    done)"
works "a look alone turns the default camera" render knot.plt -o look.ppm --size 32x32 --look 1,0,0
works "an eye alone looks at the middle" render knot.plt -o eye.ppm --size 33x33 --eye 0,30,1
refused "eye and look at one point" camera "change --eye" \
    render knot.plt -o x.png --eye 1,1,1 --look 1,1,1
refused "up along the view" camera "up" render knot.plt -o x.png --eye 0,5,0 --look 0,0,0
refused "up without direction" camera "up" render knot.plt -o x.png --up 0,0,0
misused "an eye beyond all scenes is out of the range of --eye" "--eye takes" \
    render knot.plt -o x.png --eye 1e30,0,0
verdict "... and none left a picture" "$(ls x.png 2>/dev/null; left_behind)"
verdict "every shader gives another picture" "$(
    for shader in eyelight normal triangle; do
        run render knot.plt -o $shader.ppm --size 32x32 --shader $shader
        cat err
    done
    run render knot.plt -o default.ppm --size 32x32
    cmp default.ppm eyelight.ppm
    differ eyelight.ppm normal.ppm
    differ normal.ppm triangle.ppm
    differ triangle.ppm eyelight.ppm)"

# ---- statistics and the hash -------------------------------------------------

fields='width height frames rays seconds mrays_per_s packet_side packets mixed_packets node_visits
    group_tests triangle_tests treelet_fetches bytes_fetched bytes_touched_once arena_bytes
    arena_peak_bytes'
hash_of() {
    sed -n 's/^  "frame_hash": "\([0-9a-f]*\)",$/\1/p' "$1"
}
works "render --json FILE" render knot.plt -o small.ppm --size 16x12 --json stats.json
# shellcheck disable=SC2086
verdict "... holds every value" "$(flat_json stats.json $fields)"
verdict "... one ray per pixel, and the camera's floats as bits" "$(
    [ "$(number rays <stats.json)" = 192 ] || grep rays stats.json
    [ "$(number width <stats.json) $(number height <stats.json)" = "16 12" ] || cat stats.json
    [ "$(grep -c '^  "\(eye\|look\|up\)": "0x[0-9a-f]\{8\},0x[0-9a-f]\{8\},0x[0-9a-f]\{8\}",$' \
        stats.json)" -eq 3 ] || cat stats.json
    grep -q '^  "up": "0x00000000,0x3f800000,0x00000000",$' stats.json || grep '"up"' stats.json
    grep -q '^  "tan": "0x3ed413cd",$' stats.json || grep '"tan"' stats.json)"
# 64-bit FNV-1a in limbs of 16 bits: hash * (2^40 + 0x1b3).
verdict "... and the 64-bit FNV-1a of the picture's bytes" "$(
    tail -c +14 small.ppm | od -An -v -t u1 | awk '
        function exclusive(a, b,    r, bit) {
            for (bit = 1; bit < 65536; bit *= 2) {
                if (int(a / bit) % 2 != int(b / bit) % 2) r += bit
            }
            return r
        }
        BEGIN { h0 = 8997; h1 = 33826; h2 = 40164; h3 = 52210 }
        {
            for (i = 1; i <= NF; i++) {
                h0 = exclusive(h0, $i)
                c0 = h0 * 435
                c1 = h1 * 435 + int(c0 / 65536)
                c2 = h2 * 435 + int(c1 / 65536) + h0 * 256
                c3 = h3 * 435 + int(c2 / 65536) + h1 * 256
                h0 = c0 % 65536; h1 = c1 % 65536; h2 = c2 % 65536; h3 = c3 % 65536
            }
        }
        END { printf "%04x%04x%04x%04x\n", h3, h2, h1, h0 }' >expected
    hash_of stats.json | diff expected -)"
works "render --json - without a picture" render knot.plt --size 16x12 --json -
verdict "... the same hash" "$(hash_of out | diff expected -)"
works "a film's statistics" render knot.plt --size 16x12 --orbit 3 --json -
verdict "... count all frames" "$(
    [ "$(number rays <out) $(number frames <out)" = "576 3" ] || cat out
    hash_of out | cmp -s expected - && echo "the hash is that of one frame")"

for build in host device none; do
    for leaf in 1 4; do
        run pack knot.ply -o other.plt --build $build --leaf $leaf --splits median
        for flags in "--packet 2" "--packet 4 --source read" "--packet 8 --walk two-stage" \
            "--packet 16 --walk two-stage --source read --residency resident --schedule branch \
                --workers 1"; do
            # shellcheck disable=SC2086
            run render other.plt --size 16x12 --json - $flags
            verdict "pack --build $build --leaf $leaf, render $flags: the same frame" "$(
                cat err
                hash_of out | diff expected -)"
        done
    done
done
run info knot.plt --json
need=$(number arena_bytes_needed <out)
counting=$((need + $(touched_bytes <out)))
works "render in the arena that info says" render knot.plt -o fits.ppm --size 16x12 \
    --arena "$need"
same fits.ppm small.ppm "... the same picture"
refused "statistics need a bit per treelet more" knot.plt "needs an arena of $counting bytes" \
    render knot.plt --size 16x12 --json - --packet 8 --arena "$((counting - 1))"
works "render --json in the arena for that" render knot.plt --size 16x12 --json - \
    --arena "$counting"
verdict "... the same frame, touched treelets are counted, and the arena is used up" "$(
    hash_of out | diff expected -
    [ "$(number bytes_touched_once <out)" -gt 0 ] || echo "nothing touched"
    [ "$(number arena_bytes <out) $(number arena_peak_bytes <out)" = "$counting $counting" ] ||
        cat out)"
refused "render with a byte less says the bytes" knot.plt "needs an arena of $need bytes" \
    render knot.plt -o x.png --packet 8 --arena $((need - 1))
works "... unless packets may be smaller" render knot.plt -o smaller.ppm --size 16x12 \
    --arena $((need - 1))
same smaller.ppm small.ppm "... the same picture"
for name in twice.png twice.ppm twice.y4m; do
    run render knot.plt -o $name --size 100x75
    mv $name once
    run render knot.plt -o $name --size 100x75
    same once $name "rendering $name twice gives the same bytes"
done

# ---- in the terminal -----------------------------------------------------------

works "render --show into a file" render knot.plt --show
verdict "... draws at most 80 x 23 plain characters" "$(
    awk 'length > 80 { print length " characters" } /[^ .:=+*#%@-]/ { print }
        END { if (NR > 23 || NR < 10) print NR " lines" }' out
    grep -q '[#%@*+]' out || echo "nothing to be seen")"
COLUMNS=30 LINES=12
export COLUMNS LINES
works "render --show heeds COLUMNS and LINES" render knot.plt --show
unset COLUMNS LINES
verdict "... and stays within them" "$(
    awk 'length > 30 { print length " characters" } END { if (NR > 11) print NR " lines" }' out)"
works "picture, drawing and statistics at once" \
    render knot.plt -o p.png --show --json - --size 32x32
verdict "... are all there" "$(
    [ -s p.png ] || echo "no picture"
    sed -n '/^{$/,$p' out >stats
    # shellcheck disable=SC2086
    flat_json stats $fields)"

# ---- several runs ------------------------------------------------------------

works "render --repeat" render knot.plt -o often.y4m --size 40x30 --orbit 3 --repeat 4 --json often
run render knot.plt -o once.y4m --size 40x30 --orbit 3 --json once
same often.y4m once.y4m "... gives the same film"
verdict "... and the same statistics, but for the time" "$(
    grep -v 'seconds\|mrays' once >expected
    grep -v 'seconds\|mrays' often | diff expected -)"
verdict "... whose best time is not all of them" "$(
    awk -v often="$(number seconds <often)" -v once="$(number seconds <once)" 'BEGIN {
        if (!(often > 0) || often > 3 * once) print often " s, once " once " s" }')"
finish
