#!/bin/sh
# test_remedies_textures.sh - what messages about textures advise, helps; what is left out is said
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/remedies.sh
begin remedies_textures
quad quad.ply

# picture NAME WIDTH HEIGHT [FROM]: a P6 whose bytes go on from FROM.
picture() {
    awk -v w="$2" -v h="$3" -v from="${4:-0}" 'BEGIN {
        printf "P6\n# a comment\n%d %d 255\n", w, h
        for (i = 0; i < 3 * w * h; i++) printf "%c", 33 + (from + i) % 90
    }' >"$1"
}
# painted MTL_LINE...: good.obj, two triangles, of which the first has these lines in its material.
painted() {
    {
        printf 'newmtl a\nKd 1 1 1\n'
        for line in "$@"; do printf '%s\n' "$line"; done
        printf 'newmtl b\nKd 1 1 1\nnewmtl unused\nmap_Kd gone.png\n'
    } >paint.mtl
    {
        printf 'mtllib paint.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n'
        printf 'vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\n'
        printf 'usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 2/2 3/3 4/4\n'
    } >good.obj
}
# textured WIDTH LINE...: those lines give a texture of that width, which info says.
textured() {
    width=$1
    shift
    painted "$@"
    run pack good.obj -o x.plt --materials keep --strict
    code=$status
    cp err said
    run info x.plt --json
    verdict "a texture of $width: $*" "$(
        [ "$code" -eq 0 ] || cat said
        grep -q "\"width\": $width," out || echo "no such texture")"
}

# ---- pack: host_tools/cli/pack_textures.c, mesh/mtl_map.c, picture/ppm_read.c ------------------

picture p.ppm 5 3
run pack quad.ply -o quad.plt
run render quad.plt -o p.png --size 9x7
painted 'map_Kd p.ppm'
says "--textures are of materials; add --materials keep" pack good.obj -o x.plt --textures blocks
packs 2 good.obj --textures blocks --materials keep
says "--textures are of triangles that stay where they are; leave out --sequence" pack good.obj \
    -o x.plt --textures blocks --materials keep --sequence
packs 2 good.obj --textures blocks --materials keep
painted 'map_Kd gone.png'
says "there is no such picture; correct the name in the MTL" pack good.obj -o x.plt \
    --materials keep --strict
painted 'map_Kd -s nan inf p.ppm'
says "there is no such picture; correct the name in the MTL" pack good.obj -o x.plt \
    --materials keep --strict
painted 'map_Kd p.ppm'
packs 2 good.obj --materials keep --strict
painted 'map_Kd gone.png'
says "%s, or leave out --strict" pack good.obj -o x.plt --materials keep --strict
packs 2 good.obj --materials keep
run pack good.obj -o x.plt --materials keep
message="%s; its material is used without it"
said=$(grep -q -- "$(pattern "$message")" err || cat err)
painted 'map_Kd p.ppm'
cured pack good.obj -o x.plt --materials keep
run pack good.obj -o x.plt --materials keep
verdict "of a picture that is there nothing is said, nor of one that no triangle has" "$(
    grep 'gone.png\|p.ppm' err)"

# wrong MESSAGE: the picture bad.ppm is refused with it, and p.ppm is not.
wrong() {
    painted 'map_Kd bad.ppm'
    says "$1" pack good.obj -o x.plt --materials keep --strict
    painted 'map_Kd p.ppm'
    packs 2 good.obj --materials keep --strict
}
printf '\377\330\377\340 a JPEG' >bad.ppm
wrong "is no PNG picture, nor PPM of P6; convert it"
printf 'P6 4 4 65535 ' >bad.ppm
wrong "only PPM of 8 bits, P6 or P5, is read; convert it"
head -c 50 p.ppm >bad.ppm
wrong "ends before the last of %u x %u pixels; write it again"
printf 'P5 16385 1 255\n' >bad.ppm
head -c 16385 /dev/zero >>bad.ppm
wrong "a texture of %u x %u pixels is too large; make it %d at most"
{ head -c 20 p.png; printf '\1'; tail -c +22 p.png; } >bad.ppm
wrong "its chunk %s at byte %zu is damaged (CRC); write it again"
head -c 60 p.png >bad.ppm
wrong "holds no picture; write it again"
mkdir folder.png
painted 'map_Kd folder.png'
says "is a directory and no picture; correct the name in the MTL" pack good.obj -o x.plt \
    --materials keep --strict
cured pack good.obj -o x.plt --materials keep --textures none
painted 'map_Kd -clamp on'
run pack good.obj -o x.plt --materials keep
verdict "a line without a file is said, with its number" "$(
    [ "$status" -eq 0 ] || echo "status $status"
    grep -q "paint.mtl: line 3 has no file behind 'map_Kd'; the default is used" err || cat err)"

# many COUNT: a triangle each of so many materials, with a picture each of its own.
many() {
    awk -v count="$1" 'BEGIN {
        print "mtllib many.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0"
        for (i = 0; i < count; i++) {
            print "usemtl m" i "\nf 1/1 2/1 3/1"
            print "newmtl m" i "\nmap_Kd many" i ".ppm" >"many.mtl"
            printf "P6 1 1 255 %c%c%c", 40 + i % 64, 40 + int(i / 64), 60 >("many" i ".ppm")
            close("many" i ".ppm")
        }
    }' >many.obj
}
many 256
says "there are more than %d textures; merge some" pack many.obj -o x.plt --materials keep --strict
cp many0.ppm many1.ppm
packs 256 many.obj --materials keep --strict

# ---- what is read of a line ---------------------------------------------------------------------

cp p.ppm 'two words.ppm'
cp p.ppm 7
mkdir maps
picture maps/deep.ppm 6 2
textured 5 'map_Kd p.ppm'
textured 9 'map_Kd p.png'
textured 5 'map_kd two words.ppm'
textured 5 'map_Kd 7'
textured 5 'map_Kd -s 2 7'
textured 5 'map_Kd -s 2 2 1 -o 0.5 -clamp on -texres 8 -mm 0 1 p.ppm'
textured 6 'map_Kd maps/deep.ppm'
textured 6 'map_Kd maps\deep.ppm'
textured 6 "map_Kd $PWD/maps/deep.ppm"
textured 6 'map_Kd p.ppm' 'map_Kd maps/deep.ppm'
painted 'map_Kd -mm 0 1 -boost 2 p.ppm' 'map_Ks p.ppm' 'map_Bump -bm 1 p.ppm'
run pack good.obj -o x.plt --materials keep
verdict "pictures and options that are left out are said in one line" "$(
    grep -q "good.obj: of its materials' pictures and their options these are left out: map_ks, \
map_bump, -mm, -boost" err || cat err)"

# ---- sizes -------------------------------------------------------------------------------------

for format in rgb565:2.7:2.9 blocks:0.67:0.8; do
    picture big.ppm 128 96
    painted 'map_Kd big.ppm'
    run pack good.obj -o x.plt --materials keep --textures "${format%%:*}"
    run info x.plt
    verdict "info says sizes, levels and bytes per texel of ${format%%:*}" "$(
        grep -q "^  0  *128 x 96 texels, 8 levels, ${format%%:*}, [0-9]* bytes" out || cat out
        awk -v range="$format" '/^texture bytes/ { split(range, r, ":"); found = 1
            if ($4 < r[2] || $4 > r[3]) print $0 } END { if (!found) print "no line" }' out)"
done
cp p.ppm copy.ppm
sed 's/^newmtl b/&\nmap_Kd -clamp on copy.ppm/' paint.mtl >twice.mtl
sed 's/paint.mtl/twice.mtl/' good.obj >twice.obj
sed -i 's/big.ppm/p.ppm/' twice.mtl
run pack twice.obj -o x.plt --materials keep --strict
run info x.plt --json
verdict "a picture that is there twice is stored once" "$(
    [ "$(grep -c '"width": 5' out)" -eq 1 ] || cat out)"
run pack good.obj -o none.plt --materials keep --textures none
sed '/map_Kd/d' paint.mtl >bare.mtl
sed 's/paint.mtl/bare.mtl/' good.obj >bare.obj
run pack bare.obj -o bare.plt --materials keep
same none.plt bare.plt "an image without textures is what it was before there were any"

# ---- render: host_tools/app/textures.c ----------------------------------------------------------

for flag in '--textures nearest' '--texture-room 1000'; do
    # shellcheck disable=SC2086
    says "--textures and --texture-room are for --shader smooth or whitted; add one" render x.plt \
        -o x.png --size 8x8 $flag
    for shader in smooth whitted; do
        # shellcheck disable=SC2086
        cured render x.plt -o x.png --size 8x8 $flag --shader $shader
    done
done
# Coordinates in a table, which are not streamed, and in pages, which are.
painted 'map_Kd p.ppm'
run pack good.obj -o x.plt --materials keep
message="%s: without its textures, as it is streamed and their coordinates are in a table; pack it \
with --surface pages"
run render x.plt -o x.png --size 8x8 --shader whitted --residency streamed
said=$([ "$status" -eq 0 ] && grep -qx "$(pattern "$message")" err || cat err)
cured pack good.obj -o paged.plt --materials keep --surface pages
run render x.plt -o y.png --size 8x8 --shader whitted --residency streamed --textures none
verdict "... but not if they are not wanted" "$([ "$status" -eq 0 ] || cat err; cat err)"
same x.png y.png "... and is the picture without them"
run render x.plt -o x.png --size 8x8 --shader whitted
verdict "... nor does one that has them" "$([ "$status" -eq 0 ] || cat err; cat err)"
for shader in smooth whitted; do
    run render x.plt -o x.ppm --size 8x8 --shader $shader
    for how in '' '--residency streamed' '--residency streamed --texture-room 140' \
        '--residency streamed --source read --prefetch 2'; do
        # shellcheck disable=SC2086
        run render paged.plt -o y.ppm --size 8x8 --shader $shader $how
        verdict "$shader by pages, $how: nothing is said" "$(
            [ "$status" -eq 0 ] || echo "status $status"
            cat err)"
        same x.ppm y.ppm "... and it is the same picture"
    done
done
run render x.plt -o x.ppm --size 8x8 --shader smooth
for how in '--source read' '--packet 2' '--source read --texture-room 140'; do
    # shellcheck disable=SC2086
    run render x.plt -o y.ppm --size 8x8 --shader smooth $how
    same x.ppm y.ppm "smooth has textures, $how: the same picture"
done
run render x.plt -o y.ppm --size 8x8 --shader smooth --textures none
verdict "... and another without them" "$(cmp -s x.ppm y.ppm && echo "the same picture")"
for room in 139 x 1073741825; do
    run render x.plt -o y.png --size 8x8 --shader whitted --texture-room "$room"
    verdict "--texture-room $room is refused in a sentence" "$(
        [ "$status" -eq 2 ] || echo "status $status"
        grep -q -- '--texture-room takes' err || cat err)"
done
finish
