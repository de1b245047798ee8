#!/bin/sh
# workers.sh SCENES - what several workers make of a frame, in one table
#
# SCENES is a folder of binary PLY meshes. Of each a frame of 512x512 is streamed, as compact
# blocks and as thesis nodes, by crews of 1, 2, 4 and 8 workers with a store of 32 KB each, by
# branches and by tasks. A row says how many bytes they fetch, over what one worker touches; what
# passes between the dispatcher and its workers: messages and bytes both ways; how many times
# faster than one the crew would be if all node visits took equally long (simulated, in turns);
# and, where there are that many processors, how many times the rays per second of one worker it
# traces: the best of ROUNDS alternating runs of REPEAT frames, by the wall and by the processor
# time of the worker that took longest.
# Pictures must be those of the resident scene. Set MESHES, NODES, STORE, PACKET or WORKERS for
# less.
# SPDX-License-Identifier: MIT
set -u
scenes=${1:-}
planelet=${PLANELET:-build/host/planelet}
work=${BUILD:-build}/workers
meshes=${MESHES:-bunny dragon statues diorama}
nodes=${NODES:-compact 16}
crews=${WORKERS:-1 2 4 8}
store=${STORE:-32768}
packet=${PACKET:-16}
rounds=${ROUNDS:-5} repeat=${REPEAT:-5}
passed=0 failed=0

[ -d "$scenes" ] || {
    echo "use it as: make workers SCENES=folder-of-meshes" >&2
    exit 2
}
mkdir -p "$work"
. tests/measure/streamed_scene.sh
processors=$(getconf _NPROCESSORS_ONLN)

verdict() { # STATUS SENTENCE
    if [ "$1" -eq 0 ]; then
        passed=$((passed + 1))
    else
        echo "FAIL $2" >&2
        failed=$((failed + 1))
    fi
}

field() { # NAME: of JSON on standard input; of a list the first
    sed -n "s/^ *\"$1\": \[*\([0-9.]*\).*$/\1/p"
}

# frame SCHEDULE WORKERS OPTION...: its statistics are in $work/json.
frame() {
    schedule=$1 crew=$2
    shift 2
    rm -f "$work/out.ppm" "$work/json"
    "$planelet" render "$work/scene.plt" -o "$work/out.ppm" --size 512x512 \
        --view box --packet "$packet" \
        --residency streamed --store "$store" --schedule "$schedule" --workers "$crew" \
        --json "$work/json" "$@" 2>"$work/said" || cat "$work/said" >&2
    cmp -s "$work/due.ppm" "$work/out.ppm"
    verdict $? "$schedule, $crew workers $*: the picture of the resident scene"
}

# The least of what `times` has in that column.
least() {
    awk -v c="$1" 'NR == 1 || $c < best { best = $c } END { print best }' "$work/times.$2"
}

# measured SCHEDULE WORKERS: rays per second over those of one worker, by the wall and by
# processor time.
measured() {
    if [ "$2" -eq 1 ] || [ "$2" -gt "$processors" ]; then
        echo "- | -"
        return
    fi
    rm -f "$work"/times.*
    round=0
    while [ $round -lt "$rounds" ]; do
        for crew in 1 "$2"; do
            frame "$1" "$crew" --repeat "$repeat" 2>/dev/null
            echo "$(field elapsed_seconds <"$work/json") $(field seconds <"$work/json")" \
                >>"$work/times.$crew"
        done
        round=$((round + 1))
    done
    echo "$(least 1 1) $(least 1 "$2") $(least 2 1) $(least 2 "$2")" |
        awk '{ printf "%.2f | %.2f\n", $1 / $2, $3 / $4 }'
}

speedup() { # SCHEDULE WORKERS: of a crew in turns
    place=$(awk -v n="$2" 'BEGIN { print n == 1 ? 1 : n == 2 ? 2 : n == 4 ? 3 : 4 }')
    [ "$1" = branch ] || place=1
    if [ "$1" = branch ] && [ "$2" -eq 1 ]; then
        echo 1.00
        return
    fi
    sed -n 's/^ *"simulated_speedup": \[\(.*\)\],*$/\1/p' "$work/json" | tr -s ', ' '\n\n' |
        sed -n "${place}p" | awk '{ printf "%.2f\n", $1 }'
}

# row MESH NODES SCHEDULE WORKERS
row() {
    measured "$3" "$4" >"$work/rates"
    frame "$3" "$4" --turns
    fetched=$(field bytes_fetched <"$work/json")
    if [ "$3$4" = branch1 ]; then
        once=$(field bytes_touched_once <"$work/json")
    fi
    if [ "$3" = task ]; then
        passes="$(field task_messages <"$work/json") | $(field task_bytes_out <"$work/json") |\
 $(field task_bytes_back <"$work/json")"
    else
        passes="0 | 0 | 0"
    fi
    ratio=$(awk "BEGIN { printf \"%.2f\", $fetched / $once }")
    echo "| $1 | $2 | $3 | $4 | $ratio | $passes | $(speedup "$3" "$4") | $(cat "$work/rates") |"
}

echo "| mesh | nodes | schedule | workers | fetched | messages | bytes out | back | simulated |\
 by the wall | by processor time |"
echo "|---|---|---|---:|---:|---:|---:|---:|---:|---:|---:|"
for mesh in $meshes; do
    for node in $nodes; do
        pack "$mesh" "$node" || {
            verdict 1 "$mesh is packed"
            continue
        }
        "$planelet" render "$work/scene.plt" -o "$work/due.ppm" --size 512x512 \
            --view box 2>/dev/null
        for schedule in branch task; do
            for crew in $crews; do
                row "$mesh" "$node" "$schedule" "$crew"
            done
        done
    done
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
