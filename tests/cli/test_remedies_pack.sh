#!/bin/sh
# test_remedies_pack.sh - what messages about lattices, limits of a build and memory advise, helps
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/remedies.sh
top=$PWD
begin remedies_pack

# ---- lattices: host_tools/pack/lattice.c, cmd_pack.c --------------------------------------

printf 'v 0 0 0\nv 1e-31 0 0\nv 0 1e-31 0\nf 1 2 3\n' >small.obj
says "the mesh is too small for a lattice; scale it up" pack small.obj -o x.plt --nodes compact
echo 'small.obj 1 0 0 0' >small.txt
packs 1 small.txt --nodes compact
printf 'v 1000 0 0\nv 1001 0 0\nv 1000 1 0\nf 1 2 3\n' >far.obj
for remedy in 'far.obj --nodes compact --geometry lattice:12' 'far.obj --nodes thesis' \
    'near.obj --nodes compact --geometry lattice:18'; do
    says "a lattice of %u bits is finer than floats are that far from the origin; use fewer \
bits (--geometry lattice:N) or --nodes thesis, or move the mesh to the origin" \
        pack far.obj -o x.plt --nodes compact --geometry lattice:18
    sed 's/100\(.\)/\1/' far.obj >near.obj
    # shellcheck disable=SC2086
    packs 1 $remedy
done
{ # one triangle that 12 bits lose, and one that says how long the lattice is
    printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'
    printf 'v 0.5 0.5 0\nv 0.50005 0.5 0\nv 0.5 0.50005 0\nf 4 5 6\n'
} >detail.obj
run pack detail.obj -o x.plt --nodes compact --geometry lattice:12
message="; try --geometry lattice:21 to keep them"
said=$([ "$status" -eq 0 ] && grep -q " 1 triangles lost .*$message\$" err || cat err)
run pack detail.obj -o x.plt --nodes compact --geometry lattice:21
helped "$(grep -q ' 0 triangles lost' err || cat err)"

# ---- limits of a build: pack.c, pack_compact.c, host_tools/app/scene.c ----------------------

trouble=$(cd "$top" && BUILD=$(absolute "$BUILD") && $MAKE -s VARIANT=-small OPTIMISE=-O0 all \
    CFLAGS='-DPLT_PACKET_SIDE_MAX=4 -DPLT_DEPTH_MAX=8 -DPLT_GLOBAL_STACK_MAX=16' 2>&1 >/dev/null)
SMALL=${PLANELET%/host*/planelet}/host-small/planelet
[ -z "$trouble" ] && [ ! -x "$SMALL" ] && trouble="it is not $SMALL"
verdict "a planelet of small limits builds" "$trouble"
run make knot --triangles 500 -o knot.ply
triangles=$(head -n 20 knot.ply | sed -n 's/^element face //p')
PROGRAM=$SMALL
says "%zu triangles need more than %d levels; raise PLT_DEPTH_MAX or --leaf" \
    pack knot.ply -o x.plt --leaf 1
packs "$triangles" knot.ply --leaf 1 # by the build of larger limits
says "%zu triangles need more than %d levels; raise PLT_DEPTH_MAX or --leaf" \
    pack knot.ply -o x.plt --leaf 1
cured pack knot.ply -o x.plt --leaf 4
run make knot --triangles 900 -o knot.ply
triangles=$(head -n 20 knot.ply | sed -n 's/^element face //p')
for remedy in "$SMALL pack knot.ply --nodes compact --leaf 2" \
    "$PLANELET pack knot.ply --nodes compact --leaf 1"; do
    says "%u triangles need more than %d levels or 128 MiB; raise PLT_DEPTH_MAX or --leaf, or \
use --nodes thesis" pack knot.ply -o x.plt --nodes compact --leaf 1
    # shellcheck disable=SC2086
    cured_by $remedy -o x.plt
done
run pack knot.ply -o knot.plt --leaf 1
says "%s; build with a larger one (engine/planelet_config.h)" render knot.plt -o x.png
cured_by "$PLANELET" render knot.plt -o x.png
run make ground -o ground.ply
run pack ground.ply -o ground.plt
says "--packet %u: this build has packets of up to %d" render ground.plt -o x.png --packet 8
cured render ground.plt -o x.png --packet 4
cured_by "$PLANELET" render ground.plt -o x.png --packet 8
PROGRAM=

# ---- memory -----------------------------------------------------------------------------

run make knot --triangles 1000 -o part.ply
run make knot --triangles 100000 -o large.ply
grown "$PLANELET" pack large.ply -o x.plt
larger "%llu bytes do not fit into memory; split the file or use a larger machine"
larger "%zu triangles: out of memory; pack on a larger machine"
smaller "%llu bytes do not fit into memory; split the file or use a larger machine" \
    pack part.ply -o x.plt
smaller "out of memory at triangle %zu; split the mesh" pack part.ply -o x.plt
grown "$PLANELET" pack large.ply -o x.plt --nodes compact
larger "%zu triangles: out of memory; pack on a larger machine"
larger "out of memory; pack on a larger machine"
{ # a million vertices, of which three are used
    printf 'ply\nformat binary_little_endian 1.0\nelement vertex 1000000\nproperty float x\n'
    printf 'property float y\nproperty float z\nelement face 2\n'
    printf 'property list uchar uchar vertex_indices\nend_header\n'
    echo '0 0 0 1 0 0 0 1' | rays one.ray
    cat one.ray
    head -c 11999968 /dev/zero
    printf '\3\0\1\2\3\0\1\2'
} >vertices.ply
grown "$PLANELET" pack vertices.ply -o x.plt --reduce 1
larger "out of memory while reducing; use a larger machine"
smaller "out of memory at vertex %zu; split the mesh" pack part.ply -o x.plt
grown "$PLANELET" render ground.plt -o x.png --size 2000x2000
smaller "picture of %u x %u pixels: out of memory; choose a smaller size" \
    render ground.plt -o x.png --size 64x48
for remedy in '-o x.ppm --size 2000x2000' '-o x.png --size 1000x1000'; do
    # shellcheck disable=SC2086
    smaller "PNG of %u x %u pixels: out of memory; write .ppm, which needs none, or a \
smaller picture" render ground.plt $remedy
done
finish
