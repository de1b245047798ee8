#!/bin/sh
# jpeg.sh [FOLDER] - JPEG files of ours before other decoders, and beside another encoder's
#
# All sizes from 1x1 to 64x64 in every sampling go through djpeg and ImageMagick, which may not say
# a word; a picture's files are compared in size with cjpeg's of the same tables, and may not be
# larger by more than 10 %. A key's picture is encoded here, under valgrind, and on a Cortex-M4F in
# QEMU: the files must be the same, and the instructions per pixel are printed.
# Debian packages: libjpeg-turbo-progs, netpbm, imagemagick, valgrind. Exit status 2 when djpeg is
# not there; without another its part is left out, and it says so. Set SIDE for other sizes.
# SPDX-License-Identifier: MIT
set -u
program=${PROGRAM:-build/host/tests/measure/test_jpeg_files}
folder=${1:-${BUILD:-build}/jpeg}
side=${SIDE:-64} picture=tests/golden/marbles.png

if ! command -v djpeg >/dev/null 2>&1; then
    echo "jpeg.sh: there is no djpeg; install it (apt-get install libjpeg-turbo-progs)" >&2
    exit 2
fi
rm -rf "$folder/sizes"
mkdir -p "$folder/sizes"
"$program" "$folder/sizes" "$side" || exit 1
wrong=0 count=0
for file in "$folder"/sizes/*.jpg; do
    said=$(djpeg -outfile /dev/null "$file" 2>&1)
    count=$((count + 1))
    [ -z "$said" ] || { wrong=$((wrong + 1)); echo "$file: $said"; }
done
magick=
if identify -version 2>/dev/null | grep -q ImageMagick; then
    magick=" and ImageMagick"
    said=$(find "$folder/sizes" -name '*.jpg' -print0 |
        xargs -0 -n 200 identify -regard-warnings -format '' 2>&1)
    [ -z "$said" ] || { wrong=$((wrong + 1)); printf '%s\n' "$said"; }
fi
echo "$count files read by djpeg$magick, $wrong with a word said"
[ -n "$magick" ] || echo "(without ImageMagick: it is not installed)"

# ---- cost ----------------------------------------------------------------------------------

board=mps2_an386 pixels=$((120 * 120))
${MAKE:-make} -s BOARD=$board PROGRAM=jpeg BUILD="${BUILD:-build}" >/dev/null || exit 1
for sampling in 0 1 2; do
    name=$(echo '444 422 420' | cut -d ' ' -f $((sampling + 1)))
    there=$(BUILD=${BUILD:-build} FIRMWARE=${BUILD:-build}/$board-jpeg sh board/$board/run.sh \
        "" $sampling) || exit 1
    here=$("$program" $sampling)
    same=$(printf '%s\n%s\n' "$here" "$there" | grep '^hash' | uniq | wc -l)
    [ "$same" -eq 1 ] || { wrong=$((wrong + 1)); echo "$name: the board's file is another"; }
    count=$(printf '%s\n' "$there" | sed -n 's/^instructions .* render=\([0-9]*\) .*/\1/p')
    line="    $name: $((count / pixels)) instructions per pixel on a Cortex-M4F"
    if command -v valgrind >/dev/null 2>&1; then
        count=$(valgrind --tool=callgrind --toggle-collect=jpeg_write \
            --callgrind-out-file=/dev/null "$program" $sampling 2>&1 |
            sed -n 's/.*Collected : \([0-9]*\).*/\1/p')
        line="$line, $((count / pixels)) here"
    fi
    echo "$line, the same file"
done
command -v valgrind >/dev/null 2>&1 || echo "(without instructions here: valgrind is not installed)"

# ---- size ----------------------------------------------------------------------------------

"$program" "$picture" 20 >"$folder/ours" || exit 1
cat "$folder/ours"
if ! pngtopnm "$picture" >"$folder/picture.ppm" 2>/dev/null; then
    echo "(without cjpeg's sizes: pngtopnm, of netpbm, is not installed)"
    exit $((wrong > 0))
fi
for sampling in 444:1x1 422:2x1 420:2x2; do
    for quality in 50 75 90; do
        cjpeg -quality $quality -sample "${sampling#*:}" -baseline "$folder/picture.ppm" \
            >"$folder/theirs.jpg" || exit 1
        theirs=$(wc -c <"$folder/theirs.jpg")
        ours=$(sed -n "s/^ *${sampling%:*} quality $quality: \([0-9]*\) bytes.*/\1/p" \
            "$folder/ours")
        echo "$sampling $quality $ours $theirs" | awk '{
            printf "    %s quality %s: %d bytes, cjpeg %d, %+.1f %%\n",
                substr($1, 1, 3), $2, $3, $4, 100 * ($3 / $4 - 1)
            exit !($3 <= 1.1 * $4) }' || wrong=$((wrong + 1))
    done
done
[ "$wrong" -eq 0 ]
