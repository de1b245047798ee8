#!/bin/sh
# policies.sh [SCENES] - milliseconds per frame of refit, rebuild and rays, by policy
#
# Marbles and city need no download; SCENES is a folder with the sequences wooddoll, horse_poses
# (spread over 60 frames), brainstem and village. Set SEQUENCES for less (marbles city ...), and
# JSON to a file that gets all figures, of every frame. SPDX-License-Identifier: MIT
set -u
scenes=${1:-}
planelet=${PLANELET:-build/host/planelet}
program=${POLICY_TIMES:-build/host/tests/measure/test_policy_times}
work=${BUILD:-build}/policies
sequences=${SEQUENCES:-marbles city ${scenes:+wooddoll horse_poses brainstem village}}

if [ -n "$scenes" ] && ! [ -d "$scenes" ]; then
    echo "use it as: make policies [SCENES=folder-of-sequences] [JSON=file]" >&2
    exit 2
fi
mkdir -p "$work"
set --
for name in $sequences; do
    case $name in
    marbles) set -- "$@" marbles:40:6 ;;
    city) set -- "$@" city:36:4 ;;
    wooddoll) set -- "$@" "$scenes/wooddoll/wooddoll_{}.ply:29" ;;
    brainstem) set -- "$@" "$scenes/brainstem/brainstem_{}.ply:20" ;;
    village) set -- "$@" "$scenes/village.txt:20" ;;
    horse_poses)
        "$planelet" make poses "$scenes"/horse_poses/*.ply --frames 60 -o "$work/horse_{}.ply" ||
            exit 1
        set -- "$@" "$work/horse_{}.ply:60"
        ;;
    *)
        echo "there is no sequence $name: marbles city wooddoll horse_poses brainstem village" >&2
        exit 2
        ;;
    esac
done
"$program" ${JSON:+"--json=$JSON"} "$@"
