#!/bin/sh
# test_memory.sh - the arena is taken when a command needs it, and no more than there is
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin memory
quad quad.ply
run make knot --triangles 3000 -o knot.ply
for build in host device; do
    run pack knot.ply -o $build.plt --build $build
    run render $build.plt -o $build.ppm --size 32x32
done
echo '0 0 5 0 0 0 -1 100' | rays ray
run trace host.plt ray open.hits

# within KIB ARGUMENT...: runs planelet with an address space of so many KiB, or of those that
# the caller has if they are fewer.
has=$(ulimit -v)
within() {
    limit=$1
    shift
    [ "$has" = unlimited ] || [ "$has" -ge "$limit" ] || limit=$has
    (ulimit -v "$limit" && exec "$PLANELET" "$@") >out 2>err </dev/null
    status=$?
}
# enough SENTENCE: the last run worked.
enough() {
    verdict "$1" "$(
        [ "$status" -eq 0 ] || echo "status $status"
        cat err)"
}
for kib in 1000000 800000 50000 20000; do
    for command in --version --help "help render" "pack knot.ply -o x.plt" "make ground -o x.ply" \
        "info host.plt" "info device.plt" "trace host.plt ray x.hits"; do
        # shellcheck disable=SC2086
        within $kib $command
        enough "$command in $kib KiB"
    done
    same x.hits open.hits "... the same hits"
    for build in host device; do
        within $kib render $build.plt -o x.ppm --size 32x32
        enough "render with the tree built by $build in $kib KiB"
        same x.ppm $build.ppm "... the same picture"
    done
done
for kib in 4000000 1100000 50000 20000; do
    for workers in 2 64; do
        within $kib render host.plt -o x.ppm --size 32x32 --workers $workers
        enough "$workers workers, or as many as there is room for, in $kib KiB"
        same x.ppm host.ppm "... the same picture"
    done
done
run info host.plt --json
need=$(number arena_bytes_needed <out)
within 20000 render host.plt -o x.ppm --size 32x32 --json stats
counting=$((need + $(run info host.plt --json && touched_bytes <out)))
verdict "where there is no GiB, the arena is what info says" "$(
    [ "$(number arena_bytes <stats)" = "$counting" ] || grep arena stats)"
overcommit=/proc/sys/vm/overcommit_memory
if [ "$has" != unlimited ]; then
    echo "    not tried under ulimit -v $has: else all of it"
elif [ -r $overcommit ] && [ "$(cat $overcommit)" = 2 ]; then
    echo "    not tried where the system gives only memory that it has: else all of it"
else
    run render host.plt -o x.ppm --size 32x32 --json stats
    verdict "... and else all of it" "$(
        [ "$(number arena_bytes <stats)" = 1073741824 ] || grep arena stats)"
fi
# Around 1 GiB, where the arena has room but little is left for rays and pictures.
head -c 16000000 /dev/zero >many.ray
run render host.plt -o open.png --size 1024x1024 --shader triangle
for kib in 1050000 1060000 1070000 1080000 1090000 1100000 1110000 1120000; do
    within $kib trace host.plt many.ray x.hits
    enough "500,000 rays in $kib KiB"
    within $kib render host.plt -o x.png --size 1024x1024 --shader triangle
    enough "... and a large PNG"
    same x.png open.png "... which is the same"
done
rm -f many.ray open.png x.png
within 20000 render host.plt -o x.ppm --size 32x32 --arena 262144
enough "--arena 262144 takes no more than that"
rm -f x.ppm
within 800000 render host.plt -o x.ppm --arena 1073741824
verdict "an --arena that the machine does not give is refused with one that is enough" "$(
    refusal host.plt "no room for an arena of 1073741824 bytes; use --arena $need"
    ls x.ppm 2>/dev/null)"
within 800000 render host.plt -o x.ppm --size 32x32 --arena "$need"
enough "... which is"
run make terrain --triangles 400000 -o big.ply
run pack big.ply -o big.plt --build device
within 40000 render big.plt -o big.ppm
verdict "a scene for which there is no room is refused with a remedy" "$(
    refusal big.plt "no room for an arena of [0-9]* bytes;.*--arena BYTES"
    ls big.ppm 2>/dev/null)"
within 300000 serve host.plt --emulate 1073741824 -o x.png --timeout 20
verdict "a device for which there is no room is refused" "$(refusal device "--emulate")"
finish
