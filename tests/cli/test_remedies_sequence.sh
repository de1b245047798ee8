#!/bin/sh
# test_remedies_sequence.sh - what the tools say of frames of a sequence helps
#
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/remedies.sh
. tests/cli/wave.sh
begin remedies_sequence
waves 4
echo 'wave_{}.ply*4 1 0 0 0' >wave.txt

# ---- how it is asked for: pack_frames.c, cmd_pack.c ----------------------------------------

says "--frames, --rate, --key, --stills and --tree-for go with --sequence" \
    pack wave.txt --frames 0:2 -o x.plt
cured pack --sequence wave.txt --frames 0:2 -o x.plt
says "--frames, --rate, --key, --stills and --tree-for go with --sequence" \
    pack wave_000.ply --tree-for all -o x.plt
cured pack --sequence wave_00?.ply --tree-for all -o x.plt
for flag in '--quality fast' '--build device' '--build none' '--splits median'; do
    # shellcheck disable=SC2086
    says "--tree-for all takes --build host, --splits sah and --quality high" \
        pack --sequence wave_00?.ply --tree-for all $flag -o x.plt
done
cured pack --sequence wave_00?.ply --tree-for all --quality high --build host \
    --splits sah -o x.plt
says "--sequence of one MESH takes --frames A:B, too" pack --sequence wave.txt -o x.plt
cured pack --sequence wave.txt --frames 0:2 -o x.plt
says "--frames A:B is for one MESH: a recipe, or a name with '{}'" \
    pack --sequence wave_000.ply wave_001.ply --frames 0:2 -o x.plt
cured pack --sequence 'wave_{}.ply' --frames 0:2 -o x.plt
cured pack --sequence wave_000.ply wave_001.ply -o x.plt
says "--frames takes A:B, 0 to %d, A below B, not '%s'" \
    pack --sequence wave.txt --frames 2 -o x.plt
cured pack --sequence wave.txt --frames 0:2 -o x.plt
says "%s is for one mesh, not for --sequence" pack --sequence wave_00?.ply --weld 1 -o x.plt
cured pack --sequence wave_00?.ply -o x.plt
cured pack wave_000.ply --weld 0.001 -o x.plt
says "--sequence reads its files twice, and standard input cannot be" \
    pack --sequence - wave_001.ply -o x.plt
cured pack --sequence wave_00?.ply -o x.plt
for flag in '--geometry float' '--build device' '--treelet 32'; do
    # shellcheck disable=SC2086
    says "--sequence with --nodes compact takes --geometry lattice and --build host, and its \
blocks are of 64 nodes" pack --sequence wave_00?.ply --nodes compact $flag -o x.plt
done
cured pack --sequence wave_00?.ply --nodes compact --geometry lattice --build host -o x.plt
says "--stills takes --nodes compact" pack --sequence wave_00?.ply --stills -o x.plt
cured pack --sequence wave_00?.ply --nodes compact --stills -o x.plt
says "--stills has no --key: no frame depends on others" \
    pack --sequence wave_00?.ply --nodes compact --stills --key 4 -o x.plt
cured pack --sequence wave_00?.ply --nodes compact --key 4 -o x.plt
says "--tree-for all takes --nodes thesis" \
    pack --sequence wave_00?.ply --nodes compact --tree-for all --quality high -o x.plt
cured pack --sequence wave_00?.ply --nodes compact --quality high -o x.plt
says "--checks on is for a --sequence of --stills: no others are streamed" \
    pack --sequence wave_00?.ply --checks on -o x.plt
cured pack --sequence wave_00?.ply --checks off -o x.plt
says "--sequence takes --numbers with --nodes compact alone" \
    pack --sequence wave_00?.ply --numbers none -o x.plt
cured pack --sequence wave_00?.ply --nodes compact --numbers none -o x.plt
says "--sequence takes --step with a lattice alone" \
    pack --sequence wave_00?.ply --geometry float --step power -o x.plt
cured pack --sequence wave_00?.ply --step power -o x.plt

# ---- with records or without: vertices.c, scene.c -------------------------------------------

run pack --sequence wave_00?.ply -o x.plt
says "--records and --beside are for --frames A:B of an image that has them" \
    render x.plt -o x.png --records never
cured render x.plt -o x.png --records never --frames 0:1
says "--records and --beside are for --frames A:B of an image that has them" \
    render x.plt -o x.png --beside --moved wave_000.ply
cured render x.plt -o x.png --beside --frames 0:1
says "--beside is for --records never, or auto" \
    render x.plt -o x.png --records always --beside --frames 0:1
cured render x.plt -o x.png --records never --beside --frames 0:1
says "--rebuild is for --records always, or auto without --beside" \
    render x.plt -o x.png --records never --rebuild cost --frames 0:1
says "--rebuild is for --records always, or auto without --beside" \
    render x.plt -o x.png --beside --rebuild cost --frames 0:1
cured render x.plt -o x.png --rebuild cost --frames 0:1
says "%s; leave out --records never and --beside" \
    render x.plt -o x.png --records never --structure grid --frames 0:1
cured render x.plt -o x.png --structure grid --frames 0:1
run pack --sequence wave_00?.ply --build device -o device.plt
says "%s; leave out --records never and --beside" \
    render device.plt -o x.png --beside --frames 0:1
cured render device.plt -o x.png --frames 0:1

# ---- frames that do not fit: pack_frames.c --------------------------------------------------

mv wave_002.ply whole.ply
wave 2 8 >wave_002.ply
says "%s: has %zu vertices and %zu triangles, the first frame %zu and %zu; write all frames from \
one mesh" pack --sequence wave_00?.ply -o x.plt
cp whole.ply wave_002.ply
cured pack --sequence wave_00?.ply -o x.plt
sed '$s/^3 \([0-9]*\) \([0-9]*\)/3 \2 \1/' whole.ply >wave_002.ply
says "%s: triangle %zu has other vertices than in the first frame; write all frames from one mesh" \
    pack --sequence wave_00?.ply -o x.plt
mv whole.ply wave_002.ply
cured pack --sequence wave_00?.ply -o x.plt
# Some 2^41 long: single precision has no finer steps there than the lattice.
printf 'v %s\n' '-1099511627776 -1099511627776 0' '1099511627776 0 0' '0 1099511627776 0' >far.obj
echo 'f 1 2 3' >>far.obj
says "a lattice over all frames would reach beyond 2^40; use --geometry float" \
    pack --sequence far.obj far.obj -o x.plt
cured pack --sequence far.obj far.obj --geometry float -o x.plt

# ---- frames that are not there: played.c ------------------------------------------------------

run pack --sequence wave_00?.ply -o wave.plt
says "has %u frame%s; use --frames 0:%u or less" render wave.plt -o x.y4m --frames 2:5 --size 8x8
# shellcheck disable=SC2046
cured render wave.plt -o x.y4m --size 8x8 $(sed -n 's/.*use \(--frames [0-9:]*\) or less$/\1/p' err)

# ---- what blocks are not moved by: moved.c, scene.c -------------------------------------------

run pack --sequence wave_00?.ply --nodes compact -o blocks.plt
says "the scene has compact blocks, which no mesh moves; use --frames" \
    render blocks.plt --moved wave_001.ply -o x.ppm --size 8x8
cured render blocks.plt --frames 1:2 -o x.ppm --size 8x8
says "%s; leave out --rebuild" render blocks.plt --frames 1:2 -o x.ppm --size 8x8 --rebuild cost
cured render blocks.plt --frames 1:2 -o x.ppm --size 8x8
run pack --sequence wave_00?.ply --nodes compact --stills -o stills.plt
says "--schedule task is for one frame that stays; use batch, or branch" \
    render stills.plt --frames 1:2 -o x.ppm --size 8x8 --residency streamed --schedule task
for schedule in batch branch; do
    cured render stills.plt --frames 1:2 -o x.ppm --size 8x8 --residency streamed \
        --schedule $schedule
done
finish
