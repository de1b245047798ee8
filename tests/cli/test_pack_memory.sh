#!/bin/sh
# test_pack_memory.sh - pack says what memory it takes, keeps to --memory, and to what it said
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin pack_memory
run make terrain --triangles 200000 -o terrain.ply
run make knot --triangles 3000 -o knot.ply

# packed FLAG...: of the terrain, into open.plt and its figures into `needed` and `peak`.
packed() {
    run pack terrain.ply -o open.plt --json open.json "$@"
    needed=$(number memory_bytes_needed <open.json)
    peak=$(number memory_peak_bytes <open.json)
    cp err open.err
}
# like_open: trouble, unless the last run gave the same image and said the same.
like_open() {
    [ "$status" -eq 0 ] || echo "status $status"
    cmp open.plt x.plt
    cmp open.err err
}

# The address space that a program takes which does nothing, in KiB.
base=4096
while ! (ulimit -v $base && exec "$PLANELET" --version) >/dev/null 2>&1; do
    base=$((base + 1024))
    [ $base -lt 1048576 ] || break
done
has=$(ulimit -v)

for flags in "" "--leaf 1" "--build device" "--nodes compact --geometry lattice:14" \
    "--nodes compact --geometry lattice:14 --leaf 4 --numbers none" \
    "--nodes compact --geometry float" "--nodes compact --build device"; do
    # shellcheck disable=SC2086
    packed $flags
    verdict "pack $flags: it takes what it needs, at most, and half of it at least" "$(
        [ "${peak:-0}" -gt 0 ] && [ "$peak" -le "${needed:-0}" ] &&
            [ "$needed" -le $((2 * peak)) ] ||
            echo "$peak of $needed bytes")"
    # shellcheck disable=SC2086
    run pack terrain.ply -o x.plt --json x.json --memory "$needed" $flags
    verdict "... with --memory of that, the image is the same" "$(
        like_open
        cmp open.json x.json)"
    if [ $base -ge 1048576 ] || [ "$has" != unlimited ]; then
        echo "    not tried: in an address space of that"
    else
        # Beside it a stack, and what the C library takes in advance.
        # shellcheck disable=SC2086
        (ulimit -v $((base + needed / 1024 + 2048)) &&
            exec "$PLANELET" pack terrain.ply -o x.plt $flags) >out 2>err
        status=$?
        verdict "... and in an address space of that beside the program's own" "$(like_open)"
    fi
    # shellcheck disable=SC2086
    run pack terrain.ply -o y.plt --memory "$((peak / 2))" $flags
    verdict "... in half of it, it is refused, with a remedy" "$(
        refusal terrain.ply "use --memory [0-9]"
        [ ! -e y.plt ] || echo "an image")"
    enough=$(sed -n 's/.*; use --memory \([0-9]*\).*/\1/p' err)
    # shellcheck disable=SC2086
    run pack terrain.ply -o x.plt --memory "${enough:-1048576}" $flags
    verdict "... which helps" "$(
        [ "$status" -eq 0 ] || cat err
        cmp open.plt x.plt)"
done

# Triangles that share no vertex have more edges than anything else.
awk 'BEGIN {
    for (i = 0; i < 11000; i++) {
        x = i % 40; y = int(i / 40) % 40; z = int(i / 1600)
        printf "v %d %d %d\nv %d.5 %d %d\nv %d %d.5 %d\nf -3 -2 -1\n", x, y, z, x, y, z, x, y, z
    }
}' >soup.obj
run pack soup.obj -o open.plt --build device --json open.json
less=$(number memory_bytes_needed <open.json)
: >err
while [ "$status" -eq 0 ] && ! grep -q 'not looked at' err; do
    less=$((less - 16384))
    run pack soup.obj -o x.plt --build device --json x.json --memory $less
done
verdict "open edges are not looked for where memory is short, and pack says so" "$(
    [ "$status" -eq 0 ] || cat err
    grep -q '^soup.obj: not looked at for holes and seams; use a larger --memory' err || cat err
    grep -q '"open_edges": null' x.json || echo "JSON counts edges"
    cmp open.plt x.plt)"

run pack terrain.ply -o y.plt --memory 1048576
verdict "a file that does not fit is refused before it is read" "$(
    refusal terrain.ply "reading it takes more than the 1048576 bytes that --memory gives")"
run pack knot.ply terrain.ply -o y.plt --memory 1048576
verdict "... and the one that is named is the one that does not" "$(
    refusal terrain.ply "reading it takes more")"
works "a small mesh is packed in 1 MiB" pack knot.ply -o x.plt --memory 1048576
run pack knot.ply -o open.plt
same open.plt x.plt "... the same"
run pack knot.ply -o open.plt --quality high --nodes compact
run pack knot.ply -o x.plt --quality high --nodes compact --memory 1048576
verdict "a better tree of it as well" "$([ "$status" -eq 0 ] || cat err
    cmp open.plt x.plt)"
finish
