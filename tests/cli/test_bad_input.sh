#!/bin/sh
# test_bad_input.sh - meshes, images, recipes and rays that are not what they should be
#
# Every refusal is one line that names the file, the location and a remedy, with
# status 1, and leaves nothing behind. SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin bad_input
quad quad.ply
mkdir folder
: >empty
run make knot --triangles 500 -o knot.ply
run pack knot.ply -o knot.plt
echo '0 0 5 0 0 0 -1 100' | rays ray
echo old >old.plt

# ---- what no command accepts as a file ----------------------------------------

# nofile NAME WHERE WHAT: as a mesh, an image of three commands, and rays.
nofile() {
    refused "pack: $3" "$1" "$2" pack "$1" -o x.plt
    for source in map read; do
        refused "render --source $source: $3" "$1" "$2" render "$1" -o x.png --source $source
        refused "trace --source $source: $3" "$1" "$2" trace "$1" ray x.hits --source $source
    done
    refused "info: $3" "$1" "$2" info "$1"
    refused "trace, rays: $3" "$1" "$2" trace knot.plt "$1" x.hits
}
nofile missing "No such file" "a missing file"
nofile empty "is empty" "an empty file"
nofile folder "is a directory" "a folder"
nofile missing/knot "No such file" "a missing folder"
nofile knot.ply/knot "Not a directory" "a file as a folder"
nofile /dev/null "is \(a device\|not a regular file\)" "a device"
refused "pack: a file that cannot be read" /proc/self/mem "byte 0" pack /proc/self/mem -o x.plt
refused "trace, rays: a file that cannot be read" /proc/self/mem "byte 0" \
    trace knot.plt /proc/self/mem x.hits
cp knot.ply locked
chmod 000 locked
if [ -r locked ]; then
    echo "    not tried as root: a file without permission (test_base_input does)"
else
    nofile locked "ermission denied" "a file without permission"
fi
long=$(awk 'BEGIN { while (i++ < 250) printf "x" }')
refused "pack: a long missing name" "...$(echo "$long" | cut -c 51-250)" "No such file" \
    pack "$long" -o x.plt
hostile=$(printf 'a\nb\033[31m\177c')
refused "pack: a name with control characters" 'a?b?[31m?c' "No such file" pack "$hostile" -o x.plt
refused "info: a name with control characters" 'a?b?[31m?c' "No such file" info "$hostile"
refused "trace: a name with control characters" 'a?b?[31m?c' "No such file" \
    trace "$hostile" ray x.hits
verdict "an empty name is refused on one line" "$(
    for command in "pack @ -o x.plt" "render @ -o x.png" "info @" "trace @ ray x.hits" \
        "trace knot.plt @ x.hits"; do
        # shellcheck disable=SC2086
        set -- $command
        for word in "$@"; do
            shift
            [ "$word" = @ ] && word=
            set -- "$@" "$word"
        done
        run "$@"
        [ "$status" -eq 1 ] || echo "$command: status $status"
        one_line
        grep -q '^the [a-z]* has no name; give' err || cat err
    done)"

# ---- meshes --------------------------------------------------------------------

# mesh WHERE WHAT: refuses bad.ply.
mesh() {
    refused "pack: $2" bad.ply "$1" pack bad.ply -o old.plt
}
# edit SED_COMMAND
edit() {
    sed "$1" quad.ply >bad.ply
}
edit 's/^1 1 0$/1 nan 0/'
mesh "line 12, vertex 2" "a vertex of NaN"
run pack bad.ply -o x.plt --repair
verdict "... --repair drops all faces and says that nothing is left" "$(
    [ "$status" -eq 1 ] || echo "status $status"
    one_line
    grep -q '^bad.ply: 4 vertices, no faces but 2 that had to be dropped: nothing to trace; ' err ||
        cat err)"
edit 's/^1 0 0$/-inf 0 0/'
mesh "line 11, vertex 1" "an infinite vertex"
run pack bad.ply -o x.plt --repair
verdict "... --repair drops it and says so" "$(
    grep -q '^bad.ply: dropped 1 face that cannot be traced, 1 vertex that is not' err || cat err
    run info x.plt --json
    [ "$(number triangles <out)" = 1 ] || cat out)"
edit 's/^1 0 0$/1e30 0 0/'
mesh "line 11, vertex 1" "a vertex beyond the limit"
edit 's/^3 0 2 3$/3 0 2 4/'
mesh "line 15, face 1" "an index out of range"
run pack bad.ply -o x.plt --repair
verdict "... --repair drops it and says so" "$(
    grep -q '^bad.ply: dropped 1 face that cannot be traced$' err || cat err)"
edit 's/^3 0 2 3$/3 0 -1 3/'
mesh "line 15, face 1" "a negative index"
edit 's/vertex 4/vertex 4000000000/'
mesh "4000000000" "a vertex count that lies"
edit 's/face 2/face 3000000000/'
mesh "3000000000" "a face count that lies"
edit 's/vertex 4/vertex 99999999999999999999/'
mesh "line 3" "a count beyond all numbers"
edit 's/^3 0 2 3$/2000000000 0 2 3/'
mesh "line 15" "a list length that lies"
edit '$d'
mesh "line\|end\|cut short" "the last line missing"
edit 's/ascii/martian/'
mesh "line 2" "an unknown format"
edit 's/^end_header$/end/'
mesh "line" "a header without end"
echo hello >bad.ply
mesh "" "no mesh at all"
head -c 300 /dev/zero >bad.ply
mesh "" "zeros"

size=$(wc -c <knot.ply)
verdict "a binary mesh cut at 60 positions is refused each time" "$(
    i=0
    while [ $i -lt 60 ]; do
        head -c $((size * i / 60)) knot.ply >cut.ply
        run pack cut.ply -o old.plt
        refusal cut.ply "" || cat err
        i=$((i + 1))
    done)"
cat >bad.obj <<'END'
v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 9
END
refused "pack: an OBJ with an index out of range" bad.obj "line 4" pack bad.obj -o x.plt
printf 'solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n' >bad.stl
refused "pack: an STL that ends in a facet" bad.stl "line" pack bad.stl -o x.plt
head -c 100 /dev/zero >bad.stl
refused "pack: a binary STL that is too short" bad.stl "byte\|triangle\|short" \
    pack bad.stl -o x.plt
refused "pack: the second of two meshes" bad.stl "" pack quad.ply bad.stl -o x.plt

# ---- recipes -------------------------------------------------------------------

# recipe WHERE WHAT: refuses bad.txt, which is on standard input.
recipe() {
    cat >bad.txt
    refused "pack: $2" bad.txt "$1" pack bad.txt -o old.plt
}
echo 'quad.ply 1 0 0' | recipe "line 1" "a recipe's line without a position"
printf '# quads\n\nquad.ply one 0 0 0\n' | recipe "line 3" "a recipe's size that is no number"
printf 'quad.ply 1 0 0 0\nmissing.ply 1 0 0 0\n' | recipe "line 2.*missing.ply" \
    "a recipe's mesh that is missing"
printf 'quad.ply -1 0 0 0\n' | recipe "line 1" "a recipe's size below zero"
printf 'bad.txt 1 0 0 0\n' | recipe "line 1.*recipe" "a recipe in a recipe"
edit 's/^1 1 0$/1 nan 0/'
printf 'bad.ply 1 0 0 0\n' | recipe "line 1.*bad.ply.*line 12" "a recipe's mesh with NaN"

# ---- images --------------------------------------------------------------------

# image WHERE WHAT: every command refuses bad.plt.
image() {
    refused "info: $2" bad.plt "$1" info bad.plt
    for source in map read; do
        refused "render --source $source: $2" bad.plt "$1" render bad.plt -o x.png --source $source
        refused "trace --source $source: $2" bad.plt "$1" trace bad.plt ray x.hits --source $source
    done
}
size=$(wc -c <knot.plt)
cp knot.ply bad.plt
image "byte 0.*planelet pack" "a mesh for an image"
head -c 255 knot.plt >bad.plt
image "byte .*R" "an image shorter than its header"
head -c $((size - 1)) knot.plt >bad.plt
image "byte .*R6" "an image that lost its last byte"
{ cat knot.plt; echo; } >bad.plt
image "byte .*R6" "an image with a byte too many"
{ head -c 8 knot.plt; printf '\377\377'; tail -c +11 knot.plt; } >bad.plt
image "byte [0-9]" "an image of another version"
{ head -c $((size / 2)) knot.plt; printf 'damage'; tail -c +$((size / 2 + 7)) knot.plt; } >bad.plt
image "byte [0-9]" "an image with damage in its middle"
verdict "an image cut at 60 positions is refused each time" "$(
    i=0
    while [ $i -lt 60 ]; do
        head -c $((size * i / 60)) knot.plt >cut.plt
        for command in info "render -o x.png" "trace ray x.hits"; do
            # shellcheck disable=SC2086
            set -- $command
            name=$1
            shift
            run "$name" cut.plt "$@"
            refusal cut.plt "" || cat err
        done
        i=$((i + 1))
    done)"

# ---- rays ----------------------------------------------------------------------

head -c 31 ray >short
refused "trace: less than one ray" short "byte 0" trace knot.plt short x.hits
{ cat ray ray; printf x; } >long
refused "trace: a byte after the last ray" long "byte 64" trace knot.plt long x.hits
"$PLANELET" trace knot.plt - x.hits <short >out 2>err
status=$?
verdict "trace: less than one ray on standard input" "$(refusal "standard input" "byte 0")"

verdict "no refusal left a file, and the old output is as it was" "$(
    ls x.png x.hits 2>/dev/null
    left_behind
    [ "$(cat old.plt)" = old ] || echo "old.plt changed")"
finish
