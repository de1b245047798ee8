#!/bin/sh
# moving.sh SCENES PEER - every frame of every sequence against fresh packs and a judge
#
# SCENES is a folder of meshes with sequences, PEER a program that makes ray files ("rays"), traces
# them ("trace") and lets double-precision brute force decide where two hit files differ
# ("compare"). The sequences are the folder's wooddoll, horse_poses (which `planelet make poses`
# spreads over 60 frames), brainstem and village, and marbles and city, which are made. Of each
# frame the judge makes rays: from the eye, from hits into all directions, and to a light. They are
# traced through the tree of frame 0, which is refitted from frame to frame, after rebuilds before
# every frame and by cost, through a grid, and after plt_move of the frame's mesh. All hits must be
# those of the frame packed alone, bit for bit, and those the judge's. Set SEQUENCES, or SIDE (of
# the judge's picture, a multiple of 16), for less or more; positions are floats, so that the judge
# has the same. SPDX-License-Identifier: MIT
set -u
scenes=${1:-} peer=${2:-}
planelet=${PLANELET:-build/host/planelet}
work=${BUILD:-build}/moving
sequences=${SEQUENCES:-wooddoll marbles horse_poses brainstem village city}
passed=0 failed=0

[ -d "$scenes" ] && [ -x "$peer" ] || {
    echo "use it as: make moving SCENES=folder-of-sequences PEER=judge-program" >&2
    exit 2
}
rm -rf "$work"
mkdir -p "$work"
trap 'rm -rf "$work"' EXIT

# The frames as $work/mesh_000.ply ...: sets `frames`, and `side`.
make_meshes() { # NAME
    side=${SIDE:-128}
    case $1 in
    marbles)
        frames=500 side=${SIDE:-64}
        "$planelet" make marbles --frames $frames -o "$work/mesh_{}.ply"
        ;;
    city)
        frames=140 side=${SIDE:-96}
        "$planelet" make city --frames $frames -o "$work/mesh_{}.ply"
        ;;
    horse_poses)
        frames=60
        "$planelet" make poses "$scenes"/horse_poses/*.ply --frames $frames -o "$work/mesh_{}.ply"
        ;;
    village)
        frames=20
        "$planelet" make mesh "$scenes/village.txt" --frames $frames -o "$work/mesh_{}.ply"
        ;;
    *)
        frames=$(find "$scenes/$1" -name "$1_*.ply" | wc -l)
        "$planelet" make mesh "$scenes/$1/$1_{}.ply" --frames "$frames" -o "$work/mesh_{}.ply"
        ;;
    esac
}

number_of() { # FRAME
    printf '%03d' "$1"
}

# What the judge calls a bad t may be as near as floats can say: within four steps of the largest
# coordinate of where the ray begins. A hit 0.005 away, seen from 13 away from 0,0,0, has a t of
# four digits. Trouble, unless all t of the same triangle are; and if not all rays were looked at.
beyond_steps() { # RAYS HITS HITS
    rays=$(($(wc -c <"$1") / 32))
    od -An -v -t f4 -w32 "$1" >"$work/rays.txt"
    for hits in "$2" "$3"; do
        od -An -v -t f4 -w16 "$hits" | awk '{ print $1 }' >"$work/$(basename "$hits").t"
        od -An -v -t u4 -w16 "$hits" | awk '{ print $4 }' >"$work/$(basename "$hits").id"
    done
    paste -d ' ' "$work/rays.txt" "$work/$(basename "$2").t" "$work/$(basename "$2").id" \
        "$work/$(basename "$3").t" "$work/$(basename "$3").id" | tr -s ' ' | sed 's/^ //' |
        awk -v rays="$rays" '
        function size(x) { return x < 0 ? -x : x }
        NF == 12 { looked++ }
        $10 == $12 && $10 != 4294967295 && size($9 - $11) > 1e-4 * size($9) {
            most = size($1)
            if (size($2) > most) most = size($2)
            if (size($3) > most) most = size($3)
            way = sqrt($5 * $5 + $6 * $6 + $7 * $7)
            if (size($9 - $11) * way > most * 2 ^ -21) print "ray " NR ": " $0
        }
        END { if (looked != rays) print looked + 0 " of " rays " rays were looked at" }' ||
        echo "awk failed"
}

# Rays of all kinds, what a fresh pack says of them, and whether the judge agrees; its counts go
# to $work/judged.
judge_frame() { # NAME NUMBER
    mesh=$work/mesh_$2.ply one=$work/one
    "$peer" rays "$mesh" "$one" --size "$side" >/dev/null || return 1
    cat "$one.primary" "$one.bounce" >"$work/rays_$2"
    mv "$one.shadow" "$work/shadow_$2"
    "$planelet" pack "$mesh" -o "$one.plt" 2>"$work/said" &&
        "$planelet" trace "$one.plt" "$work/rays_$2" "$work/due_rays_$2" 2>"$work/said" &&
        "$planelet" trace "$one.plt" "$work/shadow_$2" "$work/due_shadow_$2" --any \
            2>"$work/said" || {
        cat "$work/said"
        return 1
    }
    for kind in rays shadow; do
        any=
        [ $kind = rays ] || any=--any
        : >"$work/line"
        # shellcheck disable=SC2086
        "$peer" trace "$mesh" "$work/${kind}_$2" "$one.hits" $any --repeat 1 >/dev/null &&
            "$peer" compare "$mesh" "$work/${kind}_$2" "$one.hits" "$work/due_${kind}_$2" $any \
                >"$work/line"
        status=$?
        cat "$work/line" >>"$work/judged"
        if grep -q 'B lost 0, B wrong 0, B bad t [1-9]' "$work/line"; then
            beyond_steps "$work/${kind}_$2" "$one.hits" "$work/due_${kind}_$2" >"$work/beyond"
            [ ! -s "$work/beyond" ]
            status=$?
        fi
        [ $status -eq 0 ] || {
            echo "FAIL $1, frame $2, $kind: $(cat "$work/line")"
            return 1
        }
    done
}

# count STATUS
count() {
    if [ "$1" -eq 0 ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
    fi
}

# All frames in one run, the tree of each from the one before; a verdict per frame.
trace_all() { # NAME KIND WAY IMAGE FLAG...
    name=$1 kind=$2 way=$3 image=$4
    shift 4
    any=
    [ "$kind" = rays ] || any=--any
    rm -f "$work"/found_*
    # shellcheck disable=SC2086
    "$planelet" trace "$work/$image" "$work/${kind}_{}" "$work/found_{}" --frames "0:$frames" \
        $any "$@" 2>"$work/said" || cat "$work/said"
    frame=0
    while [ "$frame" -lt "$frames" ]; do
        number=$(number_of "$frame")
        cmp -s "$work/found_$number" "$work/due_${kind}_$number"
        status=$?
        count $status
        if [ $status -ne 0 ]; then
            echo "FAIL $name, frame $number, $kind, $way: not the hits of a fresh pack"
            differences=$((differences + 1))
        fi
        frame=$((frame + 1))
    done
}

# Sums of the judge's counts.
sum_up() {
    sed 's/[:,|]//g' "$work/judged" | awk '
        { rays += $1 }
        {
            for (i = 1; i < NF; i++) {
                if ($i == "ties") ties += $(i + 1)
                if ($i == "edge") edge += $(i + 1)
                if ($i == "unclear") unclear += $(i + 1)
            }
            near += $0 ~ /B bad t 0/ ? 0 : 1
            lost += $0 ~ /B lost 0 B wrong 0/ ? 0 : 1
        }
        END {
            printf "%d rays, %d on an edge, %d ties, %d unclear; ", rays, edge, ties, unclear
            printf "lost or wrong in %d files, t at the end of its digits in %d", lost, near
        }'
}

sequence() { # NAME
    rm -f "$work"/*
    make_meshes "$1" >"$work/said" 2>&1 || {
        cat "$work/said"
        return 1
    }
    "$planelet" pack --sequence "$work/mesh_{}.ply" --frames "0:$frames" --geometry float \
        -o "$work/all.plt" 2>"$work/said" &&
        "$planelet" pack "$work/mesh_000.ply" -o "$work/first.plt" 2>>"$work/said" || {
        cat "$work/said"
        return 1
    }
    : >"$work/judged"
    frame=0 differences=0
    while [ "$frame" -lt "$frames" ]; do
        judge_frame "$1" "$(number_of "$frame")"
        count $?
        frame=$((frame + 1))
    done
    for kind in rays shadow; do
        trace_all "$1" $kind "refitted" all.plt
        trace_all "$1" $kind "rebuilt before every frame" all.plt --rebuild always
        trace_all "$1" $kind "rebuilt by cost" all.plt --rebuild cost
        trace_all "$1" $kind "grid" all.plt --structure grid
        trace_all "$1" $kind "plt_move" first.plt --moved "$work/mesh_{}.ply"
    done
    echo "$1: $frames frames, $(sum_up); $differences of $((10 * frames)) files are not a" \
        "fresh pack's (refit, rebuilds, grid, plt_move)"
}

for name in $sequences; do
    sequence "$name" || {
        echo "FAIL $name: could not be had"
        failed=$((failed + 1))
    }
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
