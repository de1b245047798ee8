#!/bin/sh
# test_streamed.sh - scenes that stay in their file: --residency streamed, --store
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin streamed

works "a terrain is made" make terrain -o t.ply --triangles 60000
run pack t.ply -o t.plt --nodes compact --geometry lattice:14 --leaf 2 # says what moved
works "... and as thesis nodes" pack t.ply -o thesis.plt
works "... in small treelets" pack t.ply -o thesis16.plt --treelet 16 --quality high
works "... in large ones" pack t.ply -o large.plt --treelet 257
run pack t.ply -o floats.plt --nodes compact --geometry float
value() {
    sed -n "s/^ *\"$2\": \"\{0,1\}\([^\",]*\).*/\1/p" "$1"
}
works "the whole scene is rendered" render t.plt -o whole.ppm --size 200x150 --json whole.json
for arena in 65536 131072 1048576; do
    works "streamed through an arena of $arena bytes" render t.plt -o streamed.ppm --size 200x150 \
        --residency streamed --arena $arena --json streamed.json
    same whole.ppm streamed.ppm "... the picture is the same"
    verdict "... the arena was $arena bytes, and something was fetched" "$(
        [ "$(value streamed.json arena_bytes)" = $arena ] &&
            [ "$(value streamed.json bytes_fetched)" -gt 100000 ] || cat streamed.json)"
done
works "a store of a stated size" render t.plt -o streamed.ppm --size 200x150 --residency streamed \
    --store 28672 --json small.json
same whole.ppm streamed.ppm "... the picture is the same"
verdict "... and more is fetched than with a larger one" "$(
    [ "$(value small.json bytes_fetched)" -gt "$(value streamed.json bytes_fetched)" ] &&
        [ "$(value small.json store_evictions)" -gt 0 ] || cat small.json streamed.json)"
works "a film, too" render t.plt -o streamed.y4m --size 64x48 --orbit 3 --residency streamed
works "... of the whole scene" render t.plt -o whole.y4m --size 64x48 --orbit 3
same whole.y4m streamed.y4m "... is the same"

works "packets that meet at blocks" render t.plt -o batch.ppm --size 200x150 --residency streamed \
    --store 28672 --schedule batch --json batch.json
same whole.ppm batch.ppm "... the picture is the same"
verdict "... and less is fetched than packet after packet" "$(
    [ "$(value batch.json bytes_fetched)" -lt "$(value small.json bytes_fetched)" ] &&
        [ "$(value batch.json schedule)" = batch ] || cat batch.json small.json)"
for batch in 1 3 1024; do
    works "$batch packets of 4 x 4 at a time" render t.plt -o batch.ppm --size 200x150 \
        --residency streamed --schedule batch --batch $batch --packet 4 --json batch.json
    same whole.ppm batch.ppm "... the picture is the same"
    verdict "... so many, it says" "$([ "$(value batch.json batch)" = $batch ] || cat batch.json)"
done
works "a small arena has fewer packets" render t.plt -o batch.ppm --size 200x150 \
    --residency streamed --schedule batch --arena 131072 --json batch.json
same whole.ppm batch.ppm "... the picture is the same"
verdict "... but more than one" "$([ "$(value batch.json batch)" -gt 1 ] || cat batch.json)"
misused "batches of a resident scene are wrong usage" "--residency streamed" \
    render t.plt -o x.png --schedule batch
misused "a batch for no batches is wrong usage" "--schedule batch" \
    render t.plt -o x.png --residency streamed --batch 4
misused "a batch of none is wrong usage" "--batch" \
    render t.plt -o x.png --residency streamed --schedule batch --batch 0
misused "a batch above the most is wrong usage" "--batch" \
    render t.plt -o x.png --residency streamed --schedule batch --batch 1025

awk 'BEGIN { for (i = 0; i < 300; i++)
    print i % 17 / 17 - 0.5, 3, i % 23 / 23 - 0.5, 0, 0.1 * (i % 3), -1, 0.05 * (i % 5), 100 }' |
    rays rays
for any in '' --any; do
    # shellcheck disable=SC2086
    works "rays are traced $any" trace t.plt rays whole.hits $any
    # shellcheck disable=SC2086
    works "... streamed" trace t.plt rays streamed.hits $any --residency streamed --arena 100000
    same whole.hits streamed.hits "... the hits are the same"
    # shellcheck disable=SC2086
    works "... by batches" trace t.plt rays batch.hits $any --residency streamed --schedule batch
    same whole.hits batch.hits "... the hits are the same"
    # shellcheck disable=SC2086
    works "... sorted" trace t.plt rays sorted.hits $any --order sorted
    same whole.hits sorted.hits "... the hits are the same, in the order of the file"
    # shellcheck disable=SC2086
    works "... sorted, by batches of several workers" trace t.plt rays sorted.hits $any \
        --order sorted --residency streamed --schedule batch --batch 2 --packet 4 --workers 3
    same whole.hits sorted.hits "... the hits are the same"
done
misused "an unknown order of rays is wrong usage" "--order" trace t.plt rays x --order random

for packet in 2 4; do
    run info t.plt --json --packet $packet
    least=$(number arena_bytes_needed_streamed <out)
    works "info says what arena is enough for $packet x $packet: $least bytes" \
        render t.plt -o x.png --size 20x15 --residency streamed --packet $packet --arena "$least"
    rm x.png
    refused "... and no byte less" t.plt "use --arena $least" render t.plt -o x.png \
        --residency streamed --packet $packet --arena $((least - 1))
done
for scene in large floats; do
    run info $scene.plt --json
    verdict "... nothing of a scene that cannot be streamed" "$(grep streamed out)"
    refused "$scene.plt cannot be streamed" $scene.plt "only finished trees are .*resident" \
        render $scene.plt -o x.png --residency streamed
done
refused "nor in two stages" thesis.plt "streamed .* depth first; leave out --walk" \
    render thesis.plt -o x.png --residency streamed --walk two-stage

works "the whole scene of thesis nodes is rendered" render thesis.plt -o thesis.ppm --size 200x150
works "... and its rays are traced" trace thesis.plt rays thesis.hits
for scene in thesis thesis16; do
    for store in 28672 98304; do
        works "$scene.plt streamed through a store of $store bytes" render $scene.plt \
            -o streamed.ppm --size 200x150 --residency streamed --store $store --json s.$store.json
        same thesis.ppm streamed.ppm "... the picture is the same"
        works "... rays are traced" trace $scene.plt rays streamed.hits --residency streamed \
            --store $store
        same thesis.hits streamed.hits "... the hits are the same"
    done
    verdict "... a larger store makes fetching less" "$(
        [ "$(value s.28672.json bytes_fetched)" -gt "$(value s.98304.json bytes_fetched)" ] &&
            [ "$(value s.98304.json bytes_fetched)" -ge \
                "$(value s.98304.json bytes_touched_once)" ] || cat s.28672.json s.98304.json)"
    run info $scene.plt --json --packet 4
    least=$(number arena_bytes_needed_streamed <out)
    works "info says what arena is enough: $least bytes" render $scene.plt -o x.png --size 20x15 \
        --residency streamed --packet 4 --arena "$least"
    rm x.png
    refused "... and no byte less" $scene.plt "use --arena $least" render $scene.plt -o x.png \
        --residency streamed --packet 4 --arena $((least - 1))
done
run info thesis.plt
verdict "info has a line for it" "$(grep -q '^arena if streamed  [0-9]* bytes' out || cat out)"
refused "an arena without room for the least store is refused" t.plt "use --arena" \
    render t.plt -o x.png --residency streamed --arena 20000
misused "a store without a stream is wrong usage" "--residency streamed" \
    render t.plt -o x.png --store 65536
misused "a store below the least is wrong usage" "--store" \
    render t.plt -o x.png --residency streamed --store 28671

# A board that is simulated: it counts cycles of work and stalls, and nothing else changes.
works "a simulated board renders" render t.plt -o streamed.ppm --size 200x150 --residency streamed \
    --store 40000 --source dma:1,20 --json slow.json
same whole.ppm streamed.ppm "... the same picture"
works "... with parts on their way" render t.plt -o streamed.ppm --size 200x150 \
    --residency streamed --store 40000 --source dma:1,20 --prefetch 4 --json ahead.json
same whole.ppm streamed.ppm "... the same picture"
count() {
    sed -n "s/^ *\"$2\": \([0-9.]*\).*/\1/p" "$1"
}
# less A B KEY PERCENT: trouble, unless KEY is in A at most so many percent of what it is in B.
less() {
    awk -v a="$(count "$1" "$3")" -v b="$(count "$2" "$3")" -v most="$4" 'BEGIN {
        if (a <= 0 || b <= 0 || a > b * most / 100) print a " of " b }'
}
verdict "... it stalls for less than three quarters of the cycles" \
    "$(less ahead.json slow.json dma_cycles_stalled 75)"
verdict "... for a few more bytes" "$(less ahead.json slow.json bytes_fetched 108)"
# expects SCENE WHOLE PERCENT BYTES [option ...]: with parts on their way SCENE stalls for at most
# so many percent of the cycles, for at most so many percent of the bytes.
expects() {
    scene=$1 whole=$2 percent=$3 bytes=$4
    shift 4
    for prefetch in 0 1 4; do
        works "$scene.plt $* over the board, prefetch $prefetch" render $scene.plt -o streamed.ppm \
            --size 200x150 --residency streamed --store 40000 --source dma:1,20 \
            --prefetch $prefetch --json ahead.$prefetch.json "$@"
        same "$whole.ppm" streamed.ppm "... the same picture"
    done
    verdict "... stalls for at most $percent % of the cycles" \
        "$(less ahead.4.json ahead.0.json dma_cycles_stalled "$percent")"
    verdict "... for at most $bytes % of the bytes" \
        "$(less ahead.4.json ahead.0.json bytes_fetched "$bytes")"
    for any in '' --any; do
        # shellcheck disable=SC2086
        works "... rays are traced $any" trace $scene.plt rays streamed.hits $any "$@" \
            --residency streamed --store 28672 --source dma:1,20 --prefetch 8
        # shellcheck disable=SC2086
        run trace $scene.plt rays due.hits $any
        same due.hits streamed.hits "... the hits are the same"
    done
}
expects t whole 40 104 --schedule batch --batch 64 --packet 8
expects thesis thesis 50 115
expects thesis16 thesis 50 115
expects thesis16 thesis 25 110 --schedule batch --batch 64 --packet 8
works "a faster memory" render t.plt -o streamed.ppm --size 200x150 --residency streamed \
    --store 40000 --source dma:0.2,100,1 --json fast.json
verdict "... stalls less, works and fetches the same" "$(
    less fast.json slow.json dma_share_stalled 25
    for key in dma_cycles_worked dma_bytes dma_transfers bytes_validated; do
        [ "$(count fast.json $key)" = "$(count slow.json $key)" ] || echo "$key differs"
    done)"
verdict "... all bytes are those of the statistics" "$(
    [ "$(count fast.json dma_bytes)" = "$(count fast.json bytes_fetched)" ] || cat fast.json)"
for prefetch in 0 8; do
    works "rays are traced over it, prefetch $prefetch" trace t.plt rays streamed.hits --any \
        --residency streamed --arena 100000 --source dma:0,0.1,64 --prefetch $prefetch --json x.json
    same whole.hits streamed.hits "... the hits are the same"
    verdict "... they stall" "$(less x.json x.json dma_cycles_stalled 100)"
done
works "prefetch from the file itself" render t.plt -o streamed.ppm --size 200x150 \
    --residency streamed --prefetch 8
same whole.ppm streamed.ppm "... the same picture"
misused "a board without a stream is wrong usage" "--residency streamed" \
    render t.plt -o x.png --source dma:1,20
misused "prefetch without a stream is wrong usage" "--residency streamed" \
    render t.plt -o x.png --prefetch 1
for least in dma:0,0.1,1 dma:1000,10000,64; do
    works "--source $least is in range" render t.plt -o streamed.ppm --size 2x2 \
        --residency streamed --source $least
done
for wrong in dma: dma:1 dma:1,0.09 dma:1,10001 dma:1001,20 dma:-1,20 dma:nan,20 dma:1,20,0 \
    dma:1,20,65 dma:1,20, dma:1,20,4,4 dma:1,2e1 dma:1,20x; do
    misused "--source $wrong is out of range" "--source" \
        render t.plt -o x.png --residency streamed --source $wrong
done

# A byte in the middle of the blocks: opening a whole scene finds it, a streamed one when a ray
# comes there. The message has file, byte and rule, and no picture is left.
for scene in t thesis; do
    cp $scene.plt damaged.plt
    size=$(wc -c <$scene.plt)
    at=1000
    while [ $at -lt $((size / 2)) ]; do # many, so that any view meets one
        printf '\377\377\377\377' | dd of=damaged.plt bs=1 seek=$at conv=notrunc 2>/dev/null
        at=$((at + 3004))
    done
    refused "a damaged block of $scene.plt is refused when it comes" damaged.plt \
        "byte [0-9]*: .*(I" render damaged.plt -o x.png --residency streamed
    verdict "... nothing is left of the picture" "$([ ! -e x.png ] || echo x.png)"
    refused "... and when rays are traced" damaged.plt "byte [0-9]*: .*(I" \
        trace damaged.plt rays x.hits --residency streamed
    verdict "... nothing is left of the hits" "$([ ! -e x.hits ] || echo x.hits)"
done
finish
