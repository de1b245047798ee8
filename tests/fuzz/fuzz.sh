#!/bin/sh
# fuzz.sh [TARGET...] - the libFuzzer targets, SECONDS each (60)
#
# A target is tests/fuzz/fuzz_TARGET.c; all without a word. What it found stays in
# build/fuzz/TARGET: run the program with it to see it again. A target may have first
# inputs (seeds.sh) and words (TARGET.dict). An input has 10 seconds and 1 GiB of memory.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/fuzz/seeds.sh
PLANELET=${PLANELET:-$BUILD/host/planelet}
all='image blocks sequence instances surface materials mtl wire_tile wire_peer ply obj stl polygon'
all="$all recipe png"
seconds=${SECONDS_EACH:-60}
work=$BUILD/fuzz

sources_of() { # TARGET
    case $1 in
    wire_tile) echo platform/wire/tile_*.c platform/wire/model*.c platform/wire/wire_format.c ;;
    wire_peer)
        echo tests/reference/wire_fake.c engine/base/crc32.c
        find platform/wire -name '*.c' ! -name device.c
        ;;
    ply | obj | stl) find engine host_tools/base host_tools/mesh host_tools/pack -name '*.c' ;;
    mtl) ls host_tools/base/*.c host_tools/mesh/materials.c host_tools/mesh/mtl.c \
        host_tools/mesh/scan.c host_tools/mesh/decimal.c ;;
    polygon) echo host_tools/mesh/orient2.c host_tools/mesh/polygon*.c ;;
    recipe) # the target has an input of its own
        find engine host_tools/base host_tools/mesh host_tools/pack -name '*.c' ! -name input.c
        ;;
    png)
        echo host_tools/base/fail.c host_tools/picture/picture.c host_tools/picture/png_read.c
        echo engine/base/crc32.c
        ls host_tools/picture/inflate.c host_tools/picture/deflate*.c \
            host_tools/picture/huffman.c host_tools/picture/bits.c
        ;;
    *) find engine -name '*.c' && echo tests/reference/room.c ;;
    esac
}

# The files of a target are short; the words of its format are many.
options_of() { # TARGET
    if [ -e "tests/fuzz/$1.dict" ]; then
        echo "-dict=tests/fuzz/$1.dict -max_len=4096"
    fi
}

run() { # TARGET
    mkdir -p "$work/$1/corpus" "$work/$1/seeds"
    seeds "$1" "$work/$1/seeds" || return
    # shellcheck disable=SC2046
    clang -std=c11 -g -O1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all \
        -D_POSIX_C_SOURCE=200809L -D_FILE_OFFSET_BITS=64 -I. \
        "tests/fuzz/fuzz_$1.c" $(sources_of "$1") -lm -o "$work/$1/program" \
        >"$work/$1/log" 2>&1 &&
        "$work/$1/program" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=1024 \
            -artifact_prefix="$work/$1/" -print_final_stats=1 $(options_of "$1") \
            "$work/$1/corpus" "$work/$1/seeds" >>"$work/$1/log" 2>&1
    echo $? >"$work/$1/status"
}

command -v clang >/dev/null || {
    echo "there is no clang here: install the packages clang and libclang-rt-dev" >&2
    exit 2
}
# shellcheck disable=SC2086
[ $# -gt 0 ] || set -- $all
for target; do
    [ -e "tests/fuzz/fuzz_$target.c" ] || {
        echo "there is no tests/fuzz/fuzz_$target.c; the targets are $all" >&2
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
