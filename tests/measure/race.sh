#!/bin/sh
# race.sh SCENES PEER - rays and frames per second beside another tracer's, strictly in turn
#
# SCENES is a folder of binary PLY meshes, PEER a program that makes ray files ("rays"),
# traces them ("trace", one mode at a time) and judges hits ("compare"). Each round runs all
# modes of both, one of ours after one of theirs, for every kind of ray; who begins changes
# from round to round. A round's ratio is the best of ours over the best of theirs. Frames are
# `render --repeat` from the eye of the primary rays, from the first ray to the last tile, over
# the best primary rays of the peer, which are traced only. Set MESHES, KINDS, FORMATS, PACKETS,
# WALKS, MODES, ISA, ROUNDS or REPEAT for less; FORMATS may also have "float" (compact blocks
# with the mesh's own floats) and "high" (thesis nodes of pack --quality high). An ISA that the
# machine lacks is refused (isa.sh). SPDX-License-Identifier: MIT
set -u
scenes=${1:-} peer=${2:-}
planelet=${PLANELET:-build/host/planelet}
work=${BUILD:-build}/peers
meshes=${MESHES:-bunny toasters car diorama dragon terrain statues}
kinds=${KINDS:-primary shadow bounce}
formats=${FORMATS:-thesis compact}
packets=${PACKETS:-2 4 8 16} walks=${WALKS:-depth two-stage}
modes=${MODES:-single packet4 packet8 packet16 stream} isa=${ISA:-sse4.2}
rounds=${ROUNDS:-5} repeat=${REPEAT:-3}
failed=0

[ -d "$scenes" ] && [ -x "$peer" ] || {
    echo "use it as: sh tests/measure/race.sh folder-of-meshes judge-program" >&2
    exit 2
}
sh tests/measure/isa.sh "$isa" || exit 2
mkdir -p "$work"
: >"$work/runs"
: >"$work/judged"

# The options of `planelet pack` for a format.
options_of() { # FORMAT
    case $1 in
    thesis) ;;
    compact) echo "--nodes compact" ;;
    float) echo "--nodes compact --geometry float" ;;
    high) echo "--quality high" ;;
    *)
        echo "race: there is no format $1; formats: thesis compact float high" >&2
        return 1
        ;;
    esac
}

any_of() { # KIND
    [ "$1" = shadow ] && echo --any
}

rate() { # of the JSON on standard input
    sed -n 's/.*"mrays_per_s": *\([0-9.]*\).*/\1/p'
}

# One run: a line "MESH KIND ROUND WHO MODE RATE" in runs.
run_ours() { # MESH KIND ROUND FORMAT:PACKET:WALK
    format=${4%%:*} walk=${4##*:} side=${4#*:}
    side=${side%:*}
    # shellcheck disable=SC2046
    got=$("$planelet" trace "$work/race.$format.plt" "$work/race.$2" "$work/ours.hits" \
        $(any_of "$2") --packet "$side" --walk "$walk" --repeat "$repeat" --json - | rate)
    echo "$1 $2 $3 $format ${side}x$side-$walk ${got:-0}" >>"$work/runs"
}

run_theirs() { # MESH KIND ROUND MODE
    # shellcheck disable=SC2046
    got=$("$peer" trace "$scenes/$1.ply" "$work/race.$2" "$work/theirs.hits" $(any_of "$2") \
        --mode "$4" --isa "$isa" --repeat "$repeat" | rate)
    echo "$1 $2 $3 peer $4 ${got:-0}" >>"$work/runs"
}

# FORMAT:PACKET:WALK of every mode that we have; blocks have one order.
our_modes() {
    for format in $formats; do
        for walk in $walks; do
            case $format:$walk in
            thesis:* | high:* | *:depth) ;;
            *) continue ;;
            esac
            for side in $packets; do
                echo "$format:$side:$walk"
            done
        done
    done
}

# "ours MODE" and "theirs MODE" in turn until both lists are at their ends.
in_turn() { # ROUND
    our_modes | sed 's/^/ours /' >"$work/list.ours"
    echo "$modes" | tr ' ' '\n' | sed 's/^/theirs /' >"$work/list.theirs"
    if [ $(($1 % 2)) -eq 1 ]; then
        paste -d '\n' "$work/list.ours" "$work/list.theirs"
    else
        paste -d '\n' "$work/list.theirs" "$work/list.ours"
    fi | grep .
}

run_frames() { # MESH ROUND
    for format in $formats; do
        for side in $packets; do
            # shellcheck disable=SC2086
            got=$("$planelet" render "$work/race.$format.plt" -o "$work/frame.ppm" $camera \
                --size 512x512 --packet "$side" --repeat "$repeat" --json - | rate)
            echo "$1 frame $2 $format ${side}x$side ${got:-0}" >>"$work/runs"
        done
    done
}

# On a lattice vertices move, and hits with them.
judge() { # MESH FORMAT KIND
    [ "$2" != compact ] || return
    # shellcheck disable=SC2046
    line=$("$planelet" trace "$work/race.$2.plt" "$work/race.$3" "$work/ours.hits" \
        $(any_of "$3") && "$peer" trace "$scenes/$1.ply" "$work/race.$3" "$work/theirs.hits" \
        $(any_of "$3") --isa "$isa" --repeat 1 >/dev/null &&
        "$peer" compare "$scenes/$1.ply" "$work/race.$3" "$work/theirs.hits" "$work/ours.hits" \
            $(any_of "$3"))
    status=$?
    [ $status -eq 0 ] && word=pass || { word=FAIL && failed=$((failed + 1)); }
    echo "$word $1 $2 $3: ${line:-could not be traced}" >>"$work/judged"
}

race_mesh() { # MESH
    said=$("$peer" rays "$scenes/$1.ply" "$work/race") || return 1
    camera=$(echo "$said" |
        sed -n 's/.*; eye \([^ ]*\) look \([^ ]*\) fov \(.*\)/--eye \1 --look \2 --fov \3/p')
    for format in $formats; do
        options=$(options_of "$format") || return 1
        # shellcheck disable=SC2086
        "$planelet" pack "$scenes/$1.ply" -o "$work/race.$format.plt" $options \
            >"$work/said" 2>&1 || { cat "$work/said" >&2 && return 1; }
        for kind in $kinds; do
            judge "$1" "$format" "$kind"
        done
    done
    for round in $(seq "$rounds"); do
        for kind in $kinds; do
            in_turn "$round" >"$work/list"
            while read -r who mode; do
                "run_$who" "$1" "$kind" "$round" "$mode" </dev/null
            done <"$work/list"
            [ "$kind" != primary ] || run_frames "$1" "$round"
        done
    done
    rm -f "$work"/race.*
}

# A line per mesh, kind and format: ratios of the rounds, and the mode of the best run.
table() {
    echo "best of ours / best of theirs ($isa), $rounds rounds in turn, best of $repeat each;" \
        "spread: least to greatest ratio"
    awk '
        function sorted(list, n,    i, k, x) {
            for (i = 2; i <= n; i++) {
                x = list[i]
                for (k = i - 1; k > 0 && list[k] > x; k--) list[k + 1] = list[k]
                list[k + 1] = x
            }
        }
        {
            key = $1 " " $2 " " $4
            if (!(key in known)) { known[key] = 1; order[++keys] = key }
            rounds = $3 > rounds ? $3 : rounds
            if ($6 > best[key, $3]) best[key, $3] = $6
            if ($6 > most[key]) { most[key] = $6; mode[key] = $5 }
        }
        END {
            form = "%-10s %-8s %-8s %6s %6s %7s  %8s %-16s %8s %s\n"
            printf form, "mesh", "rays", "nodes", "ratio", "least", "spread", "ours", "mode", \
                "theirs", "mode"
            for (i = 1; i <= keys; i++) {
                split(order[i], part, " ")
                if (part[3] == "peer") continue
                other = part[1] " " (part[2] == "frame" ? "primary" : part[2]) " peer"
                n = 0
                for (r = 1; r <= rounds; r++)
                    if (best[other, r] > 0) ratio[++n] = best[order[i], r] / best[other, r]
                if (n == 0) continue
                sorted(ratio, n)
                middle = (ratio[int((n + 1) / 2)] + ratio[int(n / 2) + 1]) / 2
                spread = 100 * (ratio[n] - ratio[1]) / middle
                printf form, part[1], part[2], part[3], sprintf("%.2f", middle), \
                    sprintf("%.2f", ratio[1]), sprintf("%.1f %%", spread), \
                    sprintf("%.2f", most[order[i]]), mode[order[i]], \
                    sprintf("%.2f", most[other]), mode[other]
            }
        }' "$work/runs"
}

for mesh in $meshes; do
    race_mesh "$mesh" || { echo "FAIL $mesh: could not be raced" >>"$work/judged" &&
        failed=$((failed + 1)); }
    echo "raced $mesh" >&2
done
cat "$work/judged"
table
[ "$failed" -eq 0 ]
