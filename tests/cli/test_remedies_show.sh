#!/bin/sh
# test_remedies_show.sh - what messages about pictures, films and their flags advise, helps
#
# On the emulated panel of make demo-hid. Messages about displays that come and go are tried
# by tests/host_tools/test_hid_remedies.c. SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/remedies.sh
. tests/fuzz/seeds.sh
out=${OUT:-$BUILD/host}
trouble=$($MAKE -s "$out/planelet-hid-emulated" 2>&1 >/dev/null)
verdict "the emulated panel builds" "$trouble"
PROGRAM=$(absolute "$out/planelet-hid-emulated")
begin remedies_show
run make ground -o ground.ply
run pack ground.ply -o ground.plt
run render ground.plt -o good.png --size 16x16
run render ground.plt -o good.ppm --size 16x16
run render ground.plt -o good.y4m --size 16x16 --orbit 3

# ---- flags: host_tools/hid/cmd_show.c, sources/frames_scene.c --------------------------------

says "--driver: there is none called '%s', planelet-hid list shows them" \
    show good.png --driver plan
cured list
verdict "... the list shows the driver that was meant" "$(grep -q '^  planelet ' out || cat out)"
cured show good.png --driver planelet
says "its panel has no gaps; leave out --gaps" show good.png --gaps
cured show good.png
for flag in --hold --wait; do
    says "%s takes seconds, 0 or more" show good.png $flag -1
    cured show good.png $flag 0
done
says "--turn takes seconds, 0 or more" show ground.plt --frames 1 --turn -1
cured show ground.plt --frames 1 --turn 0
for flags in '--near 2' '--every'; do
    # shellcheck disable=SC2086
    says "--fps goes with --near auto and without --every" show good.png --fps 10 $flags
    cured show good.png --fps 10 --near auto
done
look='--eye 0,9,20 --look 0,0,0'
# shellcheck disable=SC2086
{
    says "up runs along the view; change --eye, --look or --up" \
        show ground.plt --frames 1 $look --up 0,9,20
    cured show ground.plt --frames 1 $look --up 0,1,0
    for remedy in '--eye 1e11,0,1e11' '--eye 1e12,0,1e12 --look 9e11,0,9e11'; do
        says "the camera leaves the range of 2^40; change --eye or --look" \
            show ground.plt --frames 1000 --turn 1 --eye 1e12,0,1e12
        cured show ground.plt --frames 30 --turn 1 $remedy
    done
}

# ---- any file: sources/frames_open.c, frames.c ------------------------------------------------

says "cannot open: %s; check the path" show god.png
cured show good.png
: >empty.png
mkdir folder
for wrong in empty.png folder; do
    says "is empty or no file; name a picture, a film or a scene" show $wrong
    for right in good.png good.y4m 'ground.plt --frames 1'; do
        # shellcheck disable=SC2086
        cured show $right
    done
done
says "is no Y4M, PPM, PGM, PNG or packed scene; convert it to one of them" show ground.ply
run pack ground.ply -o converted.plt
cured show converted.plt --frames 1
says_by "a scene is a file; name it" sh -c "\"$PROGRAM\" show - --frames 1 <ground.plt"
cured show ground.plt --frames 1

# ---- PNG: host_tools/picture/png_read.c --------------------------------------------------------

# damaged FILE BYTE OCTAL: bad.png, FILE with other bytes from BYTE on.
damaged() {
    { head -c "$2" "$1"; bytes part "$3"; cat part; tail -c +$(($2 + 1 + $(wc -c <part))) "$1"; } \
        >bad.png
}
# patched FILE BYTE OCTAL: likewise, with the CRC of the first chunk, IHDR, which BYTE is of.
patched() {
    damaged "$@"
    mv bad.png part.png
    {
        head -c 29 part.png
        head -c 29 part.png | tail -c 17 | crc_of
        tail -c +34 part.png
    } >bad.png
}
rows='\3abcdabcdabcd\4abcdabcdabcd\0abcdabcdabcd'
picture 2 "$rows" >eight.png
for wrong in '24 \020' '28 \001' '25 \001'; do # bits per channel, interlaced, a colour type
    # shellcheck disable=SC2086
    patched eight.png $wrong
    says "only PNG of 8 bits, not interlaced, is read; convert it" show bad.png
    cured show eight.png
done
# The head begins at 8, its width at 16 and its CRC at 29; a palette at 33, samples behind that.
for wrong in '16 \0\0\0\5 IHDR 8' '32 \0 IHDR 8' '42 \1 PLTE 33' '66 \1 IDAT 54'; do
    # shellcheck disable=SC2086
    set -- $wrong
    damaged eight.png "$1" "$2"
    says "its chunk %s at byte %zu is damaged (CRC); write it again" show bad.png
    verdict "... $3 at byte $4 is named" "$(grep -q "chunk $3 at byte $4 is" err || cat err)"
    cured show eight.png
done
patched eight.png 16 '\0\0\200\001'
says "%u x %u pixels are too many; make it smaller" show bad.png
patched eight.png 16 '\0\0\0\4'
cured show bad.png
# Of four samples each, with the filter bytes they are more than 2^32 bytes.
patched eight.png 16 '\0\0\200\0\0\0\200\0\10\6'
says "%u x %u pixels are too many; make it smaller" show bad.png
patched eight.png 16 '\0\0\0\4'
cured show bad.png
head -c 60 eight.png >bad.png
says "holds no picture; write it again" show bad.png
picture 2 "$rows" >bad.png
cured show bad.png
picture 2 '\3abcd' >bad.png
says "is damaged or ends too early; write it again" show bad.png
picture 2 "$rows" >bad.png
cured show bad.png
# Of so many pixels that they take 3 GiB: a short file asks for no more than it may hold.
patched eight.png 16 '\0\0\200\0\0\0\200\0'
says_by "is damaged or ends too early; write it again" limited v 2000000 "$PROGRAM" show bad.png
cured show eight.png
{ printf '\211'; cat good.ppm; } >bad.png
says "is no PNG picture; convert it to one" show bad.png
cured show good.png
{ printf '\211PNG\r\n\032\n'; head -c 268435456 /dev/zero; } >bad.png
says "is too large for a picture; make it smaller" show bad.png
rm bad.png
cured show good.png
run render ground.plt -o large.png --size 3000x3000
grown "$PROGRAM" show large.png
smaller "too large for memory; make it smaller" show good.png

# ---- PPM, PGM, Y4M -------------------------------------------------------------------------------

printf 'P6 2 1 65535\n\0\0\0\0\0\0\0\0\0\0\0\0' >bad.ppm
says "is no P6 or P5 picture of 8 bits; convert it to one" show bad.ppm
printf 'P5 2 1 255\n\0\0' >bad.ppm
cured show bad.ppm
head -c 100 good.ppm >bad.ppm
says "ends before its last pixel; write it again" show bad.ppm
cp good.ppm bad.ppm
cured show bad.ppm

# film HEADER: a frame of 4 x 2 pixels in C444 behind it, in bad.y4m.
film() {
    { echo "YUV4MPEG2 $1"; echo FRAME; head -c 24 /dev/zero; } >bad.y4m
}
right='W4 H2 F25:1 C444'
# becomes HEADER: the remedy for the header.
becomes() {
    film "$1"
    cured show bad.y4m
}
film 'W40000 H2 F25:1 C444'
says "%s: a side of its frames is 1 to %u pixels; make it smaller" show bad.y4m
becomes "$right"
film 'W4 H2 F1:61 C444'
says "%s: a frame every %.0f seconds; make it one in %d at least" show bad.y4m
becomes 'W4 H2 F1:60 C444'
film 'W4 H2 F25:1 C444p10'
says "colour sampling %s is not known; use C444 or C420, 8 bits" show bad.y4m
becomes "$right"
{ echo 'YUV4MPEG2 W4 H2 F25:1 C420'; echo FRAME; head -c 12 /dev/zero; } >bad.y4m
cured show bad.y4m
film 'F25:1 C444'
says "its frames are %u x %u pixels; write W and H from 1 to %u" show bad.y4m
becomes "$right"
echo 'YUV4MPEG W4' >bad.y4m
says "has no Y4M header; make it with planelet render or ffmpeg" show bad.y4m
run render ground.plt -o bad.y4m --size 16x16 --orbit 3
cured show bad.y4m
head -c 100 good.y4m >bad.y4m
says "ends inside a frame; write the film again" show bad.y4m
cp good.y4m bad.y4m
cured show bad.y4m
film 'W32768 H32768 F25:1 C444'
says_by "its frames are too large for memory; make them smaller" \
    limited v 2000000 "$PROGRAM" show bad.y4m
film "$right"
cured_by limited v 2000000 "$PROGRAM" show bad.y4m
finish
