#!/bin/sh
# test_lanes.sh - every lanes header that a board can have, operation by operation, on its CPU
#
# What tests/engine/test_lanes.c does on the host, by a firmware (tests/boards/lanes.c): its lanes
# beside the scalar reference, both compiled for the board.
# SPDX-License-Identifier: MIT
. tests/check/report.sh

tested=0
operations=$(($(grep -c '^    X(' tests/lanes/ops.h) + 1)) # and a product with a sum behind it
for board in $(boards); do
    needs "$(cross_of "$board")gcc" || continue
    cpu=$(sed -n 's/^CPU := //p' "board/$board/board.mk")
    # shellcheck disable=SC2086
    for lanes in $(sh platform/lanes.sh offered "$(cross_of "$board")gcc" $cpu |
        awk '$1 !~ /^scalar/ { print $1 }'); do
        out=$BUILD/$board-lanes
        make_board "$board" PROGRAM=lanes LANES="$lanes" || continue
        text=$(FIRMWARE=$out QEMU_SECONDS=200 sh "board/$board/run.sh" "" "" 2>&1)
        status=$?
        verdict "$board: $lanes has the bits of the scalar lanes, or says that it flushed" "$(
            [ "$status" -eq 42 ] || echo "status $status"
            echo "$text" | grep -v ' differ=0$' | grep 'differ=')"
        verdict "... in all $operations operations" "$(
            [ "$(echo "$text" | grep -c ' differ=0$')" -eq "$operations" ] || echo "$text")"
        tested=$((tested + 1))
    done
done
verdict "lanes of boards were compared: $tested" "$([ "$tested" -ge 1 ] || echo "none")"
finish
