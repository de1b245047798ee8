#!/bin/sh
# test_wired.sh - the firmware that is fed over a serial line, in QEMU, against the host
# SPDX-License-Identifier: MIT
. tests/check/report.sh
planelet=$BUILD/host/planelet
out=$BUILD/mps2_an386-wired/tests
mkdir -p "$out"
needs arm-none-eabi-gcc qemu-system-arm || { finish; exit; }

# ---- the demo, two frames of it ----

rm -f "$out/device.ppm"
text=$(FRAMES=2 SIZE=160x120 BOARD_LOG="$out/log.txt" BUILD="$BUILD" MAKE="$MAKE" \
    timeout 300 sh board/tools/demo.sh -o "$out/device.ppm" --show --verbose 2>&1)
status=$?
scene=$BUILD/demo/marbles-compact.plt
verdict "make demo-firmware ends well, and draws the frames in the terminal" "$(
    [ "$status" -eq 0 ] || echo "status $status: $text"
    [ "$(echo "$text" | grep -c '[-=+*#]\{4\}')" -ge 5 ] || echo "$text")"

frame=57615 # bytes of a PPM of 160x120
"$planelet" render "$scene" -o "$out/host_{}.ppm" --size 160x120 --orbit 2 >/dev/null
"$planelet" render "$scene" -o "$out/host.ppm" --size 160x120 >/dev/null
verdict "the first frame that came is the host's direct render, bit for bit" "$(
    head -c $frame "$out/device.ppm" | cmp - "$out/host_000.ppm" 2>&1)"
"$planelet" serve "$scene" --emulate 262144 -o "$out/emulated.ppm" --size 160x120 \
    --orbit 2 2>/dev/null
verdict "both frames are those of a device that the host emulates" "$(
    [ "$(wc -c <"$out/device.ppm")" -eq $((2 * frame)) ] || echo "not two frames"
    cmp "$out/device.ppm" "$out/emulated.ppm" 2>&1)"

value() { # NAME: of the last NAME=value in the log
    tr ' ' '\n' <"$out/log.txt" | sed -n "s/^$1=//p" | tail -n 1
}
worst=$(sed -n 's/^worst \([0-9]*\).*/\1/p' "$BUILD/mps2_an386-wired/stack.txt")
verdict "image and arena fit into 262,144 bytes, the stack stays below its bound" "$(
    [ "$(value memory)" -eq 262144 ] || echo "memory $(value memory)"
    [ "$(value painted)" -gt 0 ] && [ "$(value painted)" -le "$worst" ] ||
        echo "painted $(value painted), bound $worst")"
verdict "the ring behind the interrupt lost no byte, and no report was lost" "$(
    [ "$(value lost_bytes)" = 0 ] && [ "$(value lost_reports)" = 0 ] || cat "$out/log.txt")"
verdict "the bound has the interrupt and what the CPU stacks for it on top" "$(
    stack=$BUILD/mps2_an386-wired/stack.txt
    grep -q ' an interrupt$' "$stack" && grep -q ' serial_interrupt$' "$stack" || cat "$stack"
    awk '$1 == "worst" { worst = $2; next } { sum += $1 } END { exit sum != worst }' "$stack" ||
        echo "the frames do not add up to it")"
sed -n 's/^frame/    &/p' "$out/log.txt" | tail -n 1
verdict "gcc compiles the wired firmware without a warning" "$(
    find "$BUILD/mps2_an386-wired" -name '*.log' -size +0 -exec cat {} +)"

# ---- Ctrl-C in the midst of the demo ----

trouble=$($CC -std=c11 -Wall -Wextra tests/cli/pty.c -o "$out/pty" 2>&1)
for bytes in 1 12000; do
    temporary=$(mktemp -d) # a socket's path must be short
    (unset NO_COLOR COLUMNS LINES
        TMPDIR=$temporary FRAMES=100 SIZE=96x64 TERM=xterm BUILD="$BUILD" MAKE="$MAKE" \
            timeout 100 "$out/pty" $bytes sh board/tools/demo.sh >"$out/seen" 2>&1 </dev/null)
    status=$?
    verdict "Ctrl-C after $bytes bytes of it: no board, no folder and no colour stays behind" "$(
        echo "$trouble"
        [ "$status" -eq 130 ] || echo "status $status"
        ls "$temporary"
        colour=$(tr '\033' '\n' <"$out/seen" | grep -a '^\[[0-9;]*m' | tail -n 1)
        case $colour in '' | '[0m'*) ;; *) echo "the last colour was $colour" ;; esac)"
    rm -rf "$temporary"
done

# ---- hosts that come and go ----

folder=$(mktemp -d)
board=
end() {
    [ -z "$board" ] || { kill "$board" && wait "$board"; } 2>/dev/null
    board=
}
trap 'end; rm -rf "$folder"' EXIT

# board [parameter ...]: starts one.
board() {
    BUILD=$BUILD sh board/mps2_an386/wired.sh "$folder/wire" "$@" >"$out/log.txt" 2>&1 &
    board=$!
}

# serve SCENE [option ...]: one frame into served.ppm; sets text and status.
serve() {
    rm -f "$out/served.ppm"
    text=$(timeout 200 "$planelet" serve --size 160x120 "$@" --socket "$folder/wire" \
        -o "$out/served.ppm" --verbose 2>&1)
    status=$?
}

board report=128
"$planelet" make knot --triangles 20000 -o "$out/knot.ply" >/dev/null
"$planelet" pack "$out/knot.ply" -o "$out/large.plt" >/dev/null
serve "$out/large.plt" --report 128
verdict "a scene larger than the memory: the host says so, and ends" "$(
    [ "$status" -eq 1 ] || echo "status $status: $text"
    echo "$text" | grep -q 'does not fit in its 262144' || echo "$text")"
serve "$scene" --report 128
verdict "... and the next host's scene is rendered" "$(
    cmp "$out/served.ppm" "$out/host.ppm" 2>&1 || echo "$text")"
serve "$scene" --report 128
verdict "a host that comes again gets its frame without sending the scene again" "$(
    cmp "$out/served.ppm" "$out/host.ppm" 2>&1 || echo "$text"
    reports=$(echo "$text" | sed -n 's/.*reports \([0-9]*\) out.*/\1/p')
    [ "${reports:-1000}" -lt 300 ] || echo "${reports:-no} reports went out")"
end

# ---- a ring too small for a report: what comes in a burst is lost ----
#
# A report is 66 bytes on the line. QEMU knows no baud rate: where the machine has other work it
# hands over a report at once, and none ever fits into a ring of 32 bytes; where it has none, a
# ring of 64 may lose nothing. So both are tried, by turns, until one has lost bytes and sent the
# frame. What comes has to be right in any case.

all=$BUILD
trouble=
for ring in 32 64; do
    trouble=$trouble$($MAKE -s BOARD=mps2_an386 PROGRAM=wired BUILD="$all/ring_$ring" \
        FIRMWARE_FLAGS="-DPLT_PACKET_SIDE_MAX=8 -DPLT_RING_BYTES=$ring" \
        "$all/ring_$ring/mps2_an386-wired/firmware.elf" 2>&1 >/dev/null)
done
"$planelet" make knot --triangles 300 -o "$out/knot.ply" >/dev/null
"$planelet" pack "$out/knot.ply" -o "$out/small.plt" --nodes compact --geometry lattice:14 \
    >/dev/null 2>&1
"$planelet" render "$out/small.plt" -o "$out/small.ppm" --size 64x48 >/dev/null
said="no ring lost bytes and sent the frame:"
for ring in 32 64 32 64 32 64 32 64; do
    BUILD=$all/ring_$ring board
    serve "$out/small.plt" --size 64x48 --timeout 20
    end
    lost=$(value lost_bytes)
    if [ "$status" -eq 0 ] && ! cmp "$out/served.ppm" "$out/small.ppm" >/dev/null 2>&1; then
        said="a frame of a ring of $ring is wrong"
        break
    elif [ "$status" -eq 0 ] && [ "${lost:-0}" -gt 0 ]; then
        said=
        break
    fi
    said="$said
$ring: $text; lost $lost"
done
verdict "a ring smaller than a report: bytes are lost and counted, the frame is right" \
    "$trouble$said"
sed -n 's/^frame/    &/p' "$out/log.txt" | tail -n 1
BUILD=$all

text=$(FRAMES=1 SIZE=64x48 SCENE="$out/small.plt" timeout 100 \
    $MAKE -s BOARD=mps2_an386 PROGRAM=wired BUILD="$BUILD" run 2>&1)
status=$?
verdict "make BOARD=... PROGRAM=wired run SCENE=... serves that scene to it" "$(
    [ "$status" -eq 0 ] && [ "$(echo "$text" | grep -c '[-=+*#]\{4\}')" -ge 5 ] || echo "$text")"
text=$($MAKE -s BOARD=mps2_an386 PROGRAM=wired BUILD="$BUILD" run SCENE=none.plt 2>&1)
verdict "... and says what to do when there is no such scene" "$(
    echo "$text" | grep -q 'none.plt cannot be read; planelet pack makes' || echo "$text")"

board report=7
serve "$scene" --timeout 5
kill "$board" 2>/dev/null # has ended by itself
wait "$board"
status=$?
board=
verdict "a size of reports that there is not: status 2, a line that says so" "$(
    [ "$status" -eq 2 ] || echo "status $status"
    grep -q '^error: report=BYTES' "$out/log.txt" || cat "$out/log.txt")"
finish
