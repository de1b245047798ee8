#!/bin/sh
# run_like_host.sh BOARD SCENE.plt WIDTHxHEIGHT [key=value ...] - a run, compared with the host's
#
# Gives the firmware the camera of `planelet render`, says whether both frames
# are the same, and leaves them in build/BOARD/frame.ppm and host.ppm. PANEL=PATH.ppm: emulate.sh.
# SPDX-License-Identifier: MIT
board=$1 scene=$2 size=$3
shift 3
if [ -z "$scene" ]; then
    echo "run: which scene? make BOARD=$board run SCENE=x.plt [SIZE=320x240]" >&2
    exit 2
fi
out=${FIRMWARE:-${BUILD:-build}/$board}
given() { # KEY: what its parameter says
    key=$1
    shift
    printf '%s\n' "$@" | sed -n "s/^$key=//p" | tail -n 1
}
shader=$(given shader "$@") samples=$(given samples "$@")
view=$(sh board/tools/host_view.sh "$scene" "$size" "$out/host.ppm" \
    --shader "${shader:-eyelight}" ${samples:+--samples "$samples"}) || exit 1
# With a camera of its own there is no host frame to compare.
case " $*" in
*\ eye=* | *\ look=* | *\ up=* | *\ tan=*) hash= camera= ;;
*) hash=${view%% *} camera=${view#* } ;;
esac
rm -f "$out/frame.ppm"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
# shellcheck disable=SC2086
sh "board/$board/run.sh" "$scene" "size=$size" $camera "frame=$out/frame.ppm" "$@" >"$log" 2>&1
status=$?
cat "$log"
[ -z "$hash" ] && exit $status
# Of a board that keeps no frame the file of frame= has it.
if [ $status -eq 0 ] && ! grep -q '^frame_hash=' "$log"; then
    bytes=$((${size%x*} * ${size#*x} * 3))
    tail -c $bytes "$out/host.ppm" >"$out/host.rgb"
    if tail -c $bytes "$out/frame.ppm" | cmp -s - "$out/host.rgb"; then
        echo "frame_hash=$hash" | tee -a "$log"
    fi
fi
if grep -q "^frame_hash=$hash\$" "$log"; then
    echo "the host renders the same frame"
elif [ $status -eq 0 ]; then
    echo "the host renders another frame: $hash"
    exit 1
fi
exit $status
