#!/bin/sh
# test_structure.sh - render and trace --structure grid: what a tree gives, bit for bit
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin structure

run make knot -o knot.ply --triangles 3000
run pack knot.ply -o host.plt
run pack knot.ply -o device.plt --build device
run pack knot.ply -o none.plt --build none
for scene in host device none; do
    for flags in '' '--packet 2' '--packet 16' '--source read' '--workers 3'; do
        # shellcheck disable=SC2086
        run render $scene.plt -o tree.ppm --size 93x71 $flags
        # shellcheck disable=SC2086
        works "$scene, a picture by a grid $flags" render $scene.plt -o grid.ppm --size 93x71 \
            --structure grid $flags --json grid.json
        same tree.ppm grid.ppm "... is that of the tree"
    done
done
verdict "its cells, references and tests are counted" "$(
    for count in node_visits group_tests triangle_tests; do
        [ "$(number $count <grid.json)" -gt 0 ] || echo "$count"
    done)"
# rays: 600 from a point on a circle to one on another, of no order.
awk 'BEGIN { srand(3); while (i++ < 600) {
    a = 6.28 * rand(); b = 6.28 * rand()
    print 4 * cos(a), 2 * rand() - 1, 4 * sin(a), 0, cos(b) - 4 * cos(a), rand() - 0.5, \
        sin(b) - 4 * sin(a), 1e30 } }' | rays mixed
for any in '' --any; do
    # shellcheck disable=SC2086
    run trace host.plt mixed tree.hits $any
    for flags in '' '--packet 4' '--rays incoherent' '--arena 400000'; do
        # shellcheck disable=SC2086
        works "rays by a grid $any $flags" trace host.plt mixed grid.hits $any $flags \
            --structure grid
        same tree.hits grid.hits "... hit what they hit by the tree"
    done
done
works "the smallest arena has a coarse grid" \
    render host.plt -o grid.ppm --size 20x15 --structure grid --packet 2 --arena 65536
run render host.plt -o tree.ppm --size 20x15
same tree.ppm grid.ppm "... and the same picture"
run render host.plt -o x.ppm --size 20x15 --structure grid --arena 20000
verdict "an arena that not even one cell fits is refused, with what would do" "$(
    [ "$status" -eq 1 ] || echo "status $status"
    grep -q 'use --arena [0-9]*$' err || cat err)"
least=$(sed -n 's/.*use --arena //p' err)
works "... which does" render host.plt -o grid.ppm --size 20x15 --structure grid \
    --arena "$least"
same tree.ppm grid.ppm "... and gives the same picture"
finish
