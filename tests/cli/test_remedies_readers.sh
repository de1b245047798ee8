#!/bin/sh
# test_remedies_readers.sh - messages about binary STL, bare meshes and numbers help
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/remedies.sh
begin remedies_readers
quad quad.ply

# triangle X Y: a triangle of a binary STL, of (0,0) (X,Y) (0,1).
triangle() {
    echo "0 0 1 0 0 0 $1 $2" | rays part && cat part
    echo '0 0 1 0 0 0 0 0' | rays part && head -c 16 part
    printf '\0\0'
}
{ head -c 80 /dev/zero; printf '\2\0\0\0'; triangle 1 0; triangle 1 1; } >two.stl
{ head -c 80 two.stl; printf '\0\0\0\0'; tail -c +85 two.stl; printf 'abc'; } >bad.stl
says "byte 80: its count of triangles says %llu, but the file holds %llu and %llu bytes more; use \
pack --repair to read what it holds" pack bad.stl -o x.plt
packs 2 bad.stl --repair
head -c 84 bad.stl >part.stl
printf 'abc' >>part.stl
says "byte %d: a triangle takes %d bytes, but %llu follow; get the file again" \
    pack part.stl -o x.plt
cp two.stl part.stl
packs 2 part.stl

printf 'v 0 0 0\nv 1 0 0\n' >bare.obj
printf 'bare.obj 1 0 0 0\nquad.ply 1 0 0 0\n' >bad.txt
says "%zu %s, no triangles: nothing to place; leave it out" pack bad.txt -o x.plt
sed '/^bare/d' bad.txt >left.txt
packs 2 left.txt

says "%s takes a number, not '%s'" pack quad.ply -o x.plt --weld 1,2
packs 2 quad.ply --weld 0.1
says "%s takes %u numbers separated by commas, not '%s'" pack quad.ply -o x.plt --origin 1,2
packs 2 quad.ply --origin 1,2,3
finish
