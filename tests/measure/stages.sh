#!/bin/sh
# stages.sh - what each stage of a picture costs, beside eye light
#
# The marbles of `make demo` by eye light, by normals of corners, with one shadow ray, with mirrors
# and glass, and with four samples, both in packets alone and by a wave, too: rays per second of
# this machine (the most of REPEAT runs, 3, by turns, one core) and instructions per pixel of a
# Cortex-M4F in QEMU (an arena of 256 KiB, steps of 1,000 visits), whose frames have to be the
# host's. SIZE (320x240) and DEVICE_SIZE (SIZE) are in pixels; DEVICE= leaves the firmware out,
# LEFT names stages to leave out there.
# SPDX-License-Identifier: MIT
set -u
build=${BUILD:-build}
planelet=${PLANELET:-$build/host/planelet}
size=${SIZE:-320x240} device_size=${DEVICE_SIZE:-${SIZE:-320x240}} device=${DEVICE-mps2_an386}
folder=$build/stages
firmware=$build/mps2_an386-render-samples-surface-thesis-wave-whitted
mkdir -p "$folder"

"$planelet" make marbles --frame 60 -o "$folder/tray.obj" || exit 1
"$planelet" pack "$folder/tray.obj" -o "$folder/tray.plt" --materials keep --smooth 40 \
    >/dev/null 2>&1 || exit 1
camera='--eye 6,10,22 --look 1.2,-0.6,5 --fov 35'
sun=-0.8,0.9,-0.15,1.5,0,1
lit="--shader whitted --light sun:$sun --sky 0.4,0.58,0.9 --ground 0.26,0.2,0.15"
lit_there="shader=whitted sun=$sun sky=0.4,0.58,0.9 ground=0.26,0.2,0.15"
wave='flight=32 rays=incoherent'
# A stage: its name, flags of the host, and parameters of the firmware.
stages="eye light|--shader eyelight|shader=eyelight
smooth|--shader smooth|shader=smooth
one shadow ray|$lit --depth 0|$lit_there depth=0
... which glass ends|$lit --depth 0 --shadows solid|$lit_there depth=0 shadows=solid
whitted, depth 4|$lit --depth 4 --rays coherent|$lit_there depth=4
... and a wave|$lit --depth 4|$lit_there depth=4 $wave
... 4 samples|$lit --depth 4 --samples 4 --rays coherent|$lit_there depth=4 samples=4
... 4, and a wave|$lit --depth 4 --samples 4|$lit_there depth=4 samples=4 $wave"

member() { # NAME: of the JSON that is read
    sed -n "s/^ *\"$1\": *\"\{0,1\}\([^\",]*\).*/\1/p" | head -n 1
}

: >"$folder/host.txt"
run=0
while [ "$run" -lt "${REPEAT:-3}" ]; do
    run=$((run + 1))
    echo "$stages" | while IFS='|' read -r name flags _; do
        # shellcheck disable=SC2086
        "$planelet" render "$folder/tray.plt" -o "$folder/host.ppm" --size "$size" $camera $flags \
            --json "$folder/host.json" >/dev/null || exit 1
        echo "$name|$(member rays <"$folder/host.json")|$(member seconds <"$folder/host.json")" \
            >>"$folder/host.txt"
    done || exit 1
done
echo "host, $size, best of $run"
awk -F '|' -v pixels="$(echo "$size" | awk -F x '{ print $1 * $2 }')" '
    !($1 in best) { order[++count] = $1; best[$1] = $3 }
    $3 < best[$1] { best[$1] = $3 }
    { rays[$1] = $2 }
    END {
        printf "  %-24s %12s %10s %12s\n", "", "rays/pixel", "Mray/s", "x eye light"
        for (i = 1; i <= count; i++) {
            s = order[i]
            printf "  %-24s %12.2f %10.2f %12.2f\n", s, rays[s] / pixels, rays[s] / best[s] / 1e6,
                best[s] / best[order[1]]
        }
    }' "$folder/host.txt"
[ -n "$device" ] || exit 0

for tool in arm-none-eabi-gcc qemu-system-arm; do
    command -v "$tool" >/dev/null 2>&1 || {
        echo "stages.sh: there is no $tool; install it (make setup), or leave it out: DEVICE=" >&2
        exit 2
    }
done
${MAKE:-make} -s BUILD="$build" BOARD=mps2_an386 \
    PARTS='render thesis surface whitted samples wave' >/dev/null || exit 1
echo "Cortex-M4F, $device_size, packets of 8x8, one tree in flash, 256 KiB"
printf '  %-24s %12s %12s %12s %8s\n' "" "instr./pixel" "x eye light" "longest step" arena
echo "$stages" | while IFS='|' read -r name flags parameters; do
    case ",${LEFT:-}," in *",$name,"*) continue ;; esac
    # shellcheck disable=SC2086
    view=$(sh board/tools/host_view.sh "$folder/tray.plt" "$device_size" "$folder/host.ppm" \
        $camera $flags) || exit 1
    # shellcheck disable=SC2086
    QEMU_SECONDS=${QEMU_SECONDS:-3600} FIRMWARE=$firmware sh board/mps2_an386/run.sh \
        "$folder/tray.plt" size="$device_size" packet=8 arena=262144 visits=1000 $parameters \
        ${view#* } >"$folder/run.txt"
    tr ' ' '\n' <"$folder/run.txt" | awk -F = -v hash="${view%% *}" -v name="$name" \
        -v base="$folder/eyelight.txt" \
        -v pixels="$(echo "$device_size" | awk -F x '{ print $1 * $2 }')" '
        !($1 in n) { n[$1] = $2 }
        END {
            if (n["frame_hash"] != hash) {
                print "stages.sh: " name ": the board has another frame" | "cat >&2"
                exit 1
            }
            each = n["render"] / pixels
            if (name == "eye light") {
                print each >base
                one = each
            } else {
                getline one <base
            }
            printf "  %-24s %12.0f %12.2f %12d %8d\n", name, each, each / one,
                n["render_longest"], n["peak"]
        }' || { cat "$folder/run.txt" >&2; exit 1; }
done
