#!/bin/sh
# test_workers.sh - render and trace with --workers: the same bytes, and one failure of several
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin workers

works "a terrain is made" make terrain -o t.ply --triangles 20000
works "... packed as thesis nodes" pack t.ply -o thesis.plt
run pack t.ply -o compact.plt --nodes compact --geometry lattice:14 --leaf 2 # says what moved
run pack t.ply -o device.plt --build device

# list NAME FILE: the numbers of that list, a line each.
list() {
    sed -n "s/^  \"$1\": \[\(.*\)\],*\$/\1/p" "$2" | tr -s ', ' '\n\n'
}
sum() {
    list "$1" "$2" | awk '{ s += $1 } END { printf "%.0f\n", s }'
}

# several SENTENCE OUTPUT COMMAND...: the same output from one worker and from several.
several() {
    sentence=$1 output=$2
    shift 2
    works "$sentence, one worker" "$@" --json one.json
    mv "$output" "one.$output"
    for workers in 2 3 8 0; do
        works "... $workers workers" "$@" --json several.json --workers $workers
        same "one.$output" "$output" "... the same bytes"
        verdict "... the statistics are of all" "$(
            flat_json several.json rays workers elapsed_seconds
            for name in rays node_visits bytes_fetched; do
                echo "$name|$(number $name <several.json)|$(sum worker_$name several.json)"
            done | equal
            echo "rays|$(number rays <one.json)|$(number rays <several.json)" | equal
            [ "$(list worker_rays several.json | wc -l)" -eq "$(number workers <several.json)" ] ||
                echo "not a number for each"
            [ $workers -eq 0 ] || [ "$(number workers <several.json)" -eq $workers ] ||
                echo "$(number workers <several.json) workers")"
    done
}

streamed='--residency streamed --store 28672'
for size in 203x151 16x16 1x300; do
    several "thesis nodes, $size" x.ppm render thesis.plt -o x.ppm --size $size
    several "compact blocks, $size" x.ppm render compact.plt -o x.ppm --size $size --packet 4
    # shellcheck disable=SC2086
    several "streamed, $size" x.ppm render compact.plt -o x.ppm --size $size $streamed
    # shellcheck disable=SC2086
    several "streamed thesis nodes, $size" x.ppm render thesis.plt -o x.ppm --size $size $streamed
    # shellcheck disable=SC2086
    several "by batches, $size" x.ppm render compact.plt -o x.ppm --size $size $streamed \
        --schedule batch --batch 7 --packet 4
    # shellcheck disable=SC2086
    several "by tasks of thesis nodes, $size" x.ppm render thesis.plt -o x.ppm --size $size \
        $streamed --schedule task --batch 3
    # shellcheck disable=SC2086
    several "by tasks, $size" x.ppm render compact.plt -o x.ppm --size $size $streamed \
        --schedule task --packet 4
    cp one.x.ppm "streamed.$size"
    works "... resident" render compact.plt -o x.ppm --size $size
    same "streamed.$size" x.ppm "... is the same"
done
several "two stages, fetched into each arena" x.ppm render thesis.plt -o x.ppm --size 100x80 \
    --walk two-stage --source read
several "a tree that each builds" x.ppm render device.plt -o x.ppm --size 100x80 --shader triangle
# shellcheck disable=SC2086
several "a film, twice" x.y4m render compact.plt -o x.y4m --size 70x50 --orbit 4 --repeat 2 \
    $streamed
works "a scene on standard input" render thesis.plt -o one.ppm --size 60x50
"$PLANELET" render - -o x.ppm --size 60x50 --workers 3 <thesis.plt >out 2>err
same one.ppm x.ppm "... for three workers"

awk 'BEGIN { for (i = 0; i < 9001; i++)
    print i % 17 / 17 - 0.5, 3, i % 23 / 23 - 0.5, 0, 0.1 * (i % 3), -1, 0.05 * (i % 5), 100 }' |
    rays rays
for any in '' --any; do
    for kind in coherent incoherent auto; do
        # shellcheck disable=SC2086
        several "$kind rays $any" hits trace thesis.plt rays hits --rays $kind $any
        # shellcheck disable=SC2086
        several "$kind rays $any, compact" hits trace compact.plt rays hits --rays $kind $any
    done
    # shellcheck disable=SC2086
    several "rays $any, streamed" hits trace compact.plt rays hits $streamed $any
    # shellcheck disable=SC2086
    several "rays $any, by batches" hits trace compact.plt rays hits $streamed $any \
        --schedule batch --batch 3 --packet 4
    # shellcheck disable=SC2086
    several "rays $any, by tasks" hits trace compact.plt rays hits $streamed $any \
        --schedule task
done
# shellcheck disable=SC2086
several "a film by tasks, twice" x.y4m render compact.plt -o x.y4m --size 70x50 --orbit 3 \
    --repeat 2 $streamed --schedule task

# ---- turns, and what is simulated ----------------------------------------------------------

for turn in 1 2; do
    # shellcheck disable=SC2086
    works "workers take turns" render compact.plt -o x.ppm --size 203x151 $streamed --workers 4 \
        --turns --json turns.$turn
    same streamed.203x151 x.ppm "... the same picture"
done
# Without times.
for turn in 1 2; do
    grep -v 'seconds\|mrays_per_s' turns.$turn >still.$turn
done
same still.1 still.2 "... the same statistics every time"
verdict "... none has more than a third of the visits of four" "$(
    list worker_node_visits turns.1 | awk '
        { s += $1; if ($1 > most) most = $1 }
        END { if (NR != 4 || 3 * most > s) print "the most of " NR ": " most " of " s }')"
verdict "the speed-up of other crews is simulated: at most as many times, and no less of more" "$(
    list simulated_workers turns.1 >crews
    list simulated_speedup turns.1 | paste crews - | awk '
        $2 > $1 + 0.001 || $2 < before { print $1 " workers: " $2 }
        { before = $2 }
        END { if (NR != 4 || before < 5) print NR " crews, the last " before }')"
# shellcheck disable=SC2086
works "one worker in turns" trace compact.plt rays x.hits $streamed --turns --json one.json
verdict "... nothing is simulated" "$(grep simulated one.json)"

# ---- tasks ---------------------------------------------------------------------------------

# counted NAME: tasks, edges and what passes in messages, of NAME.json. A packet goes out as it is
# at first, with its edges when it comes for more, which are no fewer than the tasks then.
counted() {
    tasks=$(number tasks <"$1.json") edges=$(number task_edges <"$1.json")
    packets=$(number packets <"$1.json")
    [ "$(number task_messages <"$1.json")" -eq $((2 * tasks)) ] || echo "messages"
    [ "$tasks" -ge "$packets" ] && [ "$tasks" -le $((packets + edges)) ] ||
        echo "$tasks tasks, $packets packets, $edges edges"
    [ "$(number task_bytes_out <"$1.json")" -ge $((32 * (tasks - packets))) ] &&
        [ "$(number task_bytes_back <"$1.json")" -gt $((3 * 203 * 151 + 32 * edges)) ] ||
        cat "$1.json"
}

for workers in 1 2 4 8; do
    # shellcheck disable=SC2086
    works "$workers workers by tasks, in turns" render compact.plt -o x.ppm --size 203x151 \
        $streamed --packet 4 --schedule task --workers $workers --turns --json tasks.json
    same streamed.203x151 x.ppm "... the same picture"
    verdict "... as fast as $workers, or nearly, and all messages are counted" "$(
        list simulated_speedup tasks.json | awk -v n=$workers \
            '$1 > n + 0.001 || $1 < 0.9 * n { print $1 }'
        [ "$(list simulated_workers tasks.json)" = $workers ] || echo "of other workers"
        counted tasks)"
    grep -v 'seconds\|mrays_per_s' tasks.json >still.$workers
done
run pack t.ply -o many.plt --treelet 2
run render many.plt -o many.ppm --size 203x151 --view box
# shellcheck disable=SC2086
works "packets with more edges than a worker keeps" render many.plt -o x.ppm --size 203x151 \
    --view box $streamed --packet 16 --schedule task --workers 2 --turns --json many.json
same many.ppm x.ppm "... the same picture"
verdict "... edges go back and out again, and are counted" "$(
    counted many
    [ "$edges" -gt 100 ] && [ "$tasks" -gt "$packets" ] &&
        [ "$tasks" -lt $((packets + edges / 4)) ] ||
        echo "$tasks tasks, $packets packets, $edges edges")"
# shellcheck disable=SC2086
works "in turns again" render compact.plt -o x.ppm --size 203x151 $streamed --packet 4 \
    --schedule task --workers 8 --turns --json tasks.json
grep -v 'seconds\|mrays_per_s' tasks.json >still.again
same still.8 still.again "... the same statistics every time"

# ---- failures -------------------------------------------------------------------------------

# Down on all of the terrain, row by row.
awk 'BEGIN { for (i = 0; i < 10000; i++)
    print i % 100 / 5 - 10, 9, int(i / 100) / 5 - 10, 0, 0, -1, 0, 100 }' | rays grid

# Blocks are wrong: whoever meets one first, it is said where one worker would have met it.
for places in 100000 "20000 40000 60000 80000 100000"; do
    cp compact.plt broken.plt
    for at in $places; do
        printf '\377\0\377\0\377' | dd of=broken.plt bs=1 seek=$at conv=notrunc 2>/dev/null
    done
    # shellcheck disable=SC2086
    run render broken.plt -o x.png --size 203x151 $streamed
    cp err one.err
    # shellcheck disable=SC2086
    run trace broken.plt grid x.hits $streamed
    cp err one.rays
    for workers in 2 3 8; do
        rm -f x.png x.json x.hits
        # shellcheck disable=SC2086
        refused "broken blocks at $places, $workers workers" broken.plt "byte [0-9]*: " \
            render broken.plt -o x.png --size 203x151 $streamed --workers $workers --json x.json
        same one.err err "... the message of one worker"
        verdict "... no file is left" "$(ls x.png x.json 2>/dev/null; left_behind)"
        # shellcheck disable=SC2086
        refused "... of rays" broken.plt "byte [0-9]*: " \
            trace broken.plt grid x.hits $streamed --workers $workers
        same one.rays err "... the message of one worker"
        verdict "... no file is left" "$(ls x.hits 2>/dev/null; left_behind)"
    done
    # shellcheck disable=SC2086
    refused "... in turns" broken.plt "byte [0-9]*: " \
        render broken.plt -o x.png --size 203x151 $streamed --workers 5 --turns
    same one.err err "... the message of one worker"
done
# Which of several failures comes first is not known: one of them is said.
for workers in 1 2 8; do
    rm -f x.png
    # shellcheck disable=SC2086
    refused "broken blocks by tasks, $workers workers" broken.plt \
        "byte [1-9][0-9]*: .*pack the scene" \
        render broken.plt -o x.png --size 203x151 $streamed --schedule task --workers $workers
    verdict "... no file is left" "$(ls x.png 2>/dev/null; left_behind)"
    # shellcheck disable=SC2086
    refused "... of rays" broken.plt "byte [1-9][0-9]*: .*pack the scene" \
        trace broken.plt grid x.hits $streamed --schedule task --workers $workers
    # shellcheck disable=SC2086
    refused "... in turns" broken.plt "byte [1-9][0-9]*: .*pack the scene" \
        render broken.plt -o x.png --size 203x151 $streamed --schedule task --workers $workers \
        --turns
done
refused "an arena that is too small is so for all" thesis.plt "use --arena" \
    render thesis.plt -o x.png --workers 3 --arena 1000
finish
