#!/bin/sh
# test_remedies_materials.sh - what messages about materials and lights advise, helps
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/remedies.sh
begin remedies_materials
quad quad.ply

# ---- pack: host_tools/cli/pack_materials.c, mesh/materials.c, pack/material_section.c ----------

printf 'newmtl a\nKd 1 0 0\nnewmtl b\nKs 1 1 1\nillum 3\n' >good.mtl
{
    printf 'mtllib good.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n'
    printf 'usemtl a\nf 1 2 3\nusemtl b\nf 2 3 4\n'
} >good.obj
says "--strict is about materials; add --materials keep" pack good.obj -o x.plt --strict
packs 2 good.obj --strict --materials keep
says "--reduce leaves other triangles than the mesh's; leave out --materials" pack good.obj \
    -o x.plt --reduce 2 --materials keep
cured pack good.obj -o x.plt --reduce 2
says "has no materials (usemtl of OBJ); leave out --materials" pack quad.ply -o x.plt \
    --materials keep
packs 2 quad.ply
run make marbles --instances --triangles 160 -o marbles.txt
says "--materials are not of instances; leave out one of them" pack --instances marbles.txt \
    -o x.plt --materials keep
cured pack --instances marbles.txt -o x.plt
for numbers in "--numbers none" "--build device"; do
    # shellcheck disable=SC2086
    says "--materials are of the file's triangles; with compact nodes they take --numbers keep and \
--build host" pack good.obj -o x.plt --materials keep --nodes compact $numbers
    packs 2 good.obj --materials keep --nodes compact
done
for mistake in 's/good.mtl/gone.mtl/' 's/usemtl b/usemtl c/'; do
    sed "$mistake" good.obj >bad.obj
    says "%s; correct it, or leave out --strict" pack bad.obj -o x.plt --materials keep --strict
    packs 2 good.obj --materials keep --strict
    says "%s; correct it, or leave out --strict" pack bad.obj -o x.plt --materials keep --strict
    packs 2 bad.obj --materials keep
    run pack bad.obj -o x.plt --materials keep
    verdict "without --strict $mistake is said, and the default used" "$(
        [ "$status" -eq 0 ] || echo "status $status"
        grep -q '; the default is used$' err || cat err
    )"
done
run pack bad.obj -o x.plt --materials keep
message="%s; the default is used"
said=$(grep -q -- "$(pattern "$message")" err || cat err)
cured pack good.obj -o x.plt --materials keep
sed 's/Kd 1 0 0/Kd red/' good.mtl >bad.mtl
sed 's/good.mtl/bad.mtl/' good.obj >bad.obj
says "%s; correct it, or leave out --strict" pack bad.obj -o x.plt --materials keep --strict
packs 2 bad.obj --materials keep
# Whatever a mesh writes, and however often, is said in a few lines that a terminal can be shown.
awk 'BEGIN { for (i = 0; i < 40; i++) print "newmtl a\nKd" }' >bad.mtl
printf 'usemtl \033]0;\007c\n' >>bad.obj
run pack bad.obj -o x.plt --materials keep
verdict "of forty troubles sixteen are said, and how many more there are" "$(
    [ "$status" -eq 0 ] || echo "status $status"
    grep -c '; the default is used$' err | grep -qx 16 || cat err
    grep -qx 'bad.obj: and 26 more of these' err || cat err)"
sed '/^mtllib/d; s/usemtl b/usemtl \x1b]0;\x07c/' good.obj >bad.obj
run pack bad.obj -o x.plt --materials keep
verdict "a name's control characters are not" "$(
    grep -qF "no library defines the material '?]0;?c'; the default is used" err || cat -v err
    tr -d '\n' <err | grep '[[:cntrl:]]' | cat -v)"
awk 'BEGIN { for (i = 0; i < 300; i++) print "mtllib gone" i ".mtl\nmtllib good.mtl" }' >bad.obj
sed '/^mtllib/d' good.obj >>bad.obj
run pack bad.obj -o x.plt --materials keep
verdict "a library is read once, and of more than 256 the rest is not" "$(
    [ "$status" -eq 0 ] || echo "status $status"
    grep -qx 'bad.obj: and 284 more of these' err || cat err)"
awk 'BEGIN {
    print "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"
    for (i = 0; i < 720000; i++) print "usemtl one_of_many_" (i * 7919) % 60000
}' >bad.obj
timeout 60 "$PLANELET" pack bad.obj -o x.plt --materials keep 2>err
status=$?
verdict "names are found quickly among many" "$(
    [ "$status" -eq 0 ] || echo "status $status: 0.7 s were enough, 60 are not"
    grep -qx 'bad.obj: and 59984 more of these' err || cat err)"
printf 'newmtl a\nKd 1 0 0\n' >first.mtl
printf 'newmtl b\nKs 1 1 1\nillum 3\n' >'next one.mtl'
cp 'next one.mtl' next.mtl
sed 's/good.mtl/first.mtl next.mtl/' good.obj >two.obj
sed 's/good.mtl/first.mtl/; s/usemtl a/mtllib next one.mtl\n&/' good.obj >blank.obj
run pack good.obj -o good.plt --materials keep
for names in two blank; do
    run pack $names.obj -o $names.plt --materials keep --strict
    same $names.plt good.plt "all libraries of a line are read, or one with a blank: $names"
done
mkfifo pipe.mtl
sed 's/good.mtl/pipe.mtl/' good.obj >bad.obj
timeout 20 "$PLANELET" pack bad.obj -o x.plt --materials keep 2>err
status=$?
verdict "a library that is a pipe is not waited for" "$(
    [ "$status" -eq 0 ] || echo "status $status"
    grep -qF "its material library 'pipe.mtl' cannot be read" err || cat err)"
# many COUNT: a triangle each of so many materials.
many() {
    awk -v count="$1" 'BEGIN {
        print "mtllib many.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0"
        for (i = 0; i < count; i++) {
            print "usemtl m" i "\nf 1 2 3"
            print "newmtl m" i >"many.mtl"
        }
    }' >"many.obj"
}
many 257
says "has more than 256 materials; merge some, or use --materials none" pack many.obj -o x.plt \
    --materials keep
cured pack many.obj -o x.plt --materials none
many 256
says "--strict is about materials; add --materials keep" pack many.obj -o x.plt --strict
packs 256 many.obj --materials keep --strict

# ---- render: host_tools/app/lights.c ------------------------------------------------------------

run pack good.obj -o good.plt --materials keep
for light in point:1,2,3 sun:0,0,0,1 area:1,2,3,4 point:1,2,3,4,5 lamp:1,2,3,4 point:1,2,3,nan \
    sun:1,1,1,-1 area:1,2,3,4,1,17 area:1,2,3,4,1,0 point:1,2,3,4/ point:1e30,0,0,1 \
    area:1,2,3,4,-1 point:1,2,3,4x; do
    says "--light takes point:x,y,z,POWER, sun:x,y,z,POWER or area:x,y,z,POWER,RADIUS, up \
to 8 with '/' between them, not '%s'" \
        render good.plt -o x.png --size 8x8 --shader whitted --light "$light"
    cured render good.plt -o x.png --size 8x8 --shader whitted \
        --light point:1,2,3,4/sun:0,1,0,1/area:1,2,3,4,0.5
done
for flag in --sky --ground; do
    says "%s takes red, green and blue from 0 to 1000, not '%s'" render good.plt -o x.png \
        --size 8x8 --shader whitted "$flag" 1,2,-3
    cured render good.plt -o x.png --size 8x8 --shader whitted "$flag" 1,2,3
done
for flag in '--light sun:0,1,0,1' '--sky 1,1,1' '--ground 1,1,1' '--depth 2' '--shadows solid' \
    '--rays coherent'; do
    # shellcheck disable=SC2086
    says "%s is for --shader whitted; add that" render good.plt -o x.png --size 8x8 $flag
    # shellcheck disable=SC2086
    cured render good.plt -o x.png --size 8x8 $flag --shader whitted
done
says "--shader whitted takes --schedule branch" render good.plt -o x.png --size 8x8 \
    --shader whitted --residency streamed --schedule batch
cured render good.plt -o x.png --size 8x8 --shader whitted --residency streamed --schedule branch
for depth in 9 1000 -1 x; do
    run render good.plt -o y.png --size 8x8 --shader whitted --depth "$depth"
    verdict "--depth $depth is refused in a sentence" "$(
        [ "$status" -eq 2 ] || echo "status $status"
        grep -q -- '--depth takes' err || cat err
    )"
done
for depth in 0 8; do
    run render good.plt -o y.png --size 8x8 --shader whitted --depth "$depth"
    verdict "--depth $depth is rendered" "$([ "$status" -eq 0 ] || cat err)"
done
finish
