#!/bin/sh
# test_remedies_mesh.sh - what messages about meshes and recipes advise, helps
#
# Each file is a good one with one mistake; the remedy is done to the bad one, and what is
# left has as many triangles as it should. SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/remedies.sh
begin remedies_mesh
quad quad.ply

# bad FILE SED_COMMAND: FILE with a mistake, as bad.ply, bad.obj, bad.stl or bad.txt.
bad() {
    file=bad.${1##*.}
    sed "$2" "$1" >"$file"
}
# edit SED_COMMAND: the remedy is done to that file.
edit() {
    sed "$1" "$file" >edited
    mv edited "$file"
}
# refused_as MESSAGE: pack refuses the file.
refused_as() {
    says "$1" pack "$file" -o x.plt
}
# mended SED_COMMAND: after this remedy the file is packed, both triangles.
mended() {
    edit "$1"
    packs 2 "$file"
}
# again: the file is got again, whole.
again() {
    cp "$1" "$file"
    packs 2 "$file"
}

# ---- vertices and faces of any format: intake.c ---------------------------------------------

for wrong in 's/^1 0 0$/1 nan 0/' 's/^1 0 0$/-inf 0 0/' 's/^1 0 0$/1e30 0 0/'; do
    bad quad.ply "$wrong"
    refused_as "the vertex (%g %g %g) is not finite or beyond +-2^40; correct it or its unit, or \
use pack --repair to drop it"
    packs 1 bad.ply --repair
    mended 's/^1 nan 0$/1 1 0/; s/^-inf 0 0$/1 0 0/; s/^1e30 0 0$/1 0 0/'
done
for wrong in 's/^3 0 2 3$/3 0 2 4/' 's/^3 0 2 3$/3 0 -1 3/'; do
    bad quad.ply "$wrong"
    refused_as "uses vertex %lld, which is not among the %llu vertices; use pack --repair to \
drop it"
    packs 1 bad.ply --repair
done

# ---- PLY: ply_header.c ----------------------------------------------------------------------

bad quad.ply 's/^format.*/&\nformat binary_little_endian 1.0/'
refused_as "line %zu: a second format; remove one"
mended '/^format binary/d'
for format in ascii binary_little_endian binary_big_endian; do
    bad quad.ply 's/^format.*/format text 1.0/'
    refused_as "line %zu: unknown format '%.*s %.*s'; write it as ascii, binary_little_endian or \
binary_big_endian 1.0"
    {
        sed -n "s/^format.*/format $format 1.0/; 1,/^end_header/p" bad.ply
        case $format in
        ascii) sed '1,/^end_header/d' bad.ply ;;
        *little*)
            echo '0 0 0 1 0 0 1 1' | rays part && cat part
            echo '0 0 1 0 0 0 0 0' | rays part && head -c 16 part
            printf '\3\0\0\0\0\1\0\0\0\2\0\0\0\3\0\0\0\0\2\0\0\0\3\0\0\0'
            ;;
        *)
            one='\077\200\0\0' zero='\0\0\0\0'
            # shellcheck disable=SC2059
            printf "$zero$zero$zero$one$zero$zero$one$one$zero$zero$one$zero"
            printf '\3\0\0\0\0\0\0\0\1\0\0\0\2\3\0\0\0\0\0\0\0\2\0\0\0\3'
            ;;
        esac
    } >edited
    mv edited bad.ply
    packs 2 bad.ply
done
bad quad.ply 's/^element vertex 4/element vertex/'
refused_as "line %zu: element '%.*s' has no count; write one"
mended 's/^element vertex$/& 4/'
bad quad.ply 's/^element face 2/element vertex 0\n&/'
refused_as "line %zu: a second element '%.*s'; rename one"
mended 's/^element vertex 0/element nothing 0/'
elements=$(awk 'BEGIN { while (i++ < 31) printf "element e%d 0\\n", i }')
bad quad.ply "s/^element face 2/$elements&/"
refused_as "line %zu: more than %d elements; remove some"
mended '/^element e[12]/d'
bad quad.ply 's/^property float y/property fraction y/'
refused_as "line %zu: unknown type '%.*s'; use one from char to double"
for type in char uchar short ushort int uint float double int8 uint8 int16 uint16 int32 uint32 \
    float32 float64; do
    sed "s/^property fraction y/property $type y/" bad.ply >good.ply
    packs 2 good.ply
done
bad quad.ply 's/list uchar/list float/'
refused_as "line %zu: a list counted in fractions; use an integer type"
mended 's/list float/list int/'
bad quad.ply 's/^element vertex 4/property float w\n&/'
refused_as "line %zu: a property before any element; reorder the header"
mended '/^property float w/d; s/^element face 2/property float w\n&/; s/^[01] [01] 0$/& 5/'
properties=$(awk 'BEGIN { while (i++ < 1021) printf "property uchar p%d\\n", i }')
bad quad.ply "s/^element face 2/element none 0\\n$properties&/"
refused_as "line %zu: more than %d properties; remove some"
mended '/^property uchar p[12]/d'
bad quad.ply 's/^property float y/property float/'
refused_as "line %zu: a property without a name; write one"
mended 's/^property float$/& y/'
bad quad.ply 's/^property float y/property double x\n&/; s/^[01] [01] 0$/& 5/'
refused_as "line %zu: a second property '%.*s'; rename one"
mended 's/^property float z/property float w/; s/^property double x/property double z/'
bad quad.ply 's/^property float y/propperty float y/'
refused_as "line %zu: '%.*s' in the header looks like a misspelt keyword; correct it, or make the \
line a comment"
mended 's/^propperty/property/'
bad quad.ply 's/^element face 2/formerly in two parts\n&/'
refused_as "line %zu: '%.*s' in the header looks like a misspelt keyword; correct it, or make the \
line a comment"
mended 's/^formerly/comment &/'
bad quad.ply 's/^element face 2/& faces/'
refused_as "line %zu: more words than expected; remove them"
mended 's/ faces$//'
bad quad.ply 's/^end_header/& here/'
refused_as "line %zu: words after end_header; remove them"
mended 's/ here$//'
bad quad.ply '/^end_header/,$d'
refused_as "line %zu: the header has no end_header; the file is cut short: get it again"
again quad.ply
bad quad.ply '/^format/d'
refused_as "line %zu: the header names no format; add one"
mended 's/^ply$/&\nformat ascii 1.0/'
bad quad.ply '/^0 0 0/,$d'
refused_as "line %zu: %llu elements '%.*s' need at least %zu bytes each, but %zu bytes follow the \
header; the file is cut short: get it again"
again quad.ply
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n' >quad.obj
file=bad.ply
cp quad.obj bad.ply
refused_as "line 1: does not begin with 'ply'; give it the name of its true format"
mv bad.ply named.obj
packs 2 named.obj

# ---- PLY: ply.c, ply_value.c -------------------------------------------------------------------

bad quad.ply 's/^1 1 0$/1 1 0 7/'
refused_as "more values on the line than the header declares; correct the line or the header"
mended 's/^1 1 0 7$/1 1 0/'
bad quad.ply 's/^\([01] [01] 0\)$/\1 7/'
refused_as "more values on the line than the header declares; correct the line or the header"
mended 's/^element face 2/property uchar weight\n&/'
bad quad.ply 's/^property float z/property float height/'
refused_as "line %zu: the vertices lack x, y or z; add them"
mended 's/^property float height/property float z/'
bad quad.ply 's/vertex_indices/corners/'
refused_as "line %zu: '%.*s' has no list vertex_indices; rename one"
mended 's/corners/vertex_indices/'
bad quad.ply 's/^1 1 0$/1 1/'
refused_as "fewer values than the header declares for a vertex; correct the header or the lines"
mended 's/^1 1$/& 0/'
for remedy in '/^property float w/d' 's/^[01] [01] 0$/& 5/'; do
    bad quad.ply 's/^element face 2/property float w\n&/'
    refused_as "fewer values than the header declares for a vertex; correct the header or the lines"
    mended "$remedy"
done
bad quad.ply '$s/ 3$//'
refused_as "the file ends inside it; get it again"
again quad.ply
for wrong in 's/^1 1 0$/1 one 0/' 's/^3 0 2 3$/3 0 two 3/' 's/^3 0 2 3$/3 0 2.5 3/'; do
    bad quad.ply "$wrong"
    refused_as "'%.*s' where a %snumber belongs; correct it"
    mended 's/one/1/; s/two/2/; s/2\.5/2/'
done
bad quad.ply 's/^3 0 2 3$/3000000 0 2 3/'
refused_as "a list of %lld values, but %zu bytes follow; the file is damaged: get it again"
again quad.ply

# ---- PLY: ply_body.c -----------------------------------------------------------------------------

# Doubles under a header that says float: six vertices, eight triangles.
{
    sed -n '1,/^end_header/s/ascii/binary_little_endian/; s/vertex 4/vertex 6/; s/face 2/face 8/
        1,/^end_header/p' quad.ply
    head -c 144 /dev/zero
    for i in 1 2 3 4 5 6 7 8; do printf '\3\0\0\0\0\1\0\0\0\2\0\0\0'; done
} >bad.ply
message="line %zu: the body does not fit the types of the header, by which a vertex takes %llu \
bytes: it takes %llu; write the mesh as ASCII PLY or OBJ"
for remedy in quad.ply quad.obj; do
    says "$message" pack bad.ply -o x.plt
    packs 2 $remedy
done

# ---- what pack says beside its work: report.c, pack_lines.c, pack_meshes.c -----------------------

# warns MESSAGE ARGUMENT...: pack succeeds, and one of its lines is that message.
warns() {
    message=$1
    shift
    "$PLANELET" pack "$@" -o x.plt >out 2>err </dev/null
    status=$?
    said=$(
        [ "$status" -eq 0 ] || echo "status $status"
        grep -q -- "$(pattern "$message")\$" err || { echo "not said:"; cat err; })
}
# quiet ARGUMENT...: pack succeeds without that message, the remedy.
quiet() {
    "$PLANELET" pack "$@" -o x.plt >out 2>err </dev/null
    status=$?
    helped "$(grep -- "$(pattern "$message")" err)"
}
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 3 2 4\n' >crossed.obj
warns "%llu face%s cross%s %s, and no triangles fill %s without overlap; cut %s into triangles \
where %s made" crossed.obj
quiet quad.obj
printf 'v %s.1 4500000.3 0\n' 500000 500001 500002 >far.obj
printf 'v 500001.1 4500000.7 1\nf 1 2 4\nf 2 3 4\n' >>far.obj
warns "use pack --centre to move the mesh to the origin first" far.obj
quiet far.obj --centre
echo 'far.obj 10 0 0 0' >far.txt
warns "single precision moved corners by up to %.2g of an edge before their meshes were placed, \
and %llu triangle%s lost an edge; use pack --centre to place them first" far.txt
quiet far.txt --centre
printf 'v %s.1 4500000.3 0\n' 500000 500001 >part.obj
printf 'v 500001.1 4500000.7 1\nf 1 2 3\n' >>part.obj
{ cat part.obj; printf 'v 0.1 0 0\nv 1.2 0 0\nv 0 1.3 0\nf 4 5 6\n'; } >wide.obj
warns "the mesh is too large for its smallest parts: pack these apart, with --centre" wide.obj
quiet part.obj --centre
seams seams.stl
warns "%llu open edge%s, some of which all but meet; use pack --weld %.0e to close %llu" seams.stl
# shellcheck disable=SC2046
quiet seams.stl $(sed -n 's/.*use pack \(--weld [^ ]*\) .*/\1/p' err)
verdict "... and no edge is open any more" "$(grep 'open edge' err)"
sed '/^f/d' quad.obj >bad.obj
file=bad.obj
refused_as "write it with its faces; points need a surface first"
again quad.obj
printf 'o nothing\n' >bad.obj
refused_as "check that the right objects were exported"
again quad.obj
sed 's/^v 0 0 0/v nan 0 0/' quad.obj >bad.obj
says "mend them in the program that wrote them" pack bad.obj -o x.plt --repair
again quad.obj

# ---- where a mesh is, and how much is left of it: precision.c, reduce.c --------------------------

says "moved by --origin it reaches beyond +-2^40; use --centre" \
    pack quad.obj -o x.plt --origin 2e12,0,0
packs 2 quad.obj --centre
printf 'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 1 2\nf 2 2 3\n' >flat.obj
says "none of its %zu triangles has an area; leave out --reduce" pack flat.obj -o x.plt --reduce 1
packs 2 flat.obj
run make knot --triangles 500 -o knot.ply
says "--reduce %zu leaves none of its %zu triangles: their corners fall together; use --reduce %zu \
or more" pack knot.ply -o x.plt --reduce 1
# shellcheck disable=SC2046
cured pack knot.ply -o x.plt $(sed -n 's/.*use \(--reduce [0-9]*\) or more$/\1/p' err)

# ---- OBJ: obj.c, mesh_single.c ------------------------------------------------------------------

bad quad.obj 's/^v 1 1 0/v 1 1/'
refused_as "a coordinate is missing; correct the line"
mended 's/^v 1 1$/& 0/'
bad quad.obj 's/^v 1 1 0/v 1 one 0/'
refused_as "'%.*s' where a coordinate belongs; correct the line"
mended 's/one/1/'
bad quad.obj 's/^f 1 3 4/f 1 3 four/'
refused_as "'%.*s' where a vertex number belongs; correct the line"
mended 's/four/4/'
{ printf '\1\2\n'; cat quad.obj; } >bad.obj
file=bad.obj
refused_as "'%.*s' is no text; check that this is an OBJ file"
again quad.obj
echo 'quad.ply 1 0 0 0' >bad.obj
refused_as "no line up to here is one of OBJ; check the file's format"
mv bad.obj recipe.txt
packs 2 recipe.txt
printf '4 vertices\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 triangles\n0 1 2\n0 2 3\n' >own.mesh
says "is neither PLY nor OBJ nor STL, and no .txt recipe; convert it" pack own.mesh -o x.plt
awk '/triangles/ { faces = 1 }
    NF == 3 && !faces { print "v", $0 }
    NF == 3 && faces { print "f", $1 + 1, $2 + 1, $3 + 1 }' own.mesh >converted.obj
packs 2 converted.obj

# ---- STL: stl.c ---------------------------------------------------------------------------------

{
    head -c 80 /dev/zero
    printf '\2\0\0\0'
    echo '0 0 1 0 0 0 1 0' | rays part && cat part
    echo '0 1 1 0 0 0 0 0' | rays part && head -c 16 part
    printf '\0\0'
    echo '0 0 1 0 0 0 1 1' | rays part && cat part
    echo '0 0 1 0 0 0 0 0' | rays part && head -c 16 part
    printf '\0\0'
} >quad.stl
{
    echo solid quad
    for corners in '0 0 0,1 0 0,1 1 0' '0 0 0,1 1 0,0 1 0'; do
        echo "facet normal 0 0 1,outer loop,$corners,endloop,endfacet" | tr , '\n' |
            sed 's/^[01]/vertex &/'
    done
    echo endsolid quad
} >text.stl
file=bad.stl
head -c 50 quad.stl >bad.stl
refused_as "byte %zu: ends inside the %d byte header of a binary STL; get it again"
again quad.stl
head -c 160 quad.stl >bad.stl
refused_as "byte 80: %llu triangles take %llu bytes, but the file has %zu; it is cut short or no \
STL: get it again"
again quad.stl
for remedy in remove repair; do
    { cat quad.stl; echo by hand; } >bad.stl
    refused_as "byte %llu: %llu bytes more than the triangle count at byte 80 says; remove them or \
use pack --repair to ignore them"
    if [ $remedy = repair ]; then
        packs 2 bad.stl --repair
    else
        head -c "$(sed 's/.*: byte \([0-9]*\): .*/\1/' err)" bad.stl >shorter.stl
        packs 2 shorter.stl
    fi
done
bad text.stl '12,$d'
refused_as "the file ends where '%s' belongs; get it again"
again text.stl
bad text.stl 's/outer loop/loop/'
refused_as "'%.*s' where '%s' belongs; correct it"
mended 's/^loop/outer loop/'

bad text.stl '4d'
refused_as "a face of %llu corners; use pack --repair to drop it"
packs 1 bad.stl --repair

# ---- recipes: recipe.c, placement.c -------------------------------------------------------------

for frame in 000 001 002; do
    cp quad.ply "q_$frame.ply"
done
# recipe LINE: a recipe of it, bad.txt.
recipe() {
    file=bad.txt
    echo "$1" >bad.txt
}
recipe 'q_{}.ply*0 1 0 0 0'
refused_as "'*' needs the number of frames after it; write 1 to 1000"
mended 's/\*0/*1/'
mended 's/\*1/*1000/'
recipe 'q_{}.ply*3+x 1 0 0 0'
refused_as "'+' needs the first frame after it; write a whole number from 0"
mended 's/+x/+0/'
says "has no sequence, so no frame %u; leave out --frame, or pack a recipe that has one" \
    pack quad.ply --frame 2 -o cured.plt
packs 2 quad.ply
packs 2 bad.txt --frame 2
says "has no sequence, so no frames; leave out --frame(s), or name files with a '{}'" \
    make mesh quad.ply --frames 2 -o 'cured_{}.ply'
cured make mesh quad.ply -o cured.ply
cured make mesh 'q_{}.ply' --frames 2 -o 'cured_{}.ply'
cured make mesh bad.txt --frames 2 -o 'cured_{}.ply'
for wrong in 'q_{}.ply' 'q.ply*3'; do
    recipe "$wrong 1 0 0 0"
    refused_as "a sequence has both {} and *N; write name_{}.ply*N"
    mended 's/[^ ]*/q_{}.ply*3/'
done
file=bad.txt
printf 'quad\0.ply 1 0 0 0\n' >bad.txt
refused_as "the file name holds a zero byte; correct it"
tr -d '\000' <bad.txt >edited
mv edited bad.txt
packs 2 bad.txt
for wrong in 'quad.ply' 'quad.ply 1 0 0' 'quad.ply one 0 0 0'; do
    recipe "$wrong"
    refused_as "a size and a position are missing; write FILE SIZE X Y Z"
    mended 's/ .*//; s/$/ 1 0 0 0/'
done
recipe 'quad.ply -1 0 0 0'
refused_as "the size is not above 0; correct it"
mended 's/-1/1/'
recipe 'quad.ply 1 0 0 0 45 90 90'
refused_as "only two angles may follow FILE SIZE X Y Z; correct them"
mended 's/ 90$//'
recipe '- 1 0 0 0'
refused_as "is standard input; name a file"
mended 's/^-/quad.ply/'
echo 'quad.ply 1 0 0 0' >inner.txt
recipe 'inner.txt 1 0 0 0'
refused_as "is a recipe inside a recipe; write its lines there"
cp inner.txt bad.txt
packs 2 bad.txt
printf 'v 1 1 1\nf 1 1 1\n' >point.obj
printf 'point.obj 1 0 0 0\nquad.ply 1 0 0 0\n' >bad.txt
refused_as "has no extent to scale; leave it out"
mended '/^point/d'
recipe 'quad.ply 1 0 2e12 0'
refused_as "its position is beyond +-2^40; choose smaller numbers"
mended 's/2e12/1e12/'

# ---- memory -------------------------------------------------------------------------------------

awk 'BEGIN {
    print "solid"
    for (i = 0; i < 60000; i++) {
        printf "facet normal 0 0 1 outer loop vertex %d 0 0 vertex %d 1 0 vertex %d 0 1", i, i, i
        print " endloop endfacet"
    }
    print "endsolid"
}' >large.stl
grown "$PLANELET" pack large.stl -o x.plt
smaller "out of memory; split the mesh" pack quad.stl -o x.plt
finish
