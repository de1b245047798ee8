#!/bin/sh
# test_counts.sh - planelet render and trace --counts: what the thesis counts, of the engine
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin counts

run make knot --triangles 1500 -o knot.ply
run pack knot.ply -o knot.plt --splits median --leaf 1
members='packet_node_intersections packet_triangle_intersections nodes_per_packet
triangles_per_packet nodes_per_ray triangles_per_ray masked_out_at_nodes masked_out_at_triangles
masked_out'
# fits FILE: trouble, unless figures of FILE fit together.
fits() {
    awk -F'"?[:,] *' '
        { gsub(/^ *"/, "", $1); v[$1] = $2 }
        function near(name, due) {
            if (v[name] < due - 1e-5 || v[name] > due + 1e-5) print name " " v[name] ", not " due
        }
        END {
            near("nodes_per_packet", v["packet_node_intersections"] / v["packets"])
            near("triangles_per_packet", v["packet_triangle_intersections"] / v["packets"])
            near("nodes_per_ray", v["packet_node_intersections"] / v["rays"])
            near("triangles_per_ray", v["packet_triangle_intersections"] / v["rays"])
            if (!(v["packet_node_intersections"] > 0 && v["packet_triangle_intersections"] > 0))
                print "nothing is met"
            if (v["masked_out_at_nodes"] < 0 || v["masked_out_at_nodes"] >= 1) print "masks"
            if (!(v["masked_out"] > 0 && v["masked_out"] < 1)) print "masked " v["masked_out"]
        }' "$1"
}
# without FILE: what it has beside those members and times.
without() {
    grep -v 'seconds\|mrays\|worker_\|packet_\|_per_packet\|_per_ray\|masked_out' "$1" | tr -d ','
}

for flags in '' '--packet 4' '--packet 16 --walk two-stage' '--orbit 3 --repeat 2' \
    '--workers 2 --turns'; do
    # shellcheck disable=SC2086
    {
        run render knot.plt -o due.y4m --size 53x41 $flags --json due.json
        works "render --counts $flags" render knot.plt -o got.y4m --size 53x41 $flags \
            --json got.json --counts
    }
    verdict "... counts packets, and nothing else is other than it was" "$(
        # shellcheck disable=SC2086
        flat_json got.json $members
        fits got.json
        without due.json >due
        without got.json | diff due -
        [ "$(number packet_node_intersections <due.json)" = '' ] || echo "without --counts, too")"
done
run render knot.plt -o due.ppm --size 64x64 --packet 16 --walk two-stage --json one.json --counts
run render knot.plt -o due.ppm --size 64x64 --baseline bph:16x16 --json bph.json
verdict "a baseline has the same members, and more packets are masked out there, ray by ray" "$(
    # shellcheck disable=SC2086
    flat_json bph.json $members
    fits bph.json
    awk -v one="$(number masked_out_at_triangles <one.json)" \
        -v two="$(number masked_out_at_triangles <bph.json)" \
        'BEGIN { if (!(one > 0.3 && two > one)) print one, two }')"

awk 'BEGIN { while (i < 1024) {
    x = i % 4 + 4 * int(i / 16) % 32; y = int(i / 4) % 4 + 4 * int(i / 128); i++
    print 0, 0, 6, 0, (x - 64) / 160, (y - 16) / 60, -1, 1e30 } }' | rays ahead
for flags in '' --any '--rays coherent --packet 4' '--order sorted --repeat 2' '--workers 2'; do
    # shellcheck disable=SC2086
    {
        run trace knot.plt ahead due.hits $flags --json due.json
        works "trace --counts $flags" trace knot.plt ahead got.hits $flags --json got.json --counts
    }
    same due.hits got.hits "... has the same hits"
    verdict "... and counts packets" "$(
        # shellcheck disable=SC2086
        flat_json got.json $members
        number packet_node_intersections <got.json | awk '{ exit !($1 > 0) }' || cat got.json)"
done
run trace knot.plt ahead due.hits --json one.json --counts --packet 8 --rays coherent
verdict "counts are of one pass, however many there are" "$(
    for repeat in 1 3; do
        run trace knot.plt ahead x.hits --json two.json --counts --packet 8 --rays coherent \
            --repeat $repeat
        for count in packet_node_intersections packet_triangle_intersections masked_out; do
            [ "$(number $count <one.json)" = "$(number $count <two.json)" ] || echo "$count"
        done
        fits two.json
    done)"

# Frames that move, and whose trees are built anew.
run make marbles --triangles 800 --frames 4 -o 'roll_{}.ply'
run pack roll_000.ply -o roll.plt
works "render --moved --counts" render roll.plt -o roll.y4m --moved 'roll_{}.ply' --frames 0:4 \
    --rebuild always --size 48x48 --json roll.json --counts
verdict "... counts packets of all frames" "$(
    fits roll.json
    [ "$(number rebuilds <roll.json)" -gt 0 ] || echo "no rebuild"
    run render roll.plt -o roll.ppm --size 48x48 --json first.json --counts
    [ "$(number packet_node_intersections <roll.json)" -gt \
        $((2 * $(number packet_node_intersections <first.json))) ] || echo "of one frame")"

# ---- what cannot be -----------------------------------------------------------------------

misused "--counts without --json" "--counts are written to --json" \
    render knot.plt -o x.ppm --counts
misused "--counts of a baseline" "counts packets by itself" \
    render knot.plt -o x.ppm --counts --json x.json --baseline bph
misused "--counts of rays one by one" "leave out --rays incoherent" \
    trace knot.plt ahead x.hits --counts --json x.json --rays incoherent
run pack knot.ply -o compact.plt --nodes compact
run pack knot.ply -o list.plt --build none
for scene in compact.plt list.plt; do
    refused "--counts of $scene" $scene "pack with --nodes thesis" \
        render $scene -o x.ppm --counts --json x.json
done
refused "--counts of a grid" knot.plt "are of resident thesis nodes" \
    trace knot.plt ahead x.hits --counts --json x.json --structure grid
refused "--counts of what is streamed" knot.plt "are of resident thesis nodes" \
    render knot.plt -o x.ppm --counts --json x.json --residency streamed
verdict "nothing is left behind" "$(
    left_behind
    ls x.ppm x.json x.hits 2>/dev/null | grep -v x.hits)"
finish
