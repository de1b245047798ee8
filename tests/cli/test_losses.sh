#!/bin/sh
# test_losses.sh - what pack leaves out, moves or drops is said in one line each
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin losses

# says SENTENCE LINE...: the last run succeeded, and these lines are all it said.
says() {
    sentence=$1
    shift
    verdict "$sentence" "$(
        [ "$status" -eq 0 ] || echo "status $status"
        for line in "$@"; do printf '%s\n' "$line"; done >expected
        [ $# -gt 0 ] || : >expected
        cmp -s expected err || cat err)"
}
border='the surface has holes or a border'

# ---- left out ---------------------------------------------------------------------

all_kinds all.obj
run pack all.obj -o all.plt --json all.json
says "points, lines, curves, colours, normals, texture coordinates and materials are counted" \
    "all.obj: left out 1 face of fewer than 3 corners, 1 point, 2 lines, 1 curve or free-form \
surface, 3 colours, 1 normal, 2 \
texture coordinates, 1 use of a material" \
    "all.obj: 4 open edges: $border"
verdict "... also in --json" "$(
    for pair in points:1 lines:2 curves:1 colours:3 normals:1 texture_coordinates:2 materials:1 \
        open_edges:4 vertices:4 dropped_faces:0; do
        grep -q "\"${pair%:*}\": ${pair#*:}[,}]*\$" all.json ||
            grep -q "\"${pair%:*}\": ${pair#*:}," all.json || echo "$pair"
    done)"
run pack all.obj all.obj -o - --json two.json
verdict "... of each file, with the image on standard output" "$(
    [ "$(grep -c '"file": "all.obj"' two.json)" -eq 2 ] || cat two.json)"

# ---- nothing to trace ---------------------------------------------------------------

printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\n' >cut.obj
refused "vertices of an OBJ cut short" cut.obj "3 vertices, no faces: nothing to trace" \
    pack cut.obj -o x.plt
printf 'solid a\nendsolid a\n' >none.stl
refused "an STL without facets" none.stl "0 vertices, no faces: nothing to trace" \
    pack none.stl -o x.plt
verdict "... leave no image" "$(ls x.plt 2>/dev/null)"
# nothing SENTENCE MESH LINE: pack MESH has nothing to trace, and LINE says what there is.
nothing() {
    run pack "$2" -o x.plt
    verdict "$1" "$(
        [ "$status" -eq 1 ] || echo "status $status"
        printf '%s: %s: nothing to trace; write it with its faces; points need a surface first\n' \
            "$2" "$3" | cmp -s - err || cat err)"
}
v='v 0 0 0\nv 1 0 0\nv 0 1 0\n'
printf "${v}l 1 2\nl 2 3\np 1\n" >lines.obj
nothing "lines and points are named, for there are no faces" lines.obj \
    "3 vertices, 2 lines, 1 point, no faces"
printf "${v}f 1 2\nf 3\n" >small.obj
nothing "... and small faces are, for there are some" small.obj \
    "3 vertices, 2 faces of fewer than 3 corners"
printf "${v}f 1 2\nf 1 2 9\n" >both.obj
refused "... and what --repair drops beside them" both.obj \
    "3 vertices, 1 face of fewer than 3 corners, and 1 that had to be dropped: nothing to trace" \
    pack both.obj -o x.plt --repair
printf "${v}curv 0 1 1 2\nf 1\np 1 2\n" >curve.obj
nothing "... and curves" curve.obj \
    "3 vertices, 1 curve or free-form surface, 1 point, 1 face of fewer than 3 corners"
printf 'cut.obj 1 0 0 0\n' >cut.txt
refused "a recipe of it" cut.txt \
    "line 1: cut.obj: 3 vertices, no triangles: nothing to place; leave it out" \
    pack cut.txt -o x.plt
run pack all.obj cut.obj -o x.plt
verdict "... beside a file with faces it is a line" "$(
    [ "$status" -eq 0 ] || echo "status $status"
    [ "$(grep -c '^cut.obj: 3 vertices, no faces: nothing to trace; ' err)" -eq 1 ] || cat err)"

# ---- single precision ----------------------------------------------------------------

cat >utm.obj <<'END'
v 500000.1 4500000.3 100
v 500001.1 4500000.3 100
v 500000.1 4500000.7 101
v 500001.1 4500000.7 101
f 1 2 3
f 2 4 3
END
run pack utm.obj -o utm.plt
verdict "coordinates that single precision moves get a line, which names --centre" "$(
    grep '^utm.obj: single precision moves corners by up to 0.2, .* of an edge there, and 0 ' err |
        grep -q 'triangles lose an edge; use pack --centre to move the mesh to the origin first$' ||
        cat err)"
for format in "--nodes thesis" "--nodes compact" "--nodes compact --geometry lattice:21" \
    "--nodes compact --geometry float" "--build device"; do
    # shellcheck disable=SC2086
    run pack utm.obj -o utm.plt --centre $format
    verdict "... after which nothing is lost ($format)" "$(
        [ "$status" -eq 0 ] || echo "status $status"
        grep 'single precision' err
        run info utm.plt --json
        grep -q '"shift": \[500000.59999999998, 4500000.5, 100.5\]' out || grep shift out
        # A lattice may round up by one step.
        grep -q '"lo": \[-0.5[0-9]*, -0.[12][0-9]*, -0.5[0-9]*\]' out || grep '"lo"' out)"
done
run info utm.plt
verdict "info prints the shift" "$(
    grep -q '^shift  *(500000.59999999998, 4500000.5, 100.5) was subtracted' out || cat out)"
works "--origin moves a point to 0" pack utm.obj -o utm.plt --origin 500000,4500000,100
verdict "... and is remembered" "$(
    run info utm.plt --json
    grep -q '"shift": \[500000, 4500000, 100\]' out || grep shift out
    grep -q '"lo": \[0.100000001, 0.300000012, 0\]' out || grep '"lo"' out)"
run pack all.obj -o plain.plt
run pack all.obj -o same.plt --origin 0,0,0
same plain.plt same.plt "an origin of 0 changes no byte"
run info plain.plt
verdict "... and is not spoken of" "$(grep shift out)"
misused "--centre and --origin at once" "--origin" pack utm.obj -o x.plt --centre --origin 1,2,3
misused "an origin of two numbers" "--origin" pack utm.obj -o x.plt --origin 1,2
refused "an origin too far away" utm.obj "beyond" pack utm.obj -o x.plt --origin 2e12,0,0
printf 'utm.obj 10 0 0 0\n' >far.txt
run pack far.txt -o far.plt
verdict "a recipe of such a mesh gets a line, too" "$(
    grep -q '^far.txt: single precision moved corners by .*; use pack --centre to place' err ||
        cat err)"
run pack far.txt -o far.plt --centre
verdict "... and --centre places it first" "$(grep single err)"

# ---- seams ------------------------------------------------------------------------------

seams seams.stl
run pack seams.stl -o seams.plt
says "open edges that all but meet name a distance" \
    "seams.stl: 6 open edges, some of which all but meet; use pack --weld 2e-06 to close 6"
run pack seams.stl -o seams.plt --weld 2e-06
says "... that closes them" \
    "seams.stl: welded 2 positions to another; 0 triangles lost their area by it"
run pack seams.stl -o seams.plt --weld 10
says "... and a distance beyond reason says what it takes" \
    "seams.stl: welded 5 positions to another; 4 triangles lost their area by it" \
    "seams.stl: 4 triangles have no area: never hit, but counted and numbered"
for distance in 0 -1 x; do
    misused "--weld $distance" "--weld" pack seams.stl -o x.plt --weld "$distance"
    verdict "... a single number is not said to need commas" "$(grep comma err)"
done
run make ground -o closed.ply
run pack closed.ply -o closed.plt
says "a closed mesh has nothing to say"

# ---- habits and repair ---------------------------------------------------------------------

{
    head -n 2 seams.stl
    sed -n '3,$p' seams.stl | grep -v endsolid
    printf '\0\032'
} | tr 'a-z' 'A-Z' >habits.stl
run pack habits.stl -o habits.plt --weld 2e-06
says "an ASCII STL in capitals without endsolid, and bytes behind it" \
    "habits.stl: read whole in spite of 1 solid without endsolid" \
    "habits.stl: welded 2 positions to another; 0 triangles lost their area by it"
printf 'ply\nformat ascii 1.0\nmade by hand\nelement vertex 4\nproperty float x\nproperty float y
property float z\nelement face 3\nproperty list uchar int vertex_indices\nend_header
0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n2 0 1\n4 0 2 1 3\nmore\n' >habits.ply
run pack habits.ply -o habits.plt
says "a PLY with a line, a small face, a face that crosses itself and bytes behind the data" \
    "habits.ply: left out 1 face of fewer than 3 corners" \
    "habits.ply: 1 face crosses itself, and no triangles fill it without overlap; cut it into \
triangles where it was made" \
    "habits.ply: read whole in spite of 1 header line that is no PLY keyword" \
    "habits.ply: ignored 5 bytes behind the data" \
    "habits.ply: 2 open edges: $border"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nf 1 2 3\nf 1 2 4 3\nf 1 2 9\n' >repair.obj
run pack repair.obj -o repair.plt --repair
says "--repair counts faces, not triangles" \
    "repair.obj: dropped 2 faces that cannot be traced, 1 vertex that is not finite or is beyond \
+-2^40" \
    "repair.obj: 3 open edges: $border"

printf 'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n' >flat.obj
run pack flat.obj -o flat.plt --nodes compact
verdict "a mesh of which nothing is left on the lattice" "$(
    [ "$status" -eq 0 ] || echo "status $status"
    grep -q ' 0 triangles lost their area (1 had none).*; nothing is left to trace$' err ||
        cat err)"
printf '\0\0v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n\032\032\0\0\0' >filled.obj
run pack filled.obj -o filled.plt
says "an OBJ with fillers around it" "filled.obj: 3 open edges: $border"
run info filled.plt
verdict "... is read whole" "$(grep -q '^triangles  *1$' out || cat out)"
run pack filled.obj -o filled.plt --nodes compact
run info filled.plt
verdict "... and has one triangle in compact nodes, too" "$(
    grep -q '; 1 of 1 triangles kept their area$' out || cat out)"

printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nfo 1 2 3\nF 1 2 3\ncall x\n' >old.obj
run pack old.obj -o old.plt
says "an OBJ with fo, and lines that nothing reads" \
    "old.obj: left out 2 lines of keywords that are not read" \
    "old.obj: 3 open edges: $border"

# ---- messages of failures stay alone -------------------------------------------------------

refused "a failing pack says one line" missing/x "" pack habits.ply -o missing/x
finish
