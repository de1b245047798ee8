#!/bin/sh
# test_trace.sh - planelet trace: hits by arithmetic, the same hits with all flags, statistics
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin trace

# ---- hits that a reader can work out -----------------------------------------

# Rays down from z = 5 on a 16 x 16 grid over twice the square: inside it, below
# the diagonal, u = x - y and v = y; above it u = x and v = y - x.
quad quad.ply
run pack quad.ply -o quad.plt
awk 'BEGIN {
    for (j = 0; j < 16; j++)
        for (i = 0; i < 16; i++)
            print i / 8 - 0.5 + 1 / 32, j / 8 - 0.5 + 1 / 64, 5, 0, 0, 0, -1, 100 }' >grid
rays down <grid
works "trace quad" trace quad.plt down hit
verdict "... 16 bytes per ray" "$([ "$(wc -c <hit)" -eq 4096 ] || wc -c <hit)"
hits hit >found
verdict "... hits by arithmetic" "$(
    paste -d ' ' grid found | awk '
        function near(a, b) { return a - b < 1e-6 && b - a < 1e-6 }
        {
            x = $1; y = $2; t = u = v = 0; number = 4294967295
            if (x > 0 && x < 1 && y > 0 && y < 1) {
                t = 5
                number = x > y ? 0 : 1
                u = x > y ? x - y : x
                v = x > y ? y : y - x
            }
        }
        !near(t, $9) || !near(u, $10) || !near(v, $11) || number != $12 {
            print "ray " NR ": expected " t, u, v, number
        }')"
works "trace --any" trace quad.plt down any --any
verdict "... writes 1 or 0 and nothing else" "$(
    hits any | paste -d ' ' found - | awk '
        $8 != ($4 != 4294967295) || $5 != 0 || $6 != 0 || $7 != 0 { print "ray " NR ": " $0 }')"
rays odd <<'END'
0.5 0.25 5 0 0 0 -1 5
0.5 0.25 5 0 0 0 -1 4.9
0.5 0.25 5 5 0 0 -1 100
0.5 0.25 5 5.1 0 0 -1 100
0.5 0.25 5 0 0 0 -2 100
0.5 0.25 5 0 0 0 1 100
0.5 0.5 5 0 0 0 -1 inf
nan 0.25 5 0 0 0 -1 100
0.5 0.25 5 0 0 0 0 100
0.5 0.25 5 9 0 0 -1 1
END
run trace quad.plt odd hit
verdict "intervals hold their ends; odd rays hit nothing; a tie is the lower primitive id's" "$(
    cat err
    hits hit | awk '{ print $1 + 0, $4 }' >found
    printf '5 0\n0 %s\n5 0\n0 %s\n2.5 0\n0 %s\n5 0\n0 %s\n0 %s\n0 %s\n' 4294967295 4294967295 \
        4294967295 4294967295 4294967295 4294967295 | diff - found)"
"$PLANELET" trace quad.plt - - <down >piped 2>err
run trace quad.plt down hit
same piped hit "trace reads rays from standard input and writes hits to standard output"

# ---- the same hits with all flags --------------------------------------------

run make knot --triangles 2000 -o knot.ply
awk 'BEGIN {
    srand(7)
    for (i = 0; i < 1000; i++) {
        if (i < 500) # neighbours point alike
            print i % 25 / 4 - 3, int(i / 25) / 3 - 3.4, 6, 0, 0.01, 0.02, -1, 1000
        else
            print 6 * rand() - 3, 3 * rand() - 1.5, 6 * rand() - 3, 0, \
                rand() - 0.5, rand() - 0.5, rand() - 0.5, rand() < 0.3 ? 1 : 1000
    } }' | rays mixed
run pack knot.ply -o none.plt --build none
run trace none.plt mixed nearest
cat err
run trace none.plt mixed any --any
verdict "a knot is hit by some rays and missed by others" "$(
    hits nearest | awk '$4 == 4294967295 { misses++ }
        END { if (misses < 100 || misses > 900) print misses " misses of " NR }')"
verdict "--any says whether there is a nearest hit" "$(
    hits nearest >found
    hits any | paste -d ' ' found - | awk '$8 != ($4 != 4294967295) { print "ray " NR ": " $0 }')"

# every_flag IMAGE [ORDER]: trouble, unless all flags give the hits in `nearest` and `any`.
every_flag() {
    for packet in 2 4 8 16; do
        for order in ${2:-depth two-stage}; do
            for source in map read; do
                flags="--packet $packet --walk $order --source $source"
                rm -f hit
                # shellcheck disable=SC2086
                run trace "$1" mixed hit $flags
                cmp hit nearest || cat err
                rm hit
                # shellcheck disable=SC2086
                run trace "$1" mixed hit --any $flags
                cmp hit any || cat err
            done
        done
    done 2>&1
}
verdict "the image without tree: every packet, order and source gives the same hits" \
    "$(every_flag none.plt)"
for build in host device; do
    for leaf in 1 2 4; do
        for more in "--splits sah" "--splits median --treelet 5"; do
            flags="--build $build --leaf $leaf $more"
            # shellcheck disable=SC2086
            run pack knot.ply -o knot.plt $flags
            verdict "pack $flags: every packet, order and source gives the same hits" "$(
                cat err
                every_flag knot.plt)"
        done
    done
done

# Compact nodes move vertices onto a lattice: other hits, but the same ones with
# all flags. Primitive ids of a device are positions: only its distances are compared.
run pack knot.ply -o compact.plt --nodes compact --geometry lattice:14
run trace compact.plt mixed nearest
run trace compact.plt mixed any --any
hits nearest | awk '{ print $1 }' >distances
for leaf in 1 2 4; do
    flags="--nodes compact --geometry lattice:14 --leaf $leaf"
    # shellcheck disable=SC2086
    run pack knot.ply -o knot.plt $flags
    verdict "pack $flags: every packet and source gives the same hits" "$(
        [ "$status" -eq 0 ] || cat err
        every_flag knot.plt depth)"
    # shellcheck disable=SC2086
    run pack knot.ply -o knot.plt $flags --build device
    run trace knot.plt mixed hit
    verdict "... and the same distances when the device builds" "$(
        cat err
        hits hit | awk '{ print $1 }' | diff - distances)"
done

# ---- statistics --------------------------------------------------------------

fields='rays seconds mrays_per_s packet_side packets mixed_packets node_visits group_tests
    triangle_tests treelet_fetches bytes_fetched bytes_touched_once arena_bytes arena_peak_bytes'
run pack knot.ply -o knot.plt
run trace knot.plt mixed nearest
works "trace --json -" trace knot.plt mixed hit --json - --rays coherent --packet 8
cp out stats
# shellcheck disable=SC2086
verdict "... holds every value" "$(flat_json stats $fields)"
works "trace --json FILE" trace knot.plt mixed hit --json stats.json --repeat 3 --packet 8 \
    --rays coherent
verdict "... the same statistics, whatever --repeat" "$(
    grep -v 'seconds\|mrays' stats >expected
    grep -v 'seconds\|mrays' stats.json | diff expected -)"
verdict "... that fit together" "$(
    for name in $fields; do
        eval "$name=$(number "$name" <stats.json)"
    done
    equal <<END
rays|$rays|1000
side 8|$packet_side|8
packets of 64|$packets|16
the arena|$arena_bytes|1073741824
rays per microsecond|$mrays_per_s|$(awk "BEGIN { printf \"%.3f\", $rays / $seconds * 1e-6 }")
END
    [ "$triangle_tests" -gt 500 ] || echo "$triangle_tests triangle tests"
    [ "$node_visits" -gt 0 ] && [ "$group_tests" -ge "$node_visits" ] ||
        echo "$node_visits visits, $group_tests group tests"
    [ "$bytes_fetched" -ge "$bytes_touched_once" ] || echo "more touched than fetched"
    [ "$treelet_fetches" -gt 0 ] || echo "no treelet"
    run info knot.plt --json
    [ "$bytes_touched_once" -gt 0 ] || echo "nothing touched"
    [ "$bytes_touched_once" -le "$(number tree_bytes <out)" ] || echo "more than the tree"
    need=$(number arena_bytes_needed <out)
    [ "$arena_peak_bytes" = "$((need + $(touched_bytes <out)))" ] || echo "the peak is another")"
verdict "a packet size counts packets of that size" "$(
    for packet in 2:250 4:63 8:16 16:4; do
        run trace knot.plt mixed hit --json - --packet "${packet%:*}" --rays coherent
        [ "$(number packets <out)" = "${packet#*:}" ] || grep '"packets' out
    done)"
verdict "the two-stage order tests more groups, or as many" "$(
    run trace knot.plt mixed hit --json - --walk two-stage --rays coherent
    [ "$(number group_tests <out)" -ge "$(number group_tests <stats)" ] || cat out)"
dd if=/dev/zero of=many.rays bs=32 count=70000 2>/dev/null
works "many rays go in batches" trace knot.plt many.rays hit --json -
verdict "... and are counted once" "$(
    [ "$(number rays <out)" = 70000 ] || cat out
    [ "$(wc -c <hit)" -eq 1120000 ] || wc -c <hit)"

# ---- coherent and incoherent rays -----------------------------------------------

for image in knot.plt none.plt; do
    for rays in auto coherent incoherent; do
        run trace $image mixed hit --rays $rays
        verdict "$image, --rays $rays: the same hits" "$(cmp hit nearest 2>&1 || cat err)"
        run trace $image mixed hit --rays $rays --any
        verdict "$image, --rays $rays: the same any hits" "$(cmp hit any 2>&1 || cat err)"
    done
done
run pack knot.ply -o compact.plt --nodes compact --geometry float
run trace compact.plt mixed hit --rays incoherent
same hit nearest "compact blocks, --rays incoherent: the same hits"

# by RAYS WORD: how many of the rays go by the wave.
by() {
    run trace knot.plt "$1" hit --json - --rays "$2"
    number wave_rays <out
}
awk 'BEGIN {
    for (i = 0; i < 1000; i++)
        print 0, 0, 9, 0, i % 32 / 320, int(i / 32) / 320, -1, 1000
}' | rays beam
awk 'BEGIN {
    srand(3)
    for (i = 0; i < 1000; i++)
        print 6 * rand() - 3, 3 * rand() - 1.5, 6 * rand() - 3, 0, \
            rand() - 0.5, rand() - 0.5, rand() - 0.5, 1000
}' | rays shuffled
head -c 16384 beam >half
head -c 16384 shuffled >>half
verdict "rays that point alike go in packets, others by the wave, and half of half a file" "$(
    equal <<END
a beam|$(by beam auto)|0
shuffled|$(by shuffled auto)|1000
half|$(by half auto)|512
a beam, incoherent|$(by beam incoherent)|1000
shuffled, coherent|$(by shuffled coherent)|0
END
)"
verdict "where the arena has no room for the wide form they go by the wave without it" "$(
    run info knot.plt --json
    need=$(number arena_bytes_needed <out)
    run trace knot.plt shuffled wide
    run trace knot.plt shuffled hit --json - --arena $((need + 100000))
    [ "$(number wave_rays <out)" = 1000 ] || cat out err
    cmp wide hit
    run trace knot.plt shuffled hit --arena "$need" --rays incoherent
    cmp wide hit 2>&1)"

# ---- the arena ---------------------------------------------------------------

for packet in 2 4 8 16; do
    for order in depth two-stage; do
        for source in map read; do
            [ $source = map ] && name=arena_bytes_needed || name=arena_bytes_needed_fetched
            flags="--packet $packet --walk $order"
            # shellcheck disable=SC2086
            run info knot.plt --json $flags
            need=$(number $name <out)
            # shellcheck disable=SC2086
            run trace knot.plt mixed hit $flags --source $source --arena "$need"
            verdict "$flags --source $source: the bytes that info says are enough" "$(
                cat err
                cmp hit nearest 2>&1)"
            # shellcheck disable=SC2086
            refused "... one less is refused with the bytes" knot.plt "--arena $need" \
                trace knot.plt mixed hit $flags --source $source --arena $((need - 1))
        done
    done
done
run pack knot.ply -o device.plt --build device
run info device.plt --json
need=$(number arena_bytes_needed <out)
works "a device's image opens in the arena that info says" \
    trace device.plt mixed hit --arena "$need"
refused "a device's image says what it needs of a far too small arena" device.plt "[0-9] bytes" \
    trace device.plt mixed hit --arena 20000

for build in host device; do
    run pack knot.ply -o knot.plt --build $build
    rm -f once twice
    run trace knot.plt mixed once
    run trace knot.plt mixed twice
    same once twice "tracing --build $build twice gives the same bytes"
done
finish
