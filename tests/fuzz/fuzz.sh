#!/bin/sh
# fuzz.sh [TARGET...] - the libFuzzer targets, SECONDS each (60)
#
# A target is tests/fuzz/fuzz_TARGET.c; all without a word. What it found stays in
# build/fuzz/TARGET: run the program with it to see it again. SPDX-License-Identifier: MIT
. tests/check/report.sh
seconds=${SECONDS_EACH:-60}
work=$BUILD/fuzz

sources_of() { # TARGET
    case $1 in
    wire_tile) echo platform/wire/tile_*.c platform/wire/model*.c platform/wire/wire_format.c ;;
    wire_peer)
        echo tests/reference/wire_fake.c engine/base/crc32.c
        find platform/wire -name '*.c' ! -name device.c
        ;;
    *) find engine -name '*.c' ;;
    esac
}

run() { # TARGET
    mkdir -p "$work/$1/corpus"
    # shellcheck disable=SC2046
    clang -g -O1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all -I. \
        "tests/fuzz/fuzz_$1.c" $(sources_of "$1") -lm -o "$work/$1/program" \
        >"$work/$1/log" 2>&1 &&
        "$work/$1/program" -max_total_time="$seconds" -timeout=20 -artifact_prefix="$work/$1/" \
            -print_final_stats=1 "$work/$1/corpus" >>"$work/$1/log" 2>&1
    echo $? >"$work/$1/status"
}

command -v clang >/dev/null || {
    echo "there is no clang here: install the packages clang and libclang-rt-dev" >&2
    exit 2
}
[ $# -gt 0 ] || set -- image blocks wire_tile wire_peer
for target; do
    [ -e "tests/fuzz/fuzz_$target.c" ] || {
        echo "there is no tests/fuzz/fuzz_$target.c; the targets are image, blocks, wire_tile" \
            "and wire_peer" >&2
        exit 2
    }
    echo "    $target: $seconds s, its words are in $work/$target/log"
    run "$target"
    units=$(sed -n 's/^stat::number_of_executed_units: *//p' "$work/$target/log")
    verdict "$target: ${units:-no} inputs in $seconds s, and none breaks a promise" "$(
        [ "$(cat "$work/$target/status")" -eq 0 ] || tail -n 20 "$work/$target/log"
        [ "${units:-0}" -gt 0 ] || echo "no statistics: it did not try anything")"
done
finish
