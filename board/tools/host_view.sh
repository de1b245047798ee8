#!/bin/sh
# host_view.sh SCENE.plt WIDTHxHEIGHT OUT.ppm [render option ...] - the host's picture
#
# Renders on the host and prints "HASH eye=... look=... up=... tan=...": the
# hash of the frame, and its camera as parameters of the firmware, floats as
# bits, so that the device sees exactly the same. SPDX-License-Identifier: MIT
planelet=${BUILD:-build}/host/planelet
scene=$1 size=$2 out=$3
shift 3
"$planelet" render "$scene" -o "$out" --size "$size" "$@" --json - | awk -F '"' '
    $2 == "frame_hash" { hash = $4 }
    $2 ~ /^(eye|look|up|tan)$/ { camera = camera " " $2 "=" $4 }
    END { if (hash == "") { exit 1 } print hash camera }'
