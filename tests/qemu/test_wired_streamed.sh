#!/bin/sh
# test_wired_streamed.sh - a Cortex-M4F renders a scene that stays with the host of its serial line
#
# In QEMU: the image is eight times the board's memory, and the host serves blocks of it as they
# are asked for. Pictures are the host's own; a host that lies is told where.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
planelet=$BUILD/host/planelet
parts='render compact stream'
folder=$BUILD/mps2_an386-wired-compact-render-stream
out=$folder/tests
mkdir -p "$out"
needs arm-none-eabi-gcc qemu-system-arm && make_board mps2_an386 PROGRAM=wired PARTS="$parts" ||
    { finish; exit; }
verdict "gcc compiles the firmware without a warning" "$(
    find "$folder" -name '*.log' -size +0 -exec cat {} +)"

. tests/qemu/terrain.sh
view='--size 32x24 --fov 30'
# shellcheck disable=SC2086
"$planelet" render "$out/terrain.plt" -o "$out/host.ppm" $view >/dev/null

wire=$(mktemp -d) # a socket's path must be short
board=
end() {
    [ -z "$board" ] || { kill "$board" && wait "$board"; } 2>/dev/null
    board=
}
trap 'end; rm -rf "$wire"' EXIT

value() { # NAME: of the last NAME=value in the log
    tr ' ' '\n' <"$out/log.txt" | sed -n "s/^$1=//p" | tail -n 1
}
start() { # [VARIABLE=value]
    env "$@" FIRMWARE="$folder" sh board/mps2_an386/wired.sh "$wire/wire" >"$out/log.txt" 2>&1 &
    board=$!
}

# serve SCENE [option ...]: one frame into served.ppm; sets text and status.
serve() {
    rm -f "$out/served.ppm"
    text=$(timeout 400 "$planelet" serve "$@" --socket "$wire/wire" --timeout 390 \
        -o "$out/served.ppm" 2>&1)
    status=$?
}

start PROFILE="$out/profile.txt"
# shellcheck disable=SC2086
serve "$out/terrain.plt" $view
verdict "the frame that comes back is the host's direct render, bit for bit" "$(
    [ "$status" -eq 0 ] || echo "status $status: $text"
    cmp "$out/served.ppm" "$out/host.ppm" 2>&1)"
sent=$(echo "$text" | sed -n 's/.*streamed \([0-9]*\) bytes for.*/\1/p')
verdict "... the host says how much of the image that took: ${sent:-nothing} of $image bytes" "$(
    [ "${sent:-0}" -ge "$(value fetched)" ] && [ "$sent" -lt "$image" ] || echo "$text")"
verdict "... $(value fetched) bytes were fetched into $(value memory) bytes of memory" "$(
    [ "$(value memory)" -eq 262144 ] && [ "$(value arena)" -le 262144 ] &&
        [ "$(value streamed)" = 1 ] && [ "$(value fetched)" -gt 262144 ] || cat "$out/log.txt")"
worst=$(sed -n 's/^worst \([0-9]*\).*/\1/p' "$folder/stack.txt")
verdict "... the stack stays below its bound: $(value painted) of $worst bytes" "$(
    [ "$(value painted)" -gt 0 ] && [ "$(value painted)" -le "$worst" ] || cat "$out/log.txt")"
verdict "... no byte was lost; $(value retries) blocks came late and were fetched again" "$(
    [ "$(value lost_bytes)" = 0 ] && [ "$(value retries)" -ge 0 ] || cat "$out/log.txt")"
end

# counted PART: instructions of the engine, the wire or the rest.
counted() {
    awk -f board/tools/sections.awk "$folder/firmware.map" | sort |
        awk -f board/tools/profile.awk - "$out/profile.txt" |
        awk -v part="$1" '$4 == part { s += $1 } END { printf "%.0f", s }'
}
engine=$(counted engine)
per_ray=$(awk -v n="$engine" -v rays="$(value rays)" 'BEGIN { printf "%.1f", n / rays }')
verdict "... in $per_ray instructions of the engine per ray" "$(
    [ "$engine" -gt 1000000 ] || cat "$out/profile.txt")"
sed -n 's/^frame/    &/p' "$out/log.txt"
echo "    while it waited: wire $(counted wire) instructions, rest $(counted rest)"

# A session used to end after 0.8 s of silence, and the frame with it.
start
(
    until grep -q '^scene opened' "$out/log.txt"; do sleep 0.1; done
    for pause in 1 2 3; do
        sleep 2
        kill -STOP "$board" && sleep "$pause"
        kill -CONT "$board"
    done
) 2>/dev/null &
stops=$!
# shellcheck disable=SC2086
serve "$out/terrain.plt" $view --verbose
wait $stops
verdict "a board that stands still for seconds, three times: the frame is the host's" "$(
    [ "$status" -eq 0 ] || echo "status $status: $text"
    cmp "$out/served.ppm" "$out/host.ppm" 2>&1)"
verdict "... in one session, each of $(value rays) rays cast once" "$(
    [ "$(value rays)" -eq 768 ] && echo "$text" | grep -q ', 1 sessions' &&
        echo "$text" | grep -q 'is silent' || echo "$text")"
end

damage "$out/damaged.plt"
start
serve "$out/damaged.plt"
verdict "a block that is not valid: the host is told the rule and the byte, and ends" "$(
    [ "$status" -eq 1 ] &&
        echo "$text" | grep -q '^device: the scene was refused: rule I[0-9]* at byte [1-9]' ||
        echo "status $status: $text")"
"$planelet" render "$out/terrain.plt" -o "$out/host.ppm" --size 16x16 --fov 5 >/dev/null
serve "$out/terrain.plt" --size 16x16 --fov 5
verdict "... and the next host gets its frame" "$(
    cmp "$out/served.ppm" "$out/host.ppm" 2>&1 || echo "status $status: $text")"
"$planelet" make knot --triangles 20000 -o "$out/knot.ply" >/dev/null
"$planelet" pack "$out/knot.ply" -o "$out/thesis.plt" >/dev/null
serve "$out/thesis.plt"
verdict "thesis nodes cannot be streamed: the host says what can" "$(
    [ "$status" -eq 1 ] && echo "$text" | grep -q 'does not fit .*--nodes compact' ||
        echo "status $status: $text")"
finish
