#!/bin/sh
# streamed.sh SCENES [PEER] - what scenes in their files fetch, in one table
#
# SCENES is a folder of binary PLY meshes. Every mesh, as compact blocks and as thesis nodes in
# treelets of 16, 32 and 64, is streamed through stores of 32 and 96 KB: a frame of 512x512, and
# with PEER, a program that makes ray files ("rays"), shadow rays as they come and bounce rays,
# shuffled, as they come and sorted. A row says the bytes that were fetched over each part that
# was touched once, for packets one after the other (branch) and packets that meet (batch). Beside
# it, of compact blocks, the bytes of nodes that the primary rays touch.
# Pictures and hits must be those of the resident scene; frames and shadow rays by batches must
# fetch at most 1.25 of each part with 96 KB and 1.7 with 32. Set MESHES, NODES, STORES or PACKET
# for less. SPDX-License-Identifier: MIT
set -u
scenes=${1:-} peer=${2:-}
planelet=${PLANELET:-build/host/planelet}
node_bytes=${NODE_BYTES:-build/host/tests/measure/test_node_bytes}
work=${BUILD:-build}/streamed
meshes=${MESHES:-bunny dragon statues diorama}
nodes=${NODES:-compact 16 32 64}
stores=${STORES:-32768 98304}
packet=${PACKET:-16}
passed=0 failed=0

[ -d "$scenes" ] || {
    echo "use it as: make streamed SCENES=folder-of-meshes [PEER=judge-program]" >&2
    exit 2
}
mkdir -p "$work"
. tests/measure/streamed_scene.sh

verdict() { # CONDITION-FOR-AWK SENTENCE
    if awk "BEGIN { exit !($1) }"; then
        passed=$((passed + 1))
    else
        echo "FAIL $2" >&2
        failed=$((failed + 1))
    fi
}

field() { # NAME: of JSON on standard input
    sed -n "s/^ *\"$1\": \([0-9.]*\),*$/\1/p"
}

# ratio SCHEDULE STORE COMMAND...: of what the command fetches; its output is to be $work/due.
ratio() {
    schedule=$1 store=$2
    shift 2
    rm -f "$work/out.ppm" "$work/json"
    "$planelet" "$@" --residency streamed --store "$store" --schedule "$schedule" \
        --packet "$packet" --json "$work/json" 2>"$work/said" || cat "$work/said" >&2
    cmp -s "$work/due" "$work/out.ppm"
    verdict "$? == 0" "$*: what the resident scene gives"
    fetched=$(field bytes_fetched <"$work/json") once=$(field bytes_touched_once <"$work/json")
    awk "BEGIN { printf \"%.2f\n\", ${fetched:-0} / (${once:-0} > 0 ? $once : 1) }"
}

# row MESH NODES NAME IS-BOUND COMMAND...: the command writes $work/out.ppm.
row() {
    line="| $1 | $2 | $3 |" bound=$4
    shift 4
    "$planelet" "$@" 2>/dev/null
    mv "$work/out.ppm" "$work/due"
    for schedule in branch batch; do
        for store in $stores; do
            ratio "$schedule" "$store" "$@" >"$work/ratio"
            value=$(cat "$work/ratio")
            line="$line $value |"
            most=$([ "$store" -ge 98304 ] && echo 1.25 || echo 1.7)
            [ "$bound$schedule" != 1batch ] || verdict "$value <= $most" "$line at most $most"
        done
    done
    echo "$line"
}

# Ray files are made once per mesh: they do not depend on nodes.
rays() { # MESH NODES
    [ -n "$peer" ] || return 0
    [ -f "$work/$1.shadow" ] || "$peer" rays "$scenes/$1.ply" "$work/$1" >/dev/null || return 1
    [ "$2" != compact ] || "$node_bytes" "$work/scene.plt" "$work/$1.primary" | grep "of nodes in"
    row "$1" "$2" "shadow rays" 1 trace "$work/scene.plt" "$work/$1.shadow" "$work/out.ppm" --any
    row "$1" "$2" "bounce rays" 0 trace "$work/scene.plt" "$work/$1.bounce" "$work/out.ppm"
    row "$1" "$2" "bounce rays, sorted" 0 trace "$work/scene.plt" "$work/$1.bounce" \
        "$work/out.ppm" --order sorted
}

head="| mesh | nodes | rays |" rule="|---|---|---|"
for schedule in branch batch; do
    for store in $stores; do
        head="$head $schedule, $store |" rule="$rule---:|"
    done
done
echo "$head"
echo "$rule"
rm -f "$work"/*.shadow
for mesh in $meshes; do
    for node in $nodes; do
        pack "$mesh" "$node" || {
            verdict 0 "$mesh is packed"
            continue
        }
        row "$mesh" "$node" frame 1 render "$work/scene.plt" -o "$work/out.ppm" --size 512x512 \
            --view box
        rays "$mesh" "$node"
    done
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
