#!/bin/sh
# treelets.sh SCENES - treelets of real meshes: orders, slots, and what fills fetch
#
# SCENES is a folder of binary PLY meshes. Table 5.6 by every order, blocks and incomplete
# treelets by every fill and rule for slots (Table 5.5 and section 8.2.2), and of frames of 512x512
# that are streamed, packets of 16x16, the treelets and bytes fetched through stores of 32 and 96
# KB. Set MESHES for others. SPDX-License-Identifier: MIT
set -u
scenes=${1:-}
planelet=${PLANELET:-build/host/planelet}
programs=${PROGRAMS:-build/host/tests/measure}
work=${BUILD:-build}/treelets
meshes=${MESHES:-shuttle toasters hand bunny ben}
[ -d "$scenes" ] || {
    echo "use it as: make treelets SCENES=folder-of-meshes" >&2
    exit 2
}
mkdir -p "$work"
set --
for mesh in $meshes; do
    set -- "$@" "$scenes/$mesh.ply"
done
"$programs/test_treelet_orders" "$@" && "$programs/test_treelet_slots" "$@" || exit 1

field() { # NAME: of the JSON of the last frame
    sed -n "s/^ *\"$1\": \"*\([0-9a-f]*\)\"*,*$/\1/p" "$work/json"
}
failed=0
echo "| mesh | N | pack | treelets, bytes fetched: 32 KB | 96 KB | once |"
echo "|---|---:|---|---:|---:|---:|"
for mesh in $meshes; do
    due=
    for n in 16 64; do
        for flags in '--fill bfs' '--fill area' '--fill full' '--slots newest' \
            '--fill full --slots newest'; do
            row="| $mesh | $n | $flags |"
            # shellcheck disable=SC2086
            "$planelet" pack "$scenes/$mesh.ply" -o "$work/scene.plt" --treelet $n $flags \
                >"$work/said" 2>&1 || cat "$work/said" >&2
            for store in 32768 98304; do
                "$planelet" render "$work/scene.plt" -o "$work/out.ppm" --size 512x512 --view box \
                    --packet 16 --residency streamed --store $store --json "$work/json"
                row="$row $(field treelet_fetches), $(field bytes_fetched) |"
                hash=$(field frame_hash)
                [ "${due:=$hash}" = "$hash" ] || failed=1
            done
            echo "$row $(field bytes_touched_once) |"
        done
    done
done
[ "$failed" -eq 0 ] || echo "FAIL the pictures are not the same" >&2
exit $failed
