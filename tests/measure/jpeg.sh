#!/bin/sh
# jpeg.sh [FOLDER] - JPEG files of ours before other decoders, and beside another encoder's
#
# All sizes from 1x1 to 64x64 in every sampling go through djpeg and ImageMagick, which may not say
# a word; a picture's files are compared in size, cost and error with cjpeg's of the same tables.
# Debian packages: libjpeg-turbo-progs, imagemagick. Exit status 2 when djpeg is not there; without
# ImageMagick its part is left out, and it says so. Set SIDE for other sizes.
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
magick=
! identify -version 2>/dev/null | grep -q ImageMagick || magick=identify
wrong=0 count=0
for file in "$folder"/sizes/*.jpg; do
    said=$(djpeg -outfile /dev/null "$file" 2>&1)
    [ -z "$magick" ] || said=$said$(identify -regard-warnings -format '' "$file" 2>&1)
    count=$((count + 1))
    [ -z "$said" ] || { wrong=$((wrong + 1)); echo "$file: $said"; }
done
echo "$count files read by djpeg${magick:+ and ImageMagick}, $wrong with a word said"
[ -n "$magick" ] || echo "(without ImageMagick: it is not installed)"

"$program" "$picture" 20 || exit 1
if ! pngtopnm "$picture" >"$folder/picture.ppm" 2>/dev/null; then
    echo "(without cjpeg's sizes: pngtopnm, of netpbm, is not installed)"
    exit $((wrong > 0))
fi
for sampling in 1x1 2x1 2x2; do
    for quality in 50 75 90; do
        cjpeg -quality $quality -sample $sampling -baseline "$folder/picture.ppm" \
            >"$folder/theirs.jpg" || exit 1
        echo "    cjpeg $sampling quality $quality: $(wc -c <"$folder/theirs.jpg") bytes"
    done
done
[ "$wrong" -eq 0 ]
