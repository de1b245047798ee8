#!/bin/sh
# test_mps2_an386.sh - the firmware of a Cortex-M4F against the host, in QEMU
# SPDX-License-Identifier: MIT
. tests/check/report.sh
planelet=$BUILD/host/planelet
out=$BUILD/mps2_an386/tests
mkdir -p "$out"
needs arm-none-eabi-gcc qemu-system-arm && make_board mps2_an386 || { finish; exit; }

# firmware SCENE|"" PARAMETER...: sets text and status.
firmware() {
    text=$(sh board/mps2_an386/run.sh "$@" 2>&1)
    status=$?
}

value() { # NAME: of the first NAME=value in the text
    echo "$text" | tr ' ' '\n' | sed -n "s/^$1=//p" | head -n 1
}

# scene NAME KIND [make options] -- [pack options]
scene() {
    name=$1 kind=$2
    shift 2
    options=
    while [ $# -gt 0 ] && [ "$1" != -- ]; do
        options="$options $1"
        shift
    done
    [ $# -gt 0 ] && shift
    # shellcheck disable=SC2086
    "$planelet" make "$kind" $options -o "$out/$name.ply" >/dev/null &&
        "$planelet" pack "$out/$name.ply" "$@" -o "$out/$name.plt" >/dev/null ||
        verdict "the scene $name is made" "planelet failed"
}

# same SENTENCE SCENE SIZE ["host options"] [parameter ...]: the same frame on both.
same() {
    sentence=$1 name=$2 size=$3 host=$4
    shift 4
    # shellcheck disable=SC2086
    view=$(sh board/tools/host_view.sh "$out/$name.plt" "$size" "$out/host.ppm" --view box $host)
    rm -f "$out/device.ppm"
    mapped=$out/$name.plt
    case "$*" in *scene=*) mapped= ;; esac
    # shellcheck disable=SC2086
    firmware "$mapped" "size=$size" ${view#* } "frame=$out/device.ppm" "$@"
    verdict "$sentence: hash and picture are the host's" "$(
        [ "$status" -eq 0 ] || echo "status $status: $text"
        [ "$(value frame_hash)" = "${view%% *}" ] ||
            echo "$(value frame_hash) on the device, ${view%% *} on the host"
        bytes=$((${size%x*} * ${size#*x} * 3))
        [ "$(tail -c "$bytes" "$out/host.ppm" | cksum)" = \
            "$(tail -c "$bytes" "$out/device.ppm" | cksum)" ] || echo "the pixels differ")"
    verdict "$sentence: the stack stays below its bound" "$(
        [ "$(value painted)" -gt 0 ] && [ "$(value painted)" -le "$(value worst)" ] ||
            echo "painted $(value painted), bound $(value worst)"
        [ "$(value stored)" -le "$(value worst)" ] ||
            echo "a store at depth $(value stored), bound $(value worst)")"
    echo "$text" | sed -n 's/^instructions/    &/p'
}

scene marbles marbles
scene knot knot --triangles 2000
scene small knot --triangles 500 -- --build device
scene list ground -- --build none
scene large knot --triangles 20000 -- --build device
same "8,800 marbles in flash" marbles 160x120 ""
same "marbles, packets of 4, two-stage order" marbles 80x60 "--packet 4 --walk two-stage" \
    packet=4 walk=two
same "a knot fetched into the arena" knot 81x61 "" "scene=$out/knot.plt"
same "a tree built on the device" small 80x60 ""
same "a list without a tree" list 40x30 "--shader normal" shader=normal

# built NAME LEAF MAKE LEAST: compact blocks of so many triangles, built in the arena.
built() {
    scene "$1" knot --triangles "$3" -- --nodes compact --geometry lattice:14 --leaf "$2" \
        --build device 2>/dev/null
    same "$4 triangles and more, $2 per list, built on the device" "$1" 320x240 ""
    verdict "... within 262,144 bytes" "$(
        [ "$(value triangles)" -ge "$4" ] || echo "$(value triangles) triangles"
        [ "$(value peak)" -gt 0 ] && [ "$(value peak)" -le 262144 ] || echo "peak $(value peak)")"
    echo "    $(($(value open) / $(value triangles))) instructions per triangle to open and build"
}
built blocks2 2 35400 35000
built blocks4 4 45400 45000

# refused SENTENCE STATUS PATTERN SCENE [parameter ...]
refused() {
    sentence=$1 wanted=$2 pattern=$3
    shift 3
    firmware "$@"
    verdict "$sentence" "$(
        [ "$status" -eq "$wanted" ] || echo "status $status, expected $wanted: $text"
        echo "$text" | grep -q "$pattern" || echo "printed '$text', expected '$pattern'")"
}

head -c 5000 "$BUILD/mps2_an386/firmware.elf" >"$out/garbage.plt"
head -c 300 "$out/knot.plt" >"$out/short.plt"
: >"$out/empty.plt"
refused "garbage for an image: status 1, the rule it breaks" 1 '^error: .*rule=R' \
    "$out/garbage.plt"
refused "an image cut short: status 1, the rule it breaks" 1 '^error: .*rule=R' "$out/short.plt"
refused "an empty image: status 1" 1 '^error: ' "$out/empty.plt"
refused "a scene too large for the arena: status 1, the bytes it needs" 1 \
    '^error: .*need_bytes=[1-9]' "$out/large.plt"
refused "an arena made too small: status 1, the bytes it needs" 1 '^error: .*need_bytes=[1-9]' \
    "$out/marbles.plt" arena=4096
refused "a missing file: status 1" 1 '^error: cannot open' "" "scene=$out/missing.plt"
refused "a frame larger than the board's memory: status 1" 1 \
    '^error: the frame has 48000000 bytes, and this board has room for 4194304$' \
    "$out/knot.plt" size=4000x4000
refused "an unknown parameter: status 2" 2 '^error: unknown parameter' "$out/knot.plt" colour=red
finish
