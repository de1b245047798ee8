#!/bin/sh
# test_pack_files.sh - pack of standard input, and of several files
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin pack_files
quad quad.ply

# ---- standard input has one name ------------------------------------------------------

# One triangle without area, and vertices that single precision moves.
cat >lossy.obj <<'END'
v 5000.1 4500.3 100
v 5001.1 4500.3 100
v 5000.1 4500.7 101
f 1 2 3
f 1 1 2
END
# from_input ARGUMENT...: packs lossy.obj from standard input.
from_input() {
    "$PLANELET" pack - -o x.plt "$@" 2>err <lossy.obj
    status=$?
}
for flags in "" "--nodes compact" "--nodes compact --geometry float" "--weld 5"; do
    # shellcheck disable=SC2086
    from_input $flags
    verdict "pack - $flags: each line is about standard input" "$(
        [ "$status" -eq 0 ] || echo "status $status"
        [ "$(wc -l <err)" -ge 2 ] || echo "not two lines:"
        grep -v '^standard input: ' err)"
done
from_input
verdict "... also that triangles have no area" "$(
    grep -q '^standard input: 1 triangle has no area' err || cat err)"
from_input --nodes compact
verdict "... and the lattice's" "$(grep -q '^standard input: lattice of 16 bits' err || cat err)"
printf 'v 5e5 4500000.5 .1\nv 500001 4500000.5 .1\nv 5e5 4500000.5 1.7\nf 1 2 3\n' >far.obj
awk 'BEGIN { print "v 0 0 0\nv 1e9 0 0\nv 1e9 1 0"
    for (i = 0; i < 9; i++) print "f 1 2 3" }' >sliver.obj
for flags in "sliver.obj --reduce 1" "far.obj --nodes compact --geometry lattice:21" \
    "far.obj --origin 2e12,0,0"; do
    # shellcheck disable=SC2086
    "$PLANELET" pack - -o x.plt ${flags#* } 2>err <"${flags%% *}"
    status=$?
    verdict "pack - $flags: a failure is about it, too" "$(refusal "standard input" .)"
done

# ---- several files ----------------------------------------------------------------------

run make knot --triangles 8000 -o knot.ply
run make ground -o ground.ply
for flags in "--nodes compact" "--nodes compact --geometry lattice:12" "--nodes thesis"; do
    # shellcheck disable=SC2086
    run pack knot.ply ground.ply knot.ply -o plain.plt $flags
    # shellcheck disable=SC2086
    run pack knot.ply ground.ply knot.ply -o reduced.plt $flags --reduce 1000000000
    same plain.plt reduced.plt "pack $flags: --reduce that reduces nothing changes no byte"
done
run pack knot.ply ground.ply knot.ply -o reduced.plt --nodes compact --reduce 900
run info reduced.plt --json
verdict "... and one that does leaves no more than wanted" "$(
    [ "$(number triangles <out)" -le 900 ] || number triangles <out)"

# ---- before any work --------------------------------------------------------------------

misused "-o - and --json - are refused before anything is read" "two different files" \
    pack not-there.ply -o - --json -
verdict "nothing half-written is left" "$(left_behind)"
finish
