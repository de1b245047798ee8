#!/bin/sh
# test_bad_output.sh - outputs that cannot be written: whole files or none, and old
# ones survive whatever ends a command
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin bad_output
quad quad.ply
run make knot --triangles 500 -o knot.ply
run pack knot.ply -o knot.plt
echo '0 0 5 0 0 0 -1 100' | rays ray
mkdir folder full
echo file >file

# everywhere NAME WHERE WHAT: every command's output with that name. (A device gets
# its bytes only when all are there; until then the other output may be finished.)
everywhere() {
    refused "make: $3" "$1" "$2" make ground -o "$1"
    refused "pack: $3" "$1" "$2" pack quad.ply -o "$1"
    refused "trace: $3" "$1" "$2" trace knot.plt ray "$1"
    refused "trace --json: $3" "$1" "$2" trace knot.plt ray x.hits --json "$1"
    refused "render --json: $3" "$1" "$2" render knot.plt -o x.png --size 8x8 --json "$1"
    for ending in png ppm y4m; do
        refused "render to .$ending: $3" "$1.$ending" "$2" \
            render knot.plt --size 8x8 -o "$1.$ending"
    done
    verdict "... and nothing half-written is left" "$(
        left_behind
        [ -h "$1" ] || ls x.hits x.png 2>/dev/null)"
    rm -f x.hits x.png
}
everywhere missing/x "No such file.*create the directory" "a missing folder"
for ending in png ppm y4m; do
    mkdir folder.$ending
done
everywhere folder "is a directory" "a folder"
everywhere file/x "Not a directory" "a file as a folder"
everywhere /proc/x "/proc/x" "a folder in which nothing can be created"
mkdir locked
chmod 555 locked
echo old >protected.plt
chmod 444 protected.plt
if [ -w protected.plt ]; then
    echo "    not tried as root: folders and files without permission (test_base_output does)"
else
    everywhere locked/x "ermission denied" "a folder without permission"
    refused "pack: a write-protected file" protected.plt "write-protected" \
        pack quad.ply -o protected.plt
fi

# ---- a full disk -----------------------------------------------------------------

verdict "there is a /dev/full" "$([ -c /dev/full ] || echo "no such device")"
for name in full/x full/x.png full/x.ppm full/x.y4m; do
    ln -s /dev/full "$name"
done
everywhere full/x "No space left" "a full disk"
for command in --help --version "info knot.plt" "info knot.plt --json" "render --help" \
    "render knot.plt --show" "make ground -o -" "pack quad.ply -o -" "trace knot.plt ray -" \
    "render knot.plt -o -" "render knot.plt -o - --orbit 2" "render knot.plt --json -"; do
    # shellcheck disable=SC2086
    "$PLANELET" $command >/dev/full 2>err
    status=$?
    verdict "$command >/dev/full" "$(refusal "standard output" "")"
done
# A file of at most 512 bytes stands in for a disk that fills up.
run render knot.plt --size 64x64 -o old.ppm
cp old.ppm before.ppm
for command in "make marbles -o old.ppm" "pack knot.ply -o old.ppm" \
    "render knot.plt --size 99x99 -o old.ppm" \
    "render knot.plt --size 99x99 -o new.y4m --orbit 5"; do
    # shellcheck disable=SC2086
    (ulimit -f 1 && "$PLANELET" $command 2>err)
    status=$?
    name=${command##*-o }
    verdict "$command, when the disk fills up" "$(
        refusal "${name%% *}" "cannot write"
        cmp old.ppm before.ppm 2>&1
        ls new.y4m 2>/dev/null
        left_behind)"
done
"$PLANELET" render knot.plt -o - >&- 2>err
status=$?
verdict "standard output that is closed" "$(refusal "standard output" "")"

# ---- old outputs -----------------------------------------------------------------

echo old >old
refused "pack a broken mesh over an old image" file "" pack file -o old
refused "trace a broken image over old hits" file "" trace file ray old
refused "trace in too small an arena over old hits" knot.plt "arena" \
    trace knot.plt ray old --arena 100
refused "render statistics into a missing folder" missing/x "" \
    render knot.plt -o before.ppm --json missing/x
verdict "the old outputs are as they were" "$(
    [ "$(cat old)" = old ] || echo "old changed"
    cmp old.ppm before.ppm 2>&1
    left_behind)"
echo old >target
chmod 640 target
ln -s target link
works "pack through a symbolic link" pack quad.ply -o link
verdict "... keeps the link and the mode, and replaces the file" "$(
    [ -h link ] || echo "no link any more"
    run info target
    cat err
    ls -l target | grep -q '^-rw-r-----' || ls -l target)"

# ---- killed ----------------------------------------------------------------------

# killed NAME SIGNAL STATUS COMMAND...: ends it once its temporary file is there.
killed() {
    name=$1 signal=$2 expected=$3
    shift 3
    echo old >"$name"
    "$PLANELET" "$@" >out 2>err &
    process=$!
    tries=0
    until ls -a | grep -q '^\.planelet-' || ! kill -0 $process 2>/dev/null; do
        tries=$((tries + 1))
        [ $tries -lt 100000 ] || break
    done
    kill -s "$signal" $process 2>/dev/null
    wait $process 2>/dev/null
    status=$?
    verdict "$1 ended by $signal leaves the old output and nothing else" "$(
        [ "$status" -eq "$expected" ] || echo "status $status"
        [ "$(cat "$name")" = old ] || echo "the old output changed"
        cat err
        left_behind)"
}
run make terrain --triangles 400000 -o big.ply
mkfifo nobody.reads
run pack quad.ply -o none.plt --build none
for end in TERM:143 HUP:129 ALRM:142; do
    killed old.plt "${end%:*}" "${end#*:}" pack quad.ply -o old.plt \
        --json nobody.reads
    killed old.y4m "${end%:*}" "${end#*:}" render knot.plt -o old.y4m --orbit 2000
    killed old.hits "${end%:*}" "${end#*:}" trace knot.plt ray old.hits --repeat 1000000
done
killed old.ply TERM 143 make terrain --triangles 5000000 -o old.ply
"$PLANELET" pack big.ply -o - 2>err | head -c 1 >/dev/null
verdict "a reader that goes away ends pack without a word" "$(cat err)"
rm -f big.ply out
finish
