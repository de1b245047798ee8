#!/bin/sh
# test_remedies_usage.sh - what messages about wrong words advise, helps
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/remedies.sh
begin remedies_usage
quad quad.ply
run pack quad.ply -o quad.plt
echo '0 0 5 0 0 0 -1 100' | rays ray
run pack quad.ply -o compact.plt --nodes compact

# ---- any command: host_tools/app/args.c, program.c ------------------------------------

says "%s: there is no command '%s'; see %s --help" pakc quad.ply -o x.plt
cured --help
says "%s %s: %s; see %s %s --help" pack quad.ply -o x.plt --leave 2
cured pack --help
verdict "... and the help has the flag that was meant" "$(grep -q '^  --leaf 1' out || cat out)"
says "there is no flag %.*s" pack quad.ply -o x.plt --leave=2
packs 2 quad.ply --leaf=2
says "%.*s takes no value" pack quad.ply -o x.plt --repair=yes
packs 2 quad.ply --repair
says "%s takes a value: %s %s" pack quad.ply -o
cured pack quad.ply -o x.plt
says "use it as: %s %s %s" pack -o x.plt
packs 2 quad.ply
says "%s takes a number from %llu to %llu, not '%s'" pack quad.ply -o x.plt --treelet 0
packs 2 quad.ply --treelet 1
says "%s takes %s, not '%s'" pack quad.ply -o x.plt --leaf 3
packs 2 quad.ply --leaf 4
says "%s takes %s, several with commas between, not '%s'" bench quad.plt --packets 8,9
cured bench quad.plt --packets 8,16 --size 9x9
says "%s takes %u numbers separated by commas, not '%s'" render quad.plt -o x.png --eye 0,0
cured render quad.plt -o x.png --eye 0,0,3
says "%s takes WIDTHxHEIGHT, each 1 to %u, not '%s'" render quad.plt -o x.png --size 64
cured render quad.plt -o x.png --size 64x48

# ---- trace --baseline: host_tools/cli/cmd_trace.c, baseline.c --------------------------

says "%s is for the engine; leave it or --baseline out" trace quad.plt ray hit --baseline kd \
    --packet 4
cured trace quad.plt ray hit --baseline kd
says "baselines are for float triangles; pack it with --nodes thesis" trace compact.plt ray hit \
    --baseline kd
run pack quad.ply -o thesis.plt --nodes thesis
cured trace thesis.plt ray hit --baseline kd
says "no structure is called '%.*s'; choose %s" trace quad.plt ray hit --baseline kdtree
cured trace quad.plt ray hit --baseline kd
says "%s has no switch '%.*s'; choose %s" trace quad.plt ray hit --baseline kd:fast
cured trace quad.plt ray hit --baseline kd:single
says "'%s' is a second choice of one kind; give one of %s" \
    trace quad.plt ray hit --baseline wbvh:sah,leaf-2,median
cured trace quad.plt ray hit --baseline wbvh:leaf-2,median
# Switches of a BPH: host_tools/baselines/bph/bph_switches.c.
says "counts and recompute: an intermediate node has the sum of two counts, so it is not known \
where its second list begins; give counts with direct or unmerged, or recompute with leaf-1, \
leaf-2, leaf-3 or leaf-4" trace quad.plt ray hit --baseline bph:counts,recompute
cured trace quad.plt ray hit --baseline bph:counts,direct
says "early and all: of rays that all go along none is the first active one; give early with bits \
or range" trace quad.plt ray hit --baseline bph:early,all
cured trace quad.plt ray hit --baseline bph:early,range
says "frustum and mixed: rays whose signs are not known to be equal have no hull; give frustum \
with equal" trace quad.plt ray hit --baseline bph:frustum,mixed
cured trace quad.plt ray hit --baseline bph:frustum,equal
says "how packets go says nothing of rays one by one; leave it out, or give 4x4 instead" \
    trace quad.plt ray hit --baseline bkd:single,boxes
cured trace quad.plt ray hit --baseline bkd:single
cured trace quad.plt ray hit --baseline bkd:4x4,boxes
says "range, bits, early and frustum are for boxes; leave them out, or give boxes" \
    trace quad.plt ray hit --baseline bih:early,range
cured trace quad.plt ray hit --baseline bih
cured trace quad.plt ray hit --baseline bih:early,range,boxes

printf '%s\n' 'body q quad.ply' 'instance a q' >list.txt
run pack --instances list.txt -o placed.plt
says "baselines are for one mesh; pack it without --instances" trace placed.plt ray hit \
    --baseline kd
cured trace thesis.plt ray hit --baseline kd

# ---- pack --quality: host_tools/cli/cmd_pack.c ---------------------------------------

for build in device none; do
    says "--quality high improves what this program builds; use --build host" \
        pack quad.ply -o x.plt --quality high --build $build
    packs 2 quad.ply --quality high --build host
done
says "--quality-time is for --quality high" pack quad.ply -o x.plt --quality-time 5
packs 2 quad.ply --quality high --quality-time 5

# ---- make: host_tools/cli/cmd_make.c --------------------------------------------------

says "there is no scene '%s': ground, marbles, city, terrain, knot, room, mesh or poses" \
    make tray -o x.ply
for scene in ground marbles city terrain knot room; do
    cured make $scene -o x.ply
done
says "-o FILE says where the mesh goes" make ground
cured make ground -o x.ply
says "--frames needs a '{}' in the file's name, as in marbles_{}.ply" \
    make marbles --frames 2 -o x.ply
cured make marbles --frames 2 -o marbles_{}.ply
says "only marbles, a city and a mesh have frames" make knot --frame 3 -o x.ply
cured make marbles --frame 3 -o x.ply
says "only a room has a seed" make knot --seed 3 -o x.ply
cured make room --seed 3 -o x.ply
says "%s has the triangles it has: no --triangles" make ground --triangles 20 -o x.ply
cured make ground -o x.ply
cp quad.ply pose.ply
says "a mesh is made of one MESH: planelet make mesh MESH -o FILE.ply" make mesh -o x.ply
cured make mesh quad.ply -o x.ply
says "only mesh and poses are made of meshes; leave out '%s'" make ground quad.ply -o x.ply
cured make ground -o x.ply
cured make poses quad.ply pose.ply --frames 2 -o 'x{}.ply'
says "poses take --frames N, and neither --frame, --seed nor --triangles" \
    make poses quad.ply pose.ply --frame 2 -o 'x{}.ply'
cured make poses quad.ply pose.ply --frames 2 -o 'x{}.ply'
says "poses are 2 to %d MESHes of the same triangles" make poses quad.ply --frames 2 -o 'x{}.ply'
cured make poses quad.ply pose.ply --frames 2 -o 'x{}.ply'
says "poses take --frames N, 2 to %d" make poses quad.ply pose.ply -o 'x{}.ply'
cured make poses quad.ply pose.ply --frames 2 -o 'x{}.ply'
run make knot --triangles 24 -o other.ply
says "has %zu vertices and %zu triangles, the pose before %zu and %zu; write all poses from one \
mesh" make poses quad.ply other.ply --frames 2 -o 'x{}.ply'
cured make poses quad.ply pose.ply --frames 2 -o 'x{}.ply'
sed '$s/^3 .*/3 0 3 2/' quad.ply >other.ply
says "triangle %zu has other vertices than in the pose before; write all poses from one mesh" \
    make poses quad.ply other.ply --frames 2 -o 'x{}.ply'
cured make poses quad.ply pose.ply --frames 2 -o 'x{}.ply'
long=$(awk 'BEGIN { while (i++ < 4200) printf "x" }')
says "the name is too long; choose a shorter one" make marbles --frames 1 -o "{}$long.ply"
cured make marbles --frames 1 -o "{}.ply"
for count in 3 11; do
    says "%llu triangles: a %s has %u to %u; ask for such a number" \
        make knot --triangles $count -o x.ply
    cured make knot --triangles "$(sed 's/.* has \([0-9]*\) to .*/\1/' err)" -o x.ply
done

# ---- pack: host_tools/cli/cmd_pack.c ---------------------------------------------------

compact='quad.ply -o x.plt --nodes compact'
# shellcheck disable=SC2086
{
    says "-o SCENE.plt says where the image goes" pack quad.ply
    cured pack quad.ply -o x.plt
    for geometry in double lattice:11 lattice:22; do
        says "--geometry is float, lattice, or lattice:12 to lattice:21, not '%s'" \
            pack $compact --geometry $geometry
    done
    for geometry in float lattice lattice:12 lattice:21; do
        cured pack $compact --geometry $geometry
    done
    for flag in --tolerance=0.001 --numbers=none --step=power; do
        says "--tolerance, --numbers and --step go with --nodes compact" \
            pack quad.ply -o x.plt $flag
        cured pack $compact $flag
    done
    says "--tolerance and --geometry %s both choose the lattice; leave one out" \
        pack $compact --geometry lattice:14 --tolerance 0.001
    cured pack $compact --geometry lattice:14
    cured pack $compact --tolerance 0.001
    says "--tolerance is for --geometry lattice" \
        pack $compact --geometry float --tolerance 0.001
    cured pack $compact --geometry lattice --tolerance 0.001
    says "--tolerance below 5.2e-07 is finer than any lattice; use --geometry float" \
        pack $compact --tolerance 5.1e-7
    cured pack $compact --geometry float
    cured pack $compact --tolerance 5.2e-7
    says "--build device takes --geometry lattice with compact nodes" \
        pack $compact --build device --geometry float
    cured pack $compact --build device --geometry lattice
    says "--numbers is for --geometry lattice; float records hold theirs" \
        pack $compact --geometry float --numbers keep
    cured pack $compact --geometry lattice --numbers keep
    cured pack $compact --geometry float
    says "--checks on is for --build host: only finished trees are streamed" \
        pack quad.ply -o x.plt --build device --checks on
    cured pack quad.ply -o x.plt --build device --checks off
    cured pack quad.ply -o x.plt --checks on
    says "--numbers keep: on a device primitive ids are positions in the image" \
        pack $compact --build device --numbers keep
    cured pack $compact --build device
    for flags in '--build none' '--treelet 32'; do
        says "compact nodes come in blocks of 64, built by host or device" pack $compact $flags
    done
    cured pack $compact --build host
    cured pack $compact --build device
    for flags in '--fill area' '--fill full' '--slots newest' '--slots none' '--treelet auto'; do
        for other in '--nodes compact' '--build device' '--build none' '--sequence' \
            '--instances'; do
            case $other in
                --sequence) from="--sequence quad.ply" ;;
                *) from="quad.ply $other" ;;
            esac
            says "--fill area|full, --slots newest|none and --treelet auto take --nodes thesis \
and --build host, without --sequence and --instances" pack $from -o x.plt $flags
        done
        cured pack quad.ply -o x.plt $flags --nodes thesis --build host
    done
    says "--fill full takes --treelet 1 to %u or auto; --fill area takes any" \
        pack quad.ply -o x.plt --fill full --treelet 10001
    cured pack quad.ply -o x.plt --fill full --treelet 10000
    cured pack quad.ply -o x.plt --fill full --treelet 1
    cured pack quad.ply -o x.plt --fill full --treelet auto
    cured pack quad.ply -o x.plt --fill area --treelet 10001
    says "--centre and --origin both choose the origin; leave one out" \
        pack quad.ply -o x.plt --centre --origin 1,0,0
    cured pack quad.ply -o x.plt --centre
    cured pack quad.ply -o x.plt --origin 1,0,0
    says "--weld takes a distance above 0" pack quad.ply -o x.plt --weld 0
    cured pack quad.ply -o x.plt --weld 1e-9
    for one in x.plt -; do
        says "%s need two different files, not '%s' twice" pack quad.ply -o $one --json $one
        cured pack quad.ply -o $one --json x.json
    done
}

# ---- render, trace: host_tools/app, cmd_render.c, cmd_trace.c ----------------------------

for fov in 0.0001 180; do
    says "--fov takes degrees from 0.0002 to 179.999, not '%s'" render quad.plt -o x.png --fov $fov
done
for fov in 0.0002 179.999; do
    cured render quad.plt -o x.png --fov $fov
done
says "%s takes three numbers from -2^40 to 2^40, not '%s'" render quad.plt -o x.png --eye 2e12,0,0
cured render quad.plt -o x.png --eye 1099511627776,0,0
says "--view takes front, back, left, right or side, top, bottom, iso, usual, box, or \
an azimuth and an elevation, not '%s'" \
    render quad.plt -o x.png --view above
for view in front back left right side top bottom iso usual box 30,20; do
    cured render quad.plt -o x.png --view $view --size 8x8
done
says "--view takes an azimuth from -360 to 360 and an elevation from -90 to 90, not '%s'" \
    render quad.plt -o x.png --view 0,91
cured render quad.plt -o x.png --view -360,90 --size 8x8
says "--view and --eye both say where the camera is, give one of them" \
    render quad.plt -o x.png --view top --eye 1,2,3
cured render quad.plt -o x.png --view top --size 8x8
says "--background takes six hexadecimal digits as ff8000, or sky, not '%s'" \
    render quad.plt -o x.png --background orange
for background in ff8000 sky; do
    cured render quad.plt -o x.png --background $background --size 8x8
done
says "--chroma is for films: give -o a name that ends in .y4m" \
    render quad.plt -o x.png --chroma 444
cured render quad.plt -o x.y4m --chroma 444 --size 8x8
says "no picture format has this ending; use .png, .ppm or .y4m" render quad.plt -o x.jpg
for ending in png ppm y4m; do
    cured render quad.plt -o x.$ending
done
says "%s makes a film: give -o a name that ends in .y4m, or NAME_{}.png for a picture per frame" \
    render quad.plt -o x.png --orbit 2 --size 8x8
cured render quad.plt -o x.y4m --orbit 2 --size 8x8
says "-o OUT says where the picture goes, --show draws it here" render quad.plt
cured render quad.plt -o x.png
cured render quad.plt --show
says "%s need two different files, not '%s' twice" render quad.plt -o x.png --json x.png
cured render quad.plt -o x.png --json x.json
says "-o - and --show would mix on standard output" render quad.plt -o - --show
cured render quad.plt -o -
cured render quad.plt -o x.png --show
says "%s need two different files, not '%s' twice" trace quad.plt ray x.hits --json x.hits
cured trace quad.plt ray x.hits --json x.json
says "several frames need a '{}' in HITS, as in hits_{}" \
    trace quad.plt ray x.hits --moved quad.ply --frames 0:2
cured trace quad.plt ray 'hits_{}' --moved quad.ply --frames 0:2
says "SCENE.plt and RAYS are not both on standard input; name a file" trace - - x.hits
cured_by sh -c "\"$PLANELET\" trace quad.plt - x.hits <ray"
cured_by sh -c "\"$PLANELET\" trace - ray x.hits <quad.plt"

# ---- serve: host_tools/cli/cmd_serve.c -------------------------------------------------

says "one of --pty, --socket, --listen and --emulate says where the device is" \
    serve quad.plt -o x.ppm
cured serve quad.plt -o x.ppm --emulate 400000 --size 64x48
says "one of --pty, --socket, --listen and --emulate says where the device is" \
    serve quad.plt -o x.ppm --emulate 400000 --pty
cured serve quad.plt -o x.ppm --emulate 400000 --size 64x48
says "-o OUT says where the picture goes, --show draws it here" \
    serve quad.plt --emulate 400000 --size 64x48
cured serve quad.plt --emulate 400000 --size 64x48 -o x.ppm
cured serve quad.plt --emulate 400000 --size 64x48 --show
finish
