#!/bin/sh
# test_ranges.sh - every flag at both ends of the range that its help states, and beyond
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin ranges
quad quad.ply
run pack quad.ply -o quad.plt
echo '0 0 5 0 0 0 -1 100' | rays ray
echo 'quad.ply 1 0 0 0' >recipe.txt

# states COMMAND FLAG TEXT: trouble, unless the help of FLAG holds TEXT.
states() {
    "$PLANELET" "$1" --help | awk -v flag="$2" '
        /^  -/ { mine = $1 == flag }
        mine { printf "%s ", $0 }' | tr -s ' ' | grep -qF -- "$3" ||
        echo "the help of $2 does not say '$3'"
}
# range FLAG TEXT BELOW,LEAST,MOST,ABOVE COMMAND...: the help states TEXT; LEAST and MOST work,
# BELOW and ABOVE are wrong usage. "-" leaves one out; values are separated by blanks.
range() {
    flag=$1 text=$2 values=$3
    shift 3
    verdict "$1 $flag: the help states $text" "$(states "$1" "$flag" "$text")"
    # shellcheck disable=SC2086
    set -- "$@" "$flag" $values
    above=$(eval "echo \"\${$#}\"") most=$(eval "echo \"\${$(($# - 1))}\"")
    least=$(eval "echo \"\${$(($# - 2))}\"") below=$(eval "echo \"\${$(($# - 3))}\"")
    words=$(($# - 4))
    for value in "$least" "$most" "$below" "$above"; do
        [ "$value" != - ] || continue
        i=0
        for word in "$@"; do
            [ $i -gt 0 ] || set --
            i=$((i + 1))
            [ $i -gt $words ] || set -- "$@" "$word"
        done
        set -- "$@" "$value"
        if [ "$value" = "$least" ] || [ "$value" = "$most" ]; then
            works "$1 $flag $value works" "$@"
        else
            misused "$1 $flag $value is out of range" "$flag" "$@"
        fi
        # shellcheck disable=SC2086
        set -- "$@" $values
    done
}

range --smooth "0 to 180" "-1 0 180 181" pack quad.ply -o x.plt
range --triangles "2 to 10000000" "- 2 - 10000001" make terrain -o x.ply
range --triangles "24 to 10000000" "1 24 - 10000001" make knot -o x.ply
refused "make --triangles 23 is no knot" knot "24 to 10000000" make knot --triangles 23 -o x.ply
range --triangles "24000 to 10000000" "1 24000 - 10000001" make room -o x.ply
refused "make --triangles 23999 is no room" room "24000 to 10000000" \
    make room --triangles 23999 -o x.ply
range --triangles "160 to 8800" "1 160 - 10000001" make marbles -o x.ply
for count in 159 8801; do
    refused "make --triangles $count is no tray of marbles" "tray of marbles" "160 to 8800" \
        make marbles --triangles $count -o x.ply
done
range --seed "0 to 999999" "-1 0 999999 1000000" make room --triangles 24000 -o x.ply
range --frame "0 to 99999" "-1 0 - 100000" make marbles -o x.ply
range --frames "1 to 100000" "0 1 - 100001" make marbles -o 'x{}.ply'
range --frame "0 to 99999" "-1 0 99999 100000" make city -o x.ply
# Those ends are too much work: that they are taken shows a folder that is missing.
refused "make --frames 100000 is in range" missing/000.ply "create" \
    make marbles --frames 100000 -o 'missing/{}.ply'
refused "make --triangles 10000000 is in range" missing/x "create" \
    make knot --triangles 10000000 -o missing/x

range --treelet "1 to 1000000" "0 1 1000000 1000001" pack quad.ply -o x.plt
range --quality-time "1 to 86400" "0 1 86400 86401" pack quad.ply -o x.plt --quality high
range --reduce "1 to 1000000000" "0 1000000000 1000000000 1000000001" pack quad.ply -o x.plt
range --memory "1048576 to 1125899906842624" "1048575 1048576 1125899906842624 1125899906842625" \
    pack quad.ply -o x.plt
cp quad.ply quad_000.ply
echo 'quad_{}.ply*1 1 0 0 0' >turns.txt
range --frame "0 to 99999" "-1 0 99999 100000" pack turns.txt -o x.plt
range --rate "1 to 1000" "0 1 1000 1001" pack --sequence quad.ply quad.ply -o x.plt
range --key "1 to 100000" "0 1 100000 100001" pack --sequence quad.ply quad.ply -o x.plt
for frames in 0:1 99999:100000; do
    works "pack --frames $frames works" pack --sequence recipe.txt --frames $frames -o x.plt
done
for frames in 99999:100001 -1:1 1:1; do
    misused "pack --frames $frames is out of range" --frames \
        pack --sequence recipe.txt --frames $frames -o x.plt
done
verdict "pack --frames: the help states its range" "$(states pack --frames "0 to 99999")"
# On compact nodes pack says what the lattice cost.
for bits in 12 21; do
    run pack quad.ply -o x.plt --nodes compact --geometry lattice:$bits
    verdict "pack --geometry lattice:$bits works" "$([ "$status" -eq 0 ] || cat err)"
done
for bits in 11 22; do
    misused "pack --geometry lattice:$bits is out of range" --geometry \
        pack quad.ply -o x.plt --nodes compact --geometry lattice:$bits
done
run make knot --triangles 500 -o knot.ply # unlike the quad, on no coarse grid
run pack knot.ply -o x.plt --nodes compact --tolerance 5.2e-7
verdict "pack --tolerance 5.2e-7 is the finest lattice" "$(grep -q 'of 21 bits' err || cat err)"
misused "pack --tolerance 5.1e-7 is out of range" --tolerance \
    pack quad.ply -o x.plt --nodes compact --tolerance 5.1e-7
verdict "pack --tolerance: the help states its range" \
    "$(states pack --tolerance "5.2e-7 and more")"
verdict "pack --geometry: the help states its range" \
    "$(states pack --geometry "12 to 21 bits")"

for command in "render quad.plt -o x.ppm" "trace quad.plt ray x.hits"; do
    # shellcheck disable=SC2086
    {
        range --workers "1 to 64" "-1 1 64 65" $command
        range --workers "0 is one per processor" "-1 0 - -" $command
        range --arena "1 to 1073741824" "0 - 1073741824 1073741825" $command
        refused "${command%% *} --arena 1 is in range, and too small" quad.plt "use --arena" \
            $command --arena 1
    }
done
range --repeat "1 to 1000000" "0 1 1000000 1000001" trace quad.plt ray x.hits
range --repeat "1 to 1000000" "0 1 1000 1000001" render quad.plt -o x.ppm --size 1x1
range --repeat "1 to 1000" "0 1 1000 1001" bench quad.plt --size 1x1 --packets 2
range --size "1 to 4096" "0x1 1x4096 4096x1 4097x1" bench quad.plt --packets 8 --repeat 1 \
    --eye 0.5,0.5,9 --look 0.5,0.5,0 --fov 0.01
misused "bench --size 1x4097 is out of range" --size bench quad.plt --size 1x4097
range --orbit "1 to 100000" "0 1 100000 100001" render quad.plt -o x.y4m --size 1x1
range --size "1 to 32768" "0x1 1x32768 32768x1 32769x1" render quad.plt -o x.png
misused "render --size 1x32769 is out of range" --size render quad.plt -o x.png --size 1x32769
for command in "render quad.plt -o x.ppm --size 16x16" \
    "serve quad.plt --emulate 600000 -o x.ppm --size 16x16"; do
    # shellcheck disable=SC2086
    {
        range --fov "0.0002 to 179.999" "0.000199 0.0002 179.999 179.9991" $command
        range --fov "0.0002 to 179.999" "1e-4 - - 180" $command
        range --view "-360 to 360" "-361,0 -360,0 360,0 361,0" $command
        range --view "-90 to 90" "0,-90.01 0,-90 0,90 0,90.01" $command
        range --eye "within 2^40" "-1.1e12,0,1 -1099511627776,0,1 0,1099511627776,1 0,1.1e12,1" \
            $command
        range --up "within 2^40" "-1.1e12,1,0 -1099511627776,1,0 1,1099511627776,0 1,1.1e12,0" \
            $command
        range --look "within 2^40" \
            "-1.1e12,0,0 -1099511627776,0,0 0,1099511627776,0 0,1.1e12,0" $command --eye 0,0,5 \
            --up 1,1,1
    }
done
range --size "512 tiles of 16x16" "0x1 16x8192 256x512 257x512" \
    serve quad.plt --emulate 600000 -o x.ppm
range --report "8 to 1024" "7 8 1024 1025" serve quad.plt --emulate 600000 -o x.ppm --size 16x16
range --orbit "1 to 100000" "0 1 - 100001" serve quad.plt --emulate 600000 -o x.y4m --size 8x8
range --timeout "up to 1000000; 0: never" "-1 0 1000000 1000001" \
    serve quad.plt --emulate 600000 -o x.ppm --size 8x8
range --emulate "1024 to 1073741824" "1023 - 1073741824 1073741825" \
    serve quad.plt -o x.ppm --size 8x8
refused "serve --emulate 1024 is in range, and too small" device "it has 1024" \
    serve quad.plt -o x.ppm --emulate 1024
range --listen "1 to 65535" "0 - - 65536" serve quad.plt -o x.ppm
run serve quad.plt -o x.ppm --listen 65535 --timeout 1
verdict "serve --listen 65535 is in range" "$(
    grep -q '^serve: waiting for a device at 127.0.0.1:65535$\|^127.0.0.1:65535: .*in use' err ||
        cat err)"

# ---- cameras that the scene, not a flag, puts out of range -----------------------------

sed '/^[01] [01] 0$/s/1/1e12/g' quad.ply >huge.ply
run pack huge.ply -o huge.plt
works "a huge scene from an --eye that is near" render huge.plt -o x.ppm --size 8x8 \
    --eye 5e11,5e11,1e12
rm -f x.ppm
refused "its default eye would be out of range, which is said" camera \
    "beyond 2^40; choose a nearer --eye" render huge.plt -o x.ppm --size 8x8
refused "... of serve too" camera "beyond 2^40; choose a nearer --eye" \
    serve huge.plt --emulate 600000 -o x.ppm --size 8x8
refused "an orbit that leaves the range is refused before the first frame" camera "its orbit" \
    render quad.plt -o x.y4m --size 8x8 --orbit 9 --eye 1e12,0,1e12
refused "eye and look at one point is just that" camera "eye and look coincide; change" \
    render quad.plt -o x.ppm --eye 1,1,1 --look 1,1,1
refused "up along the view is just that" camera "up runs along the view; change" \
    render quad.plt -o x.ppm --eye 0,5,0 --look 0,0,0
refused "up without direction is just that" camera "up has no direction; change --up" \
    render quad.plt -o x.ppm --up 0,0,0
verdict "no refused camera left a picture" "$(
    ls x.ppm 2>/dev/null
    left_behind)"
range --size "a multiple of 16, to 2048" "15 16 2048 2049" tables --rows ground --views 1 1
range --views "1 to 16" "0 1 16 17" tables --rows ground --size 16 4
few='tables --rows ground --size 16 --views 1 3'
# shellcheck disable=SC2086
range --frames "2 to 500" "1 2 500 501" $few --rounds 1
# shellcheck disable=SC2086
range --rounds "1 to 100" "0 1 100 101" $few --frames 2
finish
