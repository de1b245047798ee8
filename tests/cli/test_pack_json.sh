#!/bin/sh
# test_pack_json.sh - pack --json is JSON, and says what the lines on standard error say
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin pack_json
quad quad.ply

# values FILE: its values, a line each, or what is wrong with it.
values() {
    awk -f "$CLI_TESTS/json.awk" "$1"
}
# member PATH: that value of x.json.
member() {
    values x.json | awk -F '\t' -v path="$1" '$1 == path { print $2 }'
}

# ---- what reads it here sees mistakes ---------------------------------------------------

for wrong in '{' '{}{}' '{"a": 1,}' '[1 2]' '[01]' '[1.]' '[nan]' '["a' '["\x"]' '["	"]' \
    '{"a": 1, "a": 2}' '{a: 1}' '[+1]'; do
    echo "$wrong" >wrong.json
    verdict "the tests' reader refuses $wrong" "$(values wrong.json | grep -q '^wrong' || echo no)"
done
for octal in '\377' '\300\200' '\355\240\200' '\303' '\364\220\200\200' '\200' '\001'; do
    bytes wrong.json "[\"$octal\"]\\n"
    verdict "... and the bytes $octal in a string" \
        "$(values wrong.json | grep -q '^wrong' || echo no)"
done

# ---- names ---------------------------------------------------------------------------

# named NAME JSON: a file of that name, octal escapes and all, has that name there.
named() {
    name=$(printf "$1.") # command substitution takes line ends away
    name=${name%.}
    cp quad.ply "$name"
    "$PLANELET" pack "$name" "$name" -o x.plt --json x.json >out 2>err </dev/null
    status=$?
    verdict "a file called '$(printf '%s' "$1" | sed 's/\\/\\\\/g')'" "$(
        [ "$status" -eq 0 ] || cat err
        values x.json | grep '^wrong'
        for i in 0 1; do
            got=$(member ".files[$i].file")
            [ "$got" = "\"$2\"" ] || echo "'$got'"
        done)"
}
utf8=$(printf '\303\251\342\202\254\360\237\230\200')
named 'plain.ply' 'plain.ply'
named 'a "quoted" one' 'a \"quoted\" one'
named 'back\\slash\\\\u0041' 'back\\slash\\\\u0041'
named 'two\nlines\tand\001more\177' 'two\u000alines\u0009and\u0001more\u007f'
named '\303\251\342\202\254\360\237\230\200' "$utf8"
named 'no\377utf\300\2008' 'no\ufffdutf\ufffd\ufffd8'
named '\355\240\200\364\220\200\200' '\ufffd\ufffd\ufffd\ufffd\ufffd\ufffd\ufffd'
named 'cut short\360\237\230' 'cut short\ufffd\ufffd\ufffd'
named '\340\237\277\303' '\ufffd\ufffd\ufffd\ufffd'
"$PLANELET" pack - -o x.plt --json x.json <quad.ply >out 2>err
verdict "standard input is called -" \
    "$([ "$(member '.files[0].file')" = '"-"' ] || cat x.json)"

# ---- counts --------------------------------------------------------------------------

# packed ARGUMENT...: a run whose words are compared with its JSON.
packed() {
    what=$*
    rm -f x.json
    run pack "$@" -o x.plt --json x.json
    verdict "pack $what: JSON" "$(
        [ "$status" -eq 0 ] || cat err
        values x.json | grep '^wrong')"
}
# said PATH PATTERN: the number that \(\) stands for in a line is that value; "no" without \(\).
said() {
    line=$(sed -n "s/.*$2.*/\\1/p" err)
    here=$(member "$1")
    verdict "... $1 is $here, as was said" "$(
        [ -n "$line" ] || { echo "no line has '$2'"; cat err; }
        printf '%s|%s|%s\n' "$1" "${line:-none}" "${here:-none}" | equal)"
}
all_kinds all.obj
packed quad.ply all.obj
said '.files[1].points' '[ ]\([0-9]*\) point'
said '.files[1].lines' '[ ]\([0-9]*\) lines'
said '.files[1].curves' '[ ]\([0-9]*\) curve'
said '.files[1].colours' '[ ]\([0-9]*\) colours'
said '.files[1].normals' '[ ]\([0-9]*\) normal'
said '.files[1].texture_coordinates' '[ ]\([0-9]*\) texture coordinates'
said '.files[1].materials' '[ ]\([0-9]*\) use of a material'
said '.files[1].small_faces' '[ ]\([0-9]*\) face of fewer than 3'
said '.files[1].open_edges' 'all.obj: \([0-9]*\) open edges'
verdict "... and of the other file nothing is said" "$(
    values x.json | grep '^.files.0' | grep -v 'file	\|vertices	4\|triangles	2\|open_edges	4' |
        grep -v '	\(0\|0e+00\|false\)$')"
verdict "... the image is counted" "$(
    [ "$(member .triangles)" = 4 ] || echo "triangles: $(member .triangles)"
    [ "$(member .image_bytes)" -eq "$(wc -c <x.plt)" ] || echo "bytes: $(member .image_bytes)"
    [ "$(member .lattice)" = null ] || echo "there is a lattice")"
printf 'ply\nformat ascii 1.0\nmade by hand\nelement vertex 5\nproperty float x\nproperty float y
property float z\nelement face 2\nproperty list uchar int vertex_indices\nelement camera 2
property int a\nend_header
0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n4 0 2 1 3\n3 0 1 4\n7\n8\nmore\n' >habits.ply
packed habits.ply
said '.files[0].overlapping_faces' ': \([0-9]*\) face crosses'
said '.files[0].unknown_header_lines' '[ ]\([0-9]*\) header line'
said '.files[0].loose_bytes' 'ignored \([0-9]*\) bytes'
said '.files[0].other_elements' '[ ]\([0-9]*\) elements\{0,1\} of'
said '.files[0].triangles_without_area' ': \([0-9]*\) triangle has no area'
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nf 1 2 3\nf 1 2 4 3\nf 1 2 9\n' >repair.obj
packed repair.obj --repair
said '.files[0].dropped_faces' 'dropped \([0-9]*\) faces'
said '.files[0].bad_vertices' '[ ]\([0-9]*\) vertex that is not'
{
    head -c 80 /dev/zero
    printf '\0\0\0\0'
    echo '0 0 1 0 0 0 1 0' | rays part && cat part
    echo '0 1 1 0 0 0 0 0' | rays part && head -c 16 part
    printf '\0\0'
} >count.stl
packed count.stl
# Of a count of 0 it is all that the size holds.
said '.files[0].miscounted_triangles' 'its count says 0 triangles, its size holds \([0-9]*\)'
{
    head -c 80 /dev/zero
    printf '\0\0\0\1'
    head -c 50 /dev/zero
} >swapped.stl
packed swapped.stl
said '.files[0].big_endian_triangles' '[ ]\([0-9]*\) triangle in big-endian'
seams ended.stl
sed '/endsolid/d' ended.stl >seams.stl
packed seams.stl
said '.files[0].unended_solids' '[ ]\([0-9]*\) solid without'
said '.files[0].open_edges' ': \([0-9]*\) open edges'
said '.files[0].weld_that_closes_edges' 'pack --weld \([^ ]*\) to'
said '.files[0].open_edges_it_closes' 'to close \([0-9]*\)'
packed seams.stl --weld 10
said '.files[0].welded_positions' 'welded \([0-9]*\) position'
said '.files[0].welded_triangles_without_area' '; \([0-9]*\) triangles\{0,1\} lost'
printf 'v %s.1 4500000.3 0\n' 500000 500001 500002 >far.obj
printf 'v 500001.1 4500000.7 1\nv 500000.1 4500000.4 0\nf 1 2 4\nf 2 3 4\nf 1 5 2\n' >>far.obj
packed far.obj
# A line has two digits.
two() {
    printf '%.2g' "$1"
}
verdict "... what single precision moves" "$(
    line="up to $(two "$(member '.files[0].moved_by_single_precision')"), $(
        two "$(member '.files[0].moved_in_edges')") of an edge there, and $(
        member '.files[0].triangles_that_lose_an_edge') triangle"
    grep -qF "$line" err || { echo "$line"; cat err; })"
# centre TRUE_OR_FALSE: so is said whether --centre would help.
centre() {
    verdict "... that --centre would help is $1" "$(
        [ "$(member '.files[0].centre_would_help')" = "$1" ] || cat x.json
        [ "$(grep -qe 'use pack --centre' err && echo true || echo false)" = "$1" ] || cat err)"
}
centre true
packed far.obj --centre
centre false
{ # as long as it is far away, with a small part
    cat far.obj
    printf 'v -500000 -4500000 0\nv -500000 -4500000 1\nv -500001 -4500000 0\nf 6 7 8\n'
} >huge.obj
packed huge.obj
verdict "... single precision moves it" "$(grep -q 'the mesh is too large' err || cat err)"
centre false
echo 'far.obj 10 0 0 0' >far.txt
packed far.txt
centre true
verdict "... also before meshes are placed" "$(
    line="by up to $(two "$(member '.files[0].moved_in_edges_before_placing')") of an edge before \
their meshes were placed, and $(member '.files[0].triangles_that_lost_an_edge_before_placing') \
triangle lost"
    grep -qF "$line" err || { echo "$line"; cat err; })"
printf 'v 100000.001 0 0\nv 100000.001 0 5e-324\nv 0 1 0\nf 1 2 3\n' >least.obj
packed least.obj
verdict "... of edges of almost no length at most a million" "$(
    [ "$(member '.files[0].moved_in_edges')" = 1e+06 ] || cat x.json)"
packed far.obj --origin 500000,4500000,-0.1
verdict "... the shift is there to the last digit" "$(
    for pair in 0:500000 1:4500000 2:-0.10000000000000001; do
        [ "$(member ".shift[${pair%:*}]")" = "${pair#*:}" ] || member ".shift[${pair%:*}]"
    done)"

run make knot --triangles 2000 -o knot.ply
run make knot --triangles 1000 -o small.ply
packed knot.ply small.ply
all=$(member .triangles)
verdict "... without --reduce all triangles are left after it" \
    "$([ "$(member .triangles_after_reduce)" = "$all" ] || cat x.json)"
packed knot.ply small.ply --reduce 500 --nodes compact --geometry lattice:12
verdict "... triangles are counted as read, after --reduce, and in the image" "$(
    run info x.plt --json
    read=$(($(member '.files[0].triangles') + $(member '.files[1].triangles')))
    [ "$read" -eq "$all" ] || echo "read: $read"
    after=$(member .triangles_after_reduce)
    [ "$after" -le 500 ] && [ "$after" -gt 250 ] || echo "after it: $after"
    [ "$after" = "$(number source_triangles <out)" ] || cat out
    [ "$(member .triangles)" = "$(number triangles <out)" ] || cat out)"

# ---- lattices ---------------------------------------------------------------------------

{
    cat all.obj
    printf 'v 0.5 0.5 0\nv 0.50005 0.5 0\nv 0.5 0.50005 0\nf 5 6 7\nf 5 5 6\n'
} >detail.obj
packed detail.obj --nodes compact --geometry lattice:12
said .lattice.bits 'lattice of \([0-9]*\) bits'
said .lattice.lost_their_area ', \([0-9]*\) triangles* lost [a-z]* area'
said .lattice.had_no_area '(\([0-9]*\) had none)'
said .lattice.merged_positions ', \([0-9]*\) positions* merged'
said .lattice.t_junctions ', \([0-9]*\) T-junctions* '
said .lattice.mended '(\([0-9]*\) mended)'
said .lattice.step 'step \([-+.e0-9]*\),'
said .lattice.unmoved_vertices ', \([0-9]*\) of [0-9]* vertices stayed'
said .lattice.vertices ', [0-9]* of \([0-9]*\) vertices stayed'
verdict "... the largest move, too" "$(
    grep -qF "by up to $(two "$(member .lattice.largest_move)") of" err || cat err)"
packed detail.obj --nodes compact --geometry float
verdict "... floats are on no lattice" "$(
    [ "$(member .lattice)" = null ] || member .lattice
    grep lattice err)"

# ---- where it goes -------------------------------------------------------------------------

run pack quad.ply -o y.plt --json x.json
run pack quad.ply -o x.plt --json -
same out x.json "--json - is the same on standard output"
same x.plt y.plt "... beside the same image"
"$PLANELET" pack quad.ply -o - --json x.json >out 2>err
same out x.plt "-o - with --json FILE is the image alone"
for name in - x.plt; do
    misused "-o $name --json $name is wrong usage" "two different files" \
        pack quad.ply -o $name --json $name
done
"$PLANELET" pack quad.ply -o - --json - 2>err | cat >out
verdict "... in a pipe, too" "$(
    grep -q 'two different files' err || cat err
    [ ! -s out ] || echo "something on standard output")"
$CC -std=c11 -Wall -Wextra "$CLI_TESTS/pty.c" -o pty 2>&1
./pty both "$PLANELET" pack quad.ply -o x.plt --json - >seen 2>out </dev/null
tr -d '\r' <seen | sed -n '/^{/,/^}/p' >x.json
verdict "it is text for a terminal" "$(
    [ "$(member .triangles)" = 2 ] || cat seen)"
rm -f x.plt
refused "without a place for it there is no image either" missing/x "create" \
    pack quad.ply -o x.plt --json missing/x
verdict "... nor anything half-written" "$(
    ls x.plt 2>/dev/null
    left_behind)"
finish
