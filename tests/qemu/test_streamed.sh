#!/bin/sh
# test_streamed.sh - a Cortex-M4F renders scenes that are larger than its memory, in QEMU
#
# The image stays in a file of the host, which the firmware reads by semihosting, block by block.
# Pictures are the host's.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
planelet=$BUILD/host/planelet
folder=$BUILD/mps2_an386-compact-render-stream
out=$folder/tests
scene=$out/terrain.plt
mkdir -p "$out"
needs arm-none-eabi-gcc qemu-system-arm && make_board mps2_an386 PARTS='render compact stream' ||
    { finish; exit; }

value() { # NAME: of the first NAME=value in the text
    echo "$text" | tr ' ' '\n' | sed -n "s/^$1=//p" | head -n 1
}

# is_small WORDS MOST: the engine in $folder.
is_small() {
    bytes=$(find "$folder/engine" -name '*.o' | xargs arm-none-eabi-size |
        awk 'NR > 1 { s += $1 } END { print s }')
    verdict "PARTS='$1': $bytes bytes of engine, at most $2" "$(
        [ "${bytes:-0}" -gt 0 ] && [ "$bytes" -le "$2" ] || echo "$bytes bytes")"
}
is_small "render compact stream" 55296

. tests/qemu/terrain.sh
view=$(sh board/tools/host_view.sh "$out/terrain.plt" 160x120 "$out/host.ppm" --view box)

run() { # KEY=VALUE ...
    # shellcheck disable=SC2086
    text=$(SOURCE=file FIRMWARE=$folder sh board/mps2_an386/run.sh "$scene" \
        size=160x120 ${view#* } "$@" 2>&1)
    status=$?
}

renders() {
    for arena in 65536 262144; do
        run residency=streamed packet=8 arena=$arena "frame=$out/device.ppm"
        verdict "it is rendered in $arena bytes" "$(
            [ "$status" -eq 0 ] && [ "$(value peak)" -le $arena ] || echo "status $status: $text")"
        verdict "... hash and picture are the host's" "$(
            [ "$(value frame_hash)" = "${view%% *}" ] ||
                echo "$(value frame_hash) on the device, ${view%% *} on the host"
            [ "$(tail -c 57600 "$out/host.ppm" | cksum)" = \
                "$(tail -c 57600 "$out/device.ppm" | cksum)" ] || echo "the pixels differ")"
        verdict "... $(value bytes_fetched) bytes fetched, and the stack stays below its bound" "$(
            [ "$(value bytes_fetched)" -gt 262144 ] || echo "little is fetched: $text"
            [ "$(value painted)" -gt 0 ] && [ "$(value painted)" -le "$(value worst)" ] ||
                echo "painted $(value painted), bound $(value worst)")"
    done
}
renders
bytes_by_groups=$(value bytes_fetched)
folder=$BUILD/mps2_an386-compact-frames-render-stream
if make_board mps2_an386 PARTS='render compact frames stream'; then
    renders
    most=$((bytes_by_groups + bytes_by_groups / 8))
    verdict "... by beams hardly more is fetched than by groups, $bytes_by_groups bytes" "$(
        [ "$(value bytes_fetched)" -lt "$most" ] || echo "$text")"
    run residency=streamed packet=2 arena=65536
    verdict "... in packets of 2x2 the hash is the host's, too" "$(
        [ "$status" -eq 0 ] && [ "$(value frame_hash)" = "${view%% *}" ] || echo "$text")"
    damage "$out/damaged.plt"
    scene=$out/damaged.plt
    run residency=streamed packet=8
    verdict "... and damaged blocks are refused, with rule and place" "$(
        [ "$status" -eq 1 ] && echo "$text" | grep -q '^error: .*rule=I.* offset=' || echo "$text")"
    scene=$out/terrain.plt
fi
folder=$BUILD/mps2_an386-compact-render-stream

run residency=resident packet=8
verdict "a whole scene does not fit" "$(
    [ "$status" -eq 1 ] && echo "$text" | grep -q '^error: .*need_bytes' || echo "$text")"
run residency=streamed packet=8 arena=30000
verdict "an arena without room for the least store is refused" "$(
    [ "$status" -eq 1 ] && echo "$text" | grep -q '^error: .*need_bytes' || echo "$text")"
run residency=stream
verdict "an unknown residency is wrong usage" "$(
    [ "$status" -eq 2 ] && echo "$text" | grep -q '^error: .*residency' || echo "$text")"

damage "$out/damaged.plt"
scene=$out/damaged.plt
run residency=streamed packet=8
verdict "damaged blocks are refused when they come, with rule and place" "$(
    [ "$status" -eq 1 ] && echo "$text" | grep -q '^error: .*rule=I.* offset=' || echo "$text")"
scene=$out/terrain.plt

folder=$BUILD/mps2_an386-compact-prefetch-render-stream
make_board mps2_an386 PARTS='render compact stream prefetch' || { finish; exit; }
bytes=$(find "$folder/engine" -name '*.o' | xargs arm-none-eabi-size |
    awk 'NR > 1 { s += $1 } END { print s }')
verdict "... and prefetch: $bytes bytes of engine, at most 57344" "$(
    [ "${bytes:-0}" -gt 0 ] && [ "$bytes" -le 57344 ] || echo "$bytes bytes")"
run residency=streamed packet=8 arena=65536 prefetch=4
verdict "with parts on their way the hash is the host's, too" "$(
    [ "$status" -eq 0 ] && [ "$(value frame_hash)" = "${view%% *}" ] || echo "$text")"
run residency=streamed packet=8 prefetch=9
verdict "more parts than there are tags are wrong usage" "$(
    [ "$status" -eq 2 ] && echo "$text" | grep -q '^error: .*prefetch' || echo "$text")"
folder=$BUILD/mps2_an386-render-stream-thesis scene=$out/thesis.plt
if make_board mps2_an386 PARTS='render thesis stream'; then
    is_small "render thesis stream" 49152
    "$planelet" pack "$out/terrain.ply" -o "$scene" --treelet 16 >/dev/null 2>&1
    view=$(sh board/tools/host_view.sh "$scene" 160x120 "$out/host.ppm" --view box)
    renders
    scene=$out/terrain.plt
    run residency=streamed
    verdict "compact blocks are refused, and their part is named" "$(
        [ "$status" -eq 1 ] && echo "$text" | grep -q '^error: .*PLT_WITH_STREAMED_COMPACT' ||
            echo "$text")"
fi
finish
