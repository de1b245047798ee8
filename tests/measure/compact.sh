#!/bin/sh
# compact.sh SCENES [PEER] - what compact nodes take and cost, in one table
#
# SCENES is a folder of binary PLY meshes. For every mesh there, K = 2 and 4, and
# lattices of 14, 16 and 21 bits: bytes per triangle of tree and geometry, and how
# fast the host builds. With PEER, a program that makes ray files ("rays"), also
# node visits and triangle tests relative to thesis nodes of the same topology
# (test_compact_topology, which compares all hits, too) on primary and bounce rays
# at 14 bits in packets of 2x2, and rays per second relative to thesis nodes, as they
# are packed and of the same topology: medians of ratios of alternating runs. Set MESHES,
# ROUNDS or REPEAT for less. SPDX-License-Identifier: MIT
set -u
scenes=${1:-} peer=${2:-}
planelet=${PLANELET:-build/host/planelet}
topology=${TOPOLOGY:-build/host/tests/engine/test_compact_topology}
work=${BUILD:-build}/compact
meshes=${MESHES:-hand bunny dragon engine terrain car diorama statues}
rounds=${ROUNDS:-5} repeat=${REPEAT:-8}
passed=0 failed=0

[ -d "$scenes" ] || {
    echo "use it as: make compact SCENES=folder-of-meshes [PEER=judge-program]" >&2
    exit 2
}
mkdir -p "$work"

verdict() { # CONDITION-FOR-AWK SENTENCE
    if awk "BEGIN { exit !($1) }"; then
        echo "pass $2"
        passed=$((passed + 1))
    else
        echo "FAIL $2"
        failed=$((failed + 1))
    fi
}

field() { # NAME: of JSON on standard input
    sed -n "s/^ *\"$1\": \([0-9.]*\),*$/\1/p"
}

# pack MESH IMAGE FLAG...
pack() {
    mesh=$1 image=$2
    shift 2
    "$planelet" pack "$scenes/$mesh.ply" -o "$image" "$@" 2>"$work/said" || {
        cat "$work/said" >&2
        return 1
    }
}

# bytes MESH BITS K: sets tree, geometry, total.
bytes() {
    pack "$1" "$work/scene.plt" --nodes compact --geometry "lattice:$2" --leaf "$3" || return 1
    "$planelet" info "$work/scene.plt" --json >"$work/info"
    tree=$(field tree_bytes_per_triangle <"$work/info")
    geometry=$(field geometry_bytes_per_triangle <"$work/info")
    total=$(awk "BEGIN { printf \"%.3f\", $tree + $geometry }")
}

sizes() { # MESH
    for k in 2 4; do
        row='' limit=2.4 limit_total=6.5
        [ $k = 4 ] && limit=1.25 limit_total=5.1
        worst=0
        for bits in 14 16 21; do
            bytes "$1" $bits $k || return 1
            row="$row $tree + $geometry = $total;"
            [ $bits = 14 ] && total14=$total
            worst=$(awk "BEGIN { print ($tree > $worst) ? $tree : $worst }")
        done
        triangles=$(field triangles <"$work/info")
        echo "$1|$k|$row" >>"$work/table"
        what="$1, $k per list, $triangles triangles"
        verdict "$worst <= $limit" "$what: tree at most $worst bytes per triangle, limit $limit"
        verdict "$total14 <= $limit_total" "$what, 14 bits: $total14 in all, limit $limit_total"
    done
}

# The processor's time, in us, that commands of this script took, into `spent`: not
# the clock's, which counts what other programs of the machine do, too.
processor_us() {
    times >"$work/times"
    spent=$(awk 'NR == 2 { gsub("s", ""); split($1, u, "m"); split($2, k, "m")
        printf "%d", 1e6 * (60 * (u[1] + k[1]) + u[2] + k[2]) }' "$work/times")
}

# Triangles per second: the difference to packing a tree for the device to build.
build_speed() { # MESH
    for builder in device host; do
        best=
        for _ in 1 2 3; do
            processor_us
            began=$spent
            pack "$1" "$work/scene.plt" --nodes compact --geometry lattice:14 --build $builder \
                --numbers none || return 1
            processor_us
            took=$((spent - began))
            [ -z "$best" ] || [ $took -lt $best ] && best=$took
        done
        [ $builder = device ] && without=$best
    done
    rate=$(awk "BEGIN { printf \"%.2f\", $triangles / ($best - $without + 1) }")
    echo "$1|$rate" >>"$work/speeds"
    verdict "$rate >= 0.6" "$1: SAH builds $rate million triangles per second, 0.6 or more"
}

# Rays that start on axis-aligned flat faces (engine) have no limit; their values are printed.
visits() { # MESH K
    pack "$1" "$work/scene.plt" --leaf "$2" --nodes compact --geometry lattice:14 --numbers none ||
        return 1
    for kind in primary bounce; do
        line=$("$topology" "$work/scene.plt" "$work/rays.$kind" 2 "$work/same.plt") || return 1
        # shellcheck disable=SC2086
        set -- "$1" "$2" $line
        echo "$1|$2|$kind|$3|$4|$5" >>"$work/visits"
        verdict "$5 == 0" "$1, $2 per list, $kind: $5 hits differ from those of thesis nodes"
        if [ $kind = primary ] || [ "$1" != engine ]; then
            verdict "$3 <= 1.5" "$1, $2 per list, $kind: $3 % node visits, limit +1.5"
            verdict "$4 <= 2.5" "$1, $2 per list, $kind: $4 % triangle tests, limit +2.5"
        fi
    done
}

rate_of() { # IMAGE SIDE
    "$planelet" trace "$1" "$work/rays.primary" "$work/hits" --packet "$2" --repeat "$repeat" \
        --json - | field mrays_per_s
}

# The median of column $1 of the race.
median() {
    cut -d ' ' -f "$1" "$work/race" | sort -n | sed -n "$(((rounds + 1) / 2))p"
}

# As packed both have numbers, of the same topology neither.
race() { # MESH K SIDE
    for _ in $(seq "$rounds"); do
        echo "$(rate_of "$work/compact.plt" "$3") $(rate_of "$work/thesis.plt" "$3")" \
            "$(rate_of "$work/scene.plt" "$3") $(rate_of "$work/same.plt" "$3")"
    done | awk '{ printf "%.3f %.3f %s %s %s\n", $1 / $2, $3 / $4, $1, $2, $4 }' >"$work/race"
    ratio=$(median 1)
    same=$(median 2)
    least=0.9
    case $1 in dragon | statues) least=1 ;; esac
    echo "$1|$2|$3x$3|$ratio|$same|$(median 3)|$(median 4)|$(median 5)" >>"$work/races"
    what="$1, $2 per list, $3x$3: rays per second against thesis nodes"
    verdict "$ratio >= $least" "$what as packed: $ratio, $least or more"
    verdict "$same >= 0.9" "$what of the same topology: $same, 0.9 or more"
}

costs() { # MESH
    "$peer" rays "$scenes/$1.ply" "$work/rays" >/dev/null || return 1
    for k in 2 4; do
        pack "$1" "$work/thesis.plt" --leaf $k &&
            pack "$1" "$work/compact.plt" --leaf $k --nodes compact --geometry lattice:14 ||
            return 1
        visits "$1" $k || return 1
        race "$1" $k 8
        race "$1" $k 16
    done
}

rm -f "$work/table" "$work/visits" "$work/races" "$work/speeds"
for mesh in $meshes; do
    [ -r "$scenes/$mesh.ply" ] || {
        echo "    $mesh.ply is not there: left out"
        continue
    }
    sizes "$mesh" && build_speed "$mesh" || verdict 0 "$mesh is packed"
    [ -z "$peer" ] || costs "$mesh" || verdict 0 "$mesh is traced"
done

echo
echo "bytes per triangle: mesh | K | tree + geometry = total at 14, 16 and 21 bits"
cat "$work/table"
echo "million triangles per second built (SAH, K 2): mesh | rate"
cat "$work/speeds"
if [ -n "$peer" ]; then
    echo "against thesis nodes: mesh | K | rays | node visits, % | triangle tests, % | other hits"
    cat "$work/visits"
    echo "rays per second: mesh | K | packet | against thesis nodes as packed | of the same" \
        "topology | Mray/s of compact | as packed | of the same topology"
    cat "$work/races"
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
