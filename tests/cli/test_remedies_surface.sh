#!/bin/sh
# test_remedies_surface.sh - what messages about normals and colours advise, helps
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/remedies.sh
begin remedies_surface
quad quad.ply
run make knot --triangles 2000 -o knot.ply

# ---- flags of pack: host_tools/cli/pack_surface.c -------------------------------------------

says "--smooth takes degrees from 0 to 180" pack knot.ply -o x.plt --smooth 181
cured pack knot.ply -o x.plt --smooth 180
says "--smooth takes degrees from 0 to 180" pack knot.ply -o x.plt --smooth -1
cured pack knot.ply -o x.plt --smooth 0
printf 'v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nvn 0 0 1\nvt 0 1\nf 1/1/1 2/1/1 3/1/1\n' \
    >good.obj
says "--smooth and --normals keep are both normals; leave one out" pack good.obj -o x.plt \
    --smooth 40 --normals keep
packs 1 good.obj --normals keep
says "--smooth, --normals, --colours and --texcoords are of triangles that stay where they are; \
leave out --sequence or --instances" pack good.obj -o x.plt --sequence 0:1 --smooth 40
packs 1 good.obj --smooth 40
for other in '--build device' '--numbers none'; do
    # shellcheck disable=SC2086
    says "--smooth, --normals, --colours and --texcoords take --numbers keep and --build host with \
compact nodes" pack good.obj -o x.plt --smooth 40 --nodes compact $other
    packs 1 good.obj --smooth 40 --nodes compact --numbers keep --build host
done
says "--reduce leaves other corners than the mesh's; use --smooth for normals" pack knot.ply \
    -o x.plt --reduce 500 --normals keep
cured pack knot.ply -o x.plt --reduce 500 --smooth 40
says "has no normals to keep; use --smooth 40 to make some" pack quad.ply -o x.plt --normals keep
packs 2 quad.ply --smooth 40
says "has no colours of vertices to keep; leave out --colours" pack quad.ply -o x.plt \
    --colours keep
packs 2 quad.ply
says "has no texture coordinates to keep; leave out --texcoords" pack quad.ply -o x.plt \
    --texcoords keep
packs 2 quad.ply

says "--surface is of normals, colours and texture coordinates; use --smooth 40, --colours or \
--texcoords" pack knot.ply -o x.plt --surface pages
cured pack knot.ply -o x.plt --surface pages --smooth 40
says "--surface pages takes --build host, whose triangles keep their order" pack knot.ply -o x.plt \
    --surface pages --smooth 40 --build device
cured pack knot.ply -o x.plt --surface pages --smooth 40 --build host

# ---- meshes: host_tools/mesh/intake.c, obj.c ------------------------------------------------

all='--normals keep --colours keep --texcoords keep'
# bad SED_COMMAND: good.obj with a mistake, as bad.obj.
bad() {
    sed "$1" good.obj >bad.obj
}
# mended MESSAGE: pack refuses bad.obj, and takes it with --repair, and corrected.
# shellcheck disable=SC2086
mended() {
    says "$1" pack bad.obj -o x.plt $all
    packs 1 bad.obj $all --repair
    says "$1" pack bad.obj -o x.plt $all
    packs 1 good.obj $all
}
bad 's/^vn 0 0 1/vn 0 0 0\nvn 0 0 1/; s,1/1/1,1/1/2,'
mended "the normal (%g %g %g) is not finite or has no length; correct it, or use pack --repair to \
do without it"
bad 's/ 1 0 0$/ 1 0 7/'
mended "the colour (%g %g %g) is not of 0 to %g each; correct it, or use pack --repair to do \
without it"
bad 's/^vt 0/vt 1e30 0\nvt 0/; s,1/1/1,1/2/1,'
mended "the texture coordinates (%g %g) are not finite or beyond +-65536; correct them, or use \
pack --repair to do without them"
for numbers in 2/1/5 2/5/1; do
    bad "s,2/1/1,$numbers,"
    mended "uses %s %lld, which is not among the %zu %s; correct it, or use pack --repair to do \
without it"
    bad "s,2/1/1,$(echo "$numbers" | sed s/5/-5/),"
    mended "uses %s %lld, which is not among the %lld %s so far; correct it, or use pack --repair \
to do without it"
    bad "s,2/1/1,$(echo "$numbers" | sed s/5/five/),"
    # shellcheck disable=SC2086
    says "'%.*s' where %s number belongs; correct the line" pack bad.obj -o x.plt $all
    # shellcheck disable=SC2086
    packs 1 good.obj $all
done
# wedges NUMBERS: a PLY of one triangle whose list texcoord that is.
wedges() {
    printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n'
    printf 'property float z\nelement face 1\nproperty list uchar int vertex_indices\n'
    printf 'property list uchar float texcoord\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 %s\n' "$1"
}
wedges '5 0 0 1 0 1' >bad.ply
wedges '6 0 0 1 0 1 1' >good.ply
says "%llu numbers in its list texcoord, where its corners need %llu; correct it, or use pack \
--repair to do without it" pack bad.ply -o x.plt --texcoords keep
packs 1 bad.ply --texcoords keep --repair
packs 1 good.ply --texcoords keep

# ---- smooth frames: host_tools/cli/cmd_render.c, cmd_serve.c, host_tools/app/scene.c -----------

run pack knot.ply -o knot.plt --smooth 40
run pack knot.ply -o pages.plt --smooth 40 --surface pages
run pack knot.ply -o compact.plt --nodes compact --build device
size='--size 16x12'
# shellcheck disable=SC2086
{
    says "--shader smooth is not for --baseline, which knows triangles alone" render knot.plt \
        -o x.png $size --shader smooth --baseline bvh
    cured render knot.plt -o x.png $size --shader smooth
    says "%s; pack it with --surface pages, and use --schedule branch" render knot.plt -o x.png \
        $size --shader smooth --residency streamed
    cured render pages.plt -o x.png $size --shader smooth --residency streamed
    says "%s; pack it with --surface pages, and use --schedule branch" render pages.plt -o x.png \
        $size --shader smooth --residency streamed --schedule batch
    cured render pages.plt -o x.png $size --shader smooth --residency streamed --schedule branch
    says "%s; pack it with --nodes thesis --surface tables, or leave out --structure" render \
        pages.plt -o x.png $size --shader smooth --structure grid
    cured render knot.plt -o x.png $size --shader smooth --structure grid
    cured render pages.plt -o x.png $size --shader smooth
    says "%s; leave out --shader smooth" render compact.plt -o x.png $size --shader smooth
    cured render compact.plt -o x.png $size
}
finish
