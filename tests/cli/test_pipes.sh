#!/bin/sh
# test_pipes.sh - scenes, rays and meshes on standard input
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin pipes
quad quad.ply
run make knot --triangles 2000 -o knot.ply
awk 'BEGIN { for (i = 0; i < 200; i++) print i / 40 - 2.5, i % 7 / 3 - 1, 6, 0, 0, 0, -1, 100 }' |
    rays ray

# piped COMMAND: runs it with scene.plt from a pipe.
piped() {
    # shellcheck disable=SC2086
    cat scene.plt | "$PLANELET" $1 >piped.out 2>err
    status=$?
}
# alike SENTENCE FILE FILE
alike() {
    verdict "$1" "$(
        [ "$status" -eq 0 ] || echo "status $status"
        cat err
        cmp "$2" "$3" 2>&1)"
}
for flags in "--build host" "--build device" "--build none" "--nodes compact" \
    "--nodes compact --build device"; do
    # shellcheck disable=SC2086
    run pack knot.ply -o scene.plt $flags
    run info scene.plt
    cp out plain.out
    piped "info -"
    alike "pack $flags: info - says what info says of the file" piped.out plain.out
    for source in map read; do
        run render scene.plt -o plain.ppm --size 40x30 --source $source --packet 4
        piped "render - -o piped.ppm --size 40x30 --source $source --packet 4"
        alike "... render - --source $source gives the same picture" piped.ppm plain.ppm
        run trace scene.plt ray plain.hits --source $source
        piped "trace - ray piped.hits --source $source"
        alike "... trace - --source $source gives the same hits" piped.hits plain.hits
    done
done
run pack knot.ply -o scene.plt
run trace scene.plt ray plain.hits
"$PLANELET" trace scene.plt - piped.hits <ray 2>err
status=$?
alike "trace reads the rays from standard input" piped.hits plain.hits
misused "... or the scene, but not both" "standard input" trace - - x.hits
run info scene.plt --json
fetched=$(number arena_bytes_needed_fetched <out)
piped "render - -o piped.ppm --size 40x30 --source read --arena $fetched"
verdict "a scene that is fetched from memory fits in the arena that info says" "$(
    [ "$status" -eq 0 ] || cat err)"
run render scene.plt -o piped.ppm --size 40x30 --source read --packet 8 \
    --arena $((fetched - 1))
cp err said
piped "render - -o piped.ppm --size 40x30 --source read --packet 8 --arena $((fetched - 1))"
verdict "... and not in a byte less" "$(
    refusal "standard input" "--arena $fetched"
    sed 's/^standard input/scene.plt/' err | diff said -)"

# broken WHAT WHERE: every command refuses scene.plt from a pipe.
broken() {
    for command in "info -" "render - -o x.png" "render - -o x.png --source read" \
        "trace - ray x.hits" "trace - ray x.hits --source read" \
        "serve - --emulate 600000 -o x.png"; do
        piped "$command"
        verdict "$1, $command" "$(
            refusal "standard input" "$2"
            ls x.* 2>/dev/null
            left_behind)"
    done
}
cp scene.plt whole.plt
: >scene.plt
broken "an empty pipe" "is empty"
head -c 300 whole.plt >scene.plt
broken "a pipe that ends early" ""
cp knot.ply scene.plt
broken "a mesh" "planelet pack\|pack the mesh"
"$PLANELET" pack - -o packed.plt <knot.ply 2>err
status=$?
alike "pack reads a mesh from standard input" packed.plt whole.plt
finish
