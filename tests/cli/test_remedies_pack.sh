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
says "the mesh is too small for a lattice; scale it up: pack a text file, scene.txt, with the line \
FILE 1 0 0 0, which makes it 1 long" pack small.obj -o x.plt --nodes compact
echo 'small.obj 1 0 0 0' >scene.txt
packs 1 scene.txt --nodes compact
# far FROM FILE: a triangle of 1 that is so far from the origin, on no coarse grid.
far() {
    printf 'v %s.1 0 0\nv %s.3 0.1 0\nv %s.7 1.3 0\nf 1 2 3\n' "$1" "$1" "$1" >"$2"
}
far 1000 far.obj
far 1000000 farthest.obj
# scattered FROM FILE: 4000 triangles anywhere in a cube of 1 from FROM on.
scattered() {
    awk -v from="$1" 'BEGIN {
        srand(1)
        printf "v %g %g %g\nv %g %g %g\n", from, from, from, from + 1, from + 1, from + 1
        printf "v %g %g %g\nf 1 2 3\n", from, from, from + 1
        for (i = 1; i < 4000; i++) {
            for (k = 0; k < 3; k++) {
                printf "v %.9g %.9g %.9g\n", from + rand(), from + rand(), from + rand()
            }
            print "f -1 -2 -3"
        }
    }' >"$2"
}
scattered 4 near.obj
scattered -0.5 centred.obj
# shellcheck disable=SC2046,SC2086
{
    for remedy in '--nodes compact --geometry lattice:18 --centre' '--nodes thesis' named; do
        says "a lattice of %u bits is finer than floats are that far from the origin; use \
--centre, --nodes thesis, or fewer bits (--geometry lattice:%u)" \
            pack far.obj -o x.plt --nodes compact --geometry lattice:18
        [ "$remedy" != named ] ||
            remedy="--nodes compact $(sed 's/.*(\(--geometry lattice:[0-9]*\))$/\1/' err)"
        packs 1 far.obj $remedy
    done
    for remedy in '--nodes compact --tolerance 1e-5 --centre' '--nodes thesis' \
        '--nodes compact --tolerance 1e-3'; do
        says "a lattice of %u bits is finer than floats are that far from the origin; use \
--centre, --nodes thesis, or a larger --tolerance" \
            pack far.obj -o x.plt --nodes compact --tolerance 1e-5
        packs 1 far.obj $remedy
    done
    for remedy in '--nodes compact --centre' '--nodes thesis'; do
        says "a lattice of %u bits is finer than floats are that far from the origin; use --centre \
or --nodes thesis" pack farthest.obj -o x.plt --nodes compact
        packs 1 farthest.obj $remedy
    done
    for remedy in '--tolerance 1e-6' '--tolerance 5.3e-7 --centre' '--geometry float'; do
        says "no lattice keeps --tolerance %g there, but %.2g; use a larger one, --centre, or \
--geometry float" pack near.obj -o x.plt --nodes compact --tolerance 5.3e-7
        packs 4000 near.obj --nodes compact $remedy
    done
    for remedy in '--tolerance 1e-6 --step power' '--tolerance 5.3e-7 --step auto' \
        '--geometry float'; do
        says "--step power keeps no --tolerance %g there, but %.2g; use a larger one, --step \
auto%s, or --geometry float" \
            pack centred.obj -o x.plt --nodes compact --tolerance 5.3e-7 --step power
        said=$said$(grep -e --centre err)
        packs 4000 centred.obj --nodes compact $remedy
    done
    for remedy in '--tolerance 1e-6 --step power' '--tolerance 5.3e-7 --step auto --centre' \
        '--geometry float'; do
        says "--step power keeps no --tolerance %g there, but %.2g; use a larger one, --step \
auto%s, or --geometry float" \
            pack near.obj -o x.plt --nodes compact --tolerance 5.3e-7 --step power
        packs 4000 near.obj --nodes compact $remedy
    done
}
{ # one triangle that 12 bits lose, and one that says how long the lattice is
    printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'
    printf 'v 0.5 0.5 0\nv 0.50005 0.5 0\nv 0.5 0.50005 0\nf 4 5 6\n'
} >detail.obj
run pack detail.obj -o x.plt --nodes compact --geometry lattice:12
message="; --geometry lattice:21 keeps more of them, --geometry float all"
said=$([ "$status" -eq 0 ] && grep -q " 1 triangle lost .*$message\$" err || cat err)
run pack detail.obj -o x.plt --nodes compact --geometry lattice:21
helped "$(grep -q ' 0 triangles lost' err || cat err)"
run pack detail.obj -o x.plt --nodes compact --geometry float
helped "$(grep 'triangles* lost' err)"

# ---- limits of a build: pack.c, pack_compact.c, host_tools/app/scene.c ----------------------

trouble=$(cd "$top" && BUILD=$(absolute "$BUILD") && $MAKE -s VARIANT=-small OPTIMISE=-O0 \
    ARENA_BYTES=22000 all \
    CFLAGS='-DPLT_PACKET_SIDE_MAX=4 -DPLT_DEPTH_MAX=8 -DPLT_GLOBAL_STACK_MAX=16' 2>&1 >/dev/null)
SMALL=${PLANELET%/host*/planelet}/host-small/planelet
[ -z "$trouble" ] && [ ! -x "$SMALL" ] && trouble="it is not $SMALL"
verdict "a planelet of small limits builds" "$trouble"
run make knot --triangles 500 -o knot.ply
triangles=$(head -n 20 knot.ply | sed -n 's/^element face //p')
PROGRAM=$SMALL
says "%zu triangles need more than %d levels; use a larger --leaf, or build with a larger \
PLT_DEPTH_MAX" pack knot.ply -o x.plt --leaf 1
packs "$triangles" knot.ply --leaf 1 # by the build of larger limits
says "%zu triangles need more than %d levels; use a larger --leaf, or build with a larger \
PLT_DEPTH_MAX" pack knot.ply -o x.plt --leaf 1
cured pack knot.ply -o x.plt --leaf 4
run make knot --triangles 900 -o knot.ply
triangles=$(head -n 20 knot.ply | sed -n 's/^element face //p')
for remedy in "$SMALL pack knot.ply --nodes compact --leaf 2" \
    "$PLANELET pack knot.ply --nodes compact --leaf 1"; do
    says "%u triangles need more than %d levels; use a larger --leaf, or build with a larger \
PLT_DEPTH_MAX" pack knot.ply -o x.plt --nodes compact --leaf 1
    # shellcheck disable=SC2086
    cured_by $remedy -o x.plt
done
run pack knot.ply -o knot.plt --leaf 1
says "%s; build with a larger one (engine/planelet_config.h)" render knot.plt -o x.png
cured_by "$PLANELET" render knot.plt -o x.png
run make knot --triangles 500 -o few.ply
for remedy in '--build host --treelet 1' '--nodes compact'; do
    run pack few.ply -o few.plt --leaf 4 --treelet 1 --build device
    says "needs an arena of %zu bytes, this program has at most %zu; pack it with --build host or \
--nodes compact" render few.plt -o x.png --size 8x8
    # shellcheck disable=SC2086
    "$SMALL" pack few.ply -o few.plt --leaf 4 $remedy 2>err # of no more levels than it takes
    cured render few.plt -o x.png --size 8x8
done
"$SMALL" pack few.ply -o more.plt --leaf 4 --treelet 1 2>err
says "needs an arena of %zu bytes, this program has at most %zu; leave out --source read" \
    render more.plt -o x.png --size 8x8 --source read
cured render more.plt -o x.png --size 8x8
run make ground -o ground.ply
run pack ground.ply -o ground.plt
says "--packet %u: this build has packets of up to %d" render ground.plt -o x.png --packet 8
cured render ground.plt -o x.png --packet 4
cured_by "$PLANELET" render ground.plt -o x.png --packet 8
PROGRAM=

# Treelets of a node or two, in blocks of 20,000 slots each.
run make knot --triangles 100000 -o knot.ply
for remedy in '--slots thesis --treelet 20000' '--slots none --treelet 20'; do
    says "treelets in blocks of their own take more than an image holds; use --slots thesis, or a \
smaller --treelet" pack knot.ply -o x.plt --leaf 1 --slots none --treelet 20000
    # shellcheck disable=SC2086
    cured pack knot.ply -o x.plt --leaf 1 $remedy
done

# ---- memory -----------------------------------------------------------------------------

run make knot --triangles 1000 -o part.ply
run make knot --triangles 400000 -o large.ply
grown "$PLANELET" pack large.ply -o x.plt
larger "%llu bytes do not fit into memory; split the file or use a larger machine"
smaller "%llu bytes do not fit into memory; split the file or use a larger machine" \
    pack part.ply -o x.plt
smaller "out of memory at triangle %zu; split the mesh" pack part.ply -o x.plt
# soup TRIANGLES FILE: triangles that share no vertex. Their edges take more than the file and they.
soup() {
    awk -v triangles="$1" 'BEGIN {
        for (i = 0; i < triangles; i++) {
            x = i % 40; y = int(i / 40) % 40; z = int(i / 1600)
            printf "v %d %d %d\nv %d.5 %d %d\nv %d %d.5 %d\nf -3 -2 -1\n", \
                x, y, z, x, y, z, x, y, z
        }
    }' >"$2"
}
soup 88000 edges.obj
grown "$PLANELET" pack edges.obj -o x.plt --build device
larger "out of memory; use a larger machine"

# ---- --memory: host_tools/cli/pack_memory.c, pack_meshes.c ---------------------------------

# stated: the bytes that the last failure says to give.
stated() {
    sed -n 's/.*; use --memory \([0-9]*\).*/\1/p' err
}
run make knot --triangles 40000 -o much.ply
says "reading it takes more than the %llu bytes that --memory gives; use --memory %llu or \
more" pack much.ply -o x.plt --memory 1048576 --nodes compact
packs 39952 much.ply --nodes compact --memory "$(stated)"
takes="%zu triangles take up to %llu bytes of memory to pack, and --memory gives %llu; use \
--memory %llu%s"
says "$takes" pack much.ply -o x.plt --memory 3000000
packs 39952 much.ply --memory "$(stated)"
says "$takes" pack much.ply -o x.plt --memory 3000000
packs 39952 much.ply --nodes compact --memory 3000000
says "$takes" pack much.ply -o x.plt --memory 6000000 --quality high
packs 39952 much.ply --quality fast --memory 6000000
verdict "... which the message names" "$(
    run pack much.ply -o x.plt --memory 6000000 --quality high
    grep -q ', or --quality fast$' err || cat err
    run pack much.ply -o x.plt --memory 3000000
    grep -q ', or --nodes compact$' err || cat err)"
soup 11000 soup.obj
for less in 1420000 1400000 1380000 1360000; do # reading takes some less
    message="not looked at for holes and seams; use a larger --memory to have that done"
    run pack soup.obj -o x.plt --build device --memory $less
    said=$(grep -q -- "$message" err || cat err)
    [ -n "$said" ] || break
done
packs 11000 soup.obj --build device --memory 2000000
verdict "... and then it is done" "$(grep -q '33000 open edges' err || cat err)"

# Of many files the edges of one are looked at: the tree takes more.
run make knot --triangles 10000 -o part.ply
set -- part.ply part.ply part.ply part.ply part.ply
set -- "$@" "$@" "$@" "$@" "$@" "$@" "$@" "$@"
grown "$PLANELET" pack "$@" -o x.plt
larger "%zu triangles: out of memory; pack on a larger machine"
grown "$PLANELET" pack "$@" -o x.plt --nodes compact
larger "%zu triangles: out of memory; pack on a larger machine"
larger "out of memory; pack on a larger machine"
{ # a million vertices, of which three are used
    printf 'ply\nformat binary_little_endian 1.0\nelement vertex 1000000\nproperty float x\n'
    printf 'property float y\nproperty float z\nelement face 2\n'
    printf 'property list uchar uchar vertex_indices\nend_header\n'
    echo '0 0 0 1 0 0 0 1' | rays one.ray
    cat one.ray
    head -c 11999968 /dev/zero
    printf '\3\0\1\2\3\0\1\3' # the second has no area
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
