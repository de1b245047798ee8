#!/bin/sh
# peers.sh SCENES PEER - the engine against an independent judge
#
# SCENES is a folder of binary PLY meshes, PEER a program that makes ray files
# ("rays"), traces them ("trace") and lets double-precision brute force decide
# where two hit files differ ("compare"). For every mesh, kind of ray, packet
# size, walk and list length the judge must find nothing lost, wrong or with
# a bad t; the bunny's tree must be the thesis's; and 8x8 packets must be at
# least as fast as the peer's packets of four. In the end race.sh runs all modes of both
# in turn and prints a table of the ratios. Set MESHES, PACKETS, LEAVES or
# ROUNDS for less; JUDGE=0 leaves out all but the race. SPDX-License-Identifier: MIT
set -u
scenes=${1:-} peer=${2:-}
planelet=${PLANELET:-build/host/planelet}
work=${BUILD:-build}/peers
meshes=${MESHES:-bunny dragon engine car terrain statues}
packets=${PACKETS:-2 4 8 16}
leaves=${LEAVES:-1 2 4}
rounds=${ROUNDS:-7}
passed=0 failed=0

[ -d "$scenes" ] && [ -x "$peer" ] || {
    echo "use it as: make peers SCENES=folder-of-meshes PEER=judge-program" >&2
    exit 2
}
sh tests/measure/isa.sh "${ISA:-sse4.2}" || exit 2
mkdir -p "$work"

verdict() { # STATUS SENTENCE
    if [ "$1" -eq 0 ]; then
        echo "pass $2"
        passed=$((passed + 1))
    else
        echo "FAIL $2"
        failed=$((failed + 1))
    fi
}

# One hit file of ours: judged, unless the same bytes were judged before.
judge() { # MESH KIND ANY LABEL
    hits=$work/hits
    for before in "$work/$1.$2".judged.*; do
        if cmp -s "$hits" "$before"; then
            verdict 0 "$1 $2 $4: the same bytes as judged above"
            return
        fi
    done
    line=$("$peer" compare "$scenes/$1.ply" "$work/$1.$2" "$work/$1.$2.peer" "$hits" $3)
    status=$?
    echo "$line"
    [ "$status" -eq 0 ] && cp "$hits" "$work/$1.$2.judged.$4"
    verdict "$status" "$1 $2 $4: 0 lost, 0 wrong, 0 bad t"
}

judge_mesh() { # MESH
    rm -f "$work/$1".*
    "$peer" rays "$scenes/$1.ply" "$work/$1" >/dev/null || return 1
    for kind in primary shadow bounce; do
        any=
        [ $kind = shadow ] && any=--any
        "$peer" trace "$scenes/$1.ply" "$work/$1.$kind" "$work/$1.$kind.peer" $any \
            --isa sse4.2 --repeat 1 >/dev/null
    done
    for leaf in $leaves; do
        "$planelet" pack "$scenes/$1.ply" -o "$work/scene.plt" --leaf "$leaf" || return 1
        for kind in primary shadow bounce; do
            any=
            [ $kind = shadow ] && any=--any
            for side in $packets; do
                for walk in depth two-stage; do
                    "$planelet" trace "$work/scene.plt" "$work/$1.$kind" "$work/hits" $any \
                        --packet "$side" --walk $walk || return 1
                    judge "$1" $kind "$any" "K=$leaf-${side}x$side-$walk"
                done
            done
        done
    done
    rm -f "$work/$1".*.judged.*
}

field() { # NAME: of `planelet info --json` on standard input
    sed -n "s/^ *\"$1\": \([0-9.]*\),*$/\1/p"
}

bunny_tree() {
    for n in 2 3 7 8 16 64 256 512 10000; do
        "$planelet" pack "$scenes/bunny.ply" -o "$work/scene.plt" --splits median --leaf 1 \
            --treelet $n
        info=$("$planelet" info "$work/scene.plt" --json)
        nodes=$(echo "$info" | field nodes) over=$(echo "$info" | field slot_overhead_bytes)
        [ "$over" -eq $((32 * ((n - nodes % n) % n))) ]
        verdict $? "bunny median K=1 N=$n: slot overhead $over bytes is 32 (-nodes mod N)"
    done
    two=$(echo "$info" | field intermediate_lists) one=$(echo "$info" | field leaf_lists)
    [ "$nodes" -ge 40141 ] && [ "$nodes" -le 40157 ]
    verdict $? "bunny median K=1: $nodes nodes, within 8 of 40149"
    [ $(((200 * two / (one + two) + 1) / 2)) -eq 73 ]
    verdict $? "bunny median K=1: $two of $((one + two)) leaves are intermediate, 73 %"
    "$planelet" pack "$scenes/bunny.ply" -o "$work/scene.plt" --splits median --leaf 2
    bytes=$("$planelet" info "$work/scene.plt" --json | field nodes)
    bytes=$((32 * bytes))
    [ "$bytes" -ge 747450 ] && [ "$bytes" -le 762550 ]
    verdict $? "bunny median K=2: $bytes bytes of nodes, within 1 % of 755 KB"
}

# Alternating runs; the median of the ratios decides.
race() {
    "$planelet" pack "$scenes/bunny.ply" -o "$work/scene.plt"
    "$peer" rays "$scenes/bunny.ply" "$work/bunny" >/dev/null
    for _ in $(seq "$rounds"); do
        theirs=$("$peer" trace "$scenes/bunny.ply" "$work/bunny.primary" "$work/hits" \
            --mode packet4 --isa sse4.2 --repeat 20 |
            sed -n 's/.*"mrays_per_s":\([0-9.]*\).*/\1/p')
        ours=$("$planelet" trace "$work/scene.plt" "$work/bunny.primary" "$work/hits" \
            --packet 8 --repeat 20 --json - | field mrays_per_s)
        echo "$ours $theirs"
    done | awk '{ print $1 / $2, $1, $2 }' | sort -n >"$work/race"
    line=$(sed -n "$(((rounds + 1) / 2))p" "$work/race")
    echo "$line" | awk '{ exit !($1 >= 1) }'
    verdict $? "bunny.primary, 8x8 against packet4 sse4.2 (ratio, ours, theirs; Mray/s): $line"
}

if [ "${JUDGE:-1}" -ne 0 ]; then
    for mesh in $meshes; do
        judge_mesh "$mesh" || verdict 1 "$mesh: could not be traced"
    done
    bunny_tree
    race
fi
sh tests/measure/race.sh "$scenes" "$peer"
verdict $? "the race: hits of thesis nodes are the peer's, every mesh was raced"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
