#!/bin/sh
# test_bench_against.sh - planelet bench --against: the engine and structures, by turns
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin bench_against
run make knot --triangles 2000 -o knot.ply
run pack knot.ply -o knot.plt
run pack knot.ply -o compact.plt --nodes compact

# rows FILE: "KEY=VALUE ..." of each row of bench's JSON.
rows() {
    sed -n 's/^    {\(.*\)},*$/\1/p' "$1" | sed 's/"\([a-z_]*\)": "*\([^",]*\)"*/\1=\2/g
        s/, / /g'
}

small='--size 37x50 --repeat 3'
# shellcheck disable=SC2086
{
    works "bench MESH --against" bench knot.ply $small --kinds primary,shadow \
        --against "wbvh  bvh:sah,4x4 kd:single" --json stats
    rows stats >all
    verdict "each structure has its packets, kinds and questions" "$(
        for row in 'wbvh 2 4' 'wbvh 4 4' 'wbvh 8 4' 'wbvh 16 4' 'kd:single 8 4'; do
            # shellcheck disable=SC2086
            set -- $row
            n=$(grep -c "against=$1 .* packet=$2 " all)
            [ "$n" -eq "$3" ] || echo "$1, $2: $n rows"
        done
        n=$(grep -c 'bvh:sah' all)
        [ "$n" -eq 4 ] || echo "bvh:sah,4x4: $n rows")"
    verdict "... with times, ratios of them, and counts of both" "$(awk '{
        for (i = 1; i <= NF; i++) { split($i, part, "="); at[part[1]] = part[2] }
        want = at["seconds"] / at["engine_seconds"]
        if (!(at["seconds"] > 0 && at["engine_seconds"] > 0)) print "no time: " $0
        if (!(at["ratio"] > 0.98 * want && at["ratio"] < 1.02 * want)) print "ratio: " $0
        if (!(at["ratio_median"] > 0)) print "median: " $0
        if (!(at["engine_node_visits"] > 0 && at["node_visits"] > 0)) print "visits: " $0
        if (!(at["engine_triangle_tests"] > 0 && at["triangle_tests"] > 0)) print "tests: " $0
        if (!(at["structure_bytes"] > 0 && at["engine_node_bytes"] > 0)) print "bytes: " $0
        count++
    } END { if (count != 24) print count " rows" }' all)"
    works "bench IMAGE IMAGE --against prints a table" bench knot.plt knot.plt $small \
        --kinds primary --hits any --packets 4 --against wbvh
    verdict "... with a line for each" "$(
        [ "$(grep -c '^primary  any  *4x4  wbvh ' out)" -eq 2 ] || cat out
        [ "$(grep -c '^knot.plt: [0-9]* triangles; 1850 primary rays$' out)" -eq 2 ] || cat out)"
    misused "no structure" "no structure is called ''; choose" bench knot.plt --against ' '
    misused "another structure" "'bwvh'; choose" bench knot.plt --against 'wbvh bwvh'
    misused "too many" "16 structures at most" bench knot.plt \
        --against 'kd kd kd kd kd kd kd kd kd kd kd kd kd kd kd kd kd'
    misused "packets that it does not have" "none of its packets is in --packets" \
        bench knot.plt --against 'wbvh kd' --packets 16
    misused "rays one by one, beside packets of 4x4" "none of its packets" \
        bench knot.plt --against kd:single --packets 4
    misused "walks of the engine" "leave out --walks" bench knot.plt --against kd --walks wave
    refused "lattice triangles" compact.plt "pack it with --nodes thesis" bench compact.plt \
        $small --against wbvh
}
finish
