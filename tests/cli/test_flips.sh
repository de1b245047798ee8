#!/bin/sh
# test_flips.sh - images with one flipped bit: refused by every command, on one line
#
# Positions and bits are random but the same in every run, headers more often.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin flips
run make knot --triangles 300 -o knot.ply
echo '0 0 5 0 0 0 -1 100' | rays ray

# flips_of SEED: 100 lines "BYTE OCTAL": the index of a byte, and its value with one bit flipped.
# Not of section 6, behind all others: what is read whole has its own CRCs.
flips_of() {
    od -An -v -t u1 knot.plt | awk -v seed="$1" '
        { for (i = 1; i <= NF; i++) value[size++] = $i }
        END {
            srand(seed)
            if (value[100] == 3) {
                size = value[140] + 256 * (value[141] + 256 * value[142])
            }
            for (i = 0; i < 100; i++) {
                byte = int(rand() * (i % 4 ? size : 256))
                mask = 2 ^ int(rand() * 8)
                set = int(value[byte] / mask) % 2
                printf "%d %03o\n", byte, value[byte] + (set ? -mask : mask)
            }
        }'
}

# is_refused COMMAND...: trouble, unless it ends with 1 and one line on bad.plt.
is_refused() {
    "$PLANELET" "$@" >out 2>err
    status=$?
    {
        read -r line
        read -r more && echo "$*: a second line: $more"
    } <err
    case $status:$line in
    "1:bad.plt: byte "[0-9]*": "*"; "*) ;;
    *) echo "$*: status $status: $line" ;;
    esac
}

for flags in "--build host" "--build device" "--build none" "--nodes compact"; do
    # shellcheck disable=SC2086
    run pack knot.ply -o knot.plt $flags
    flips_of ${#flags} >flips
    verdict "there are 100 bits of it to flip" "$(
        [ "$status" -eq 0 ] || cat err
        [ "$(wc -l <flips)" -eq 100 ] || wc -l <flips)"
    verdict "pack $flags: info, render and trace refuse 100 images with a flipped bit" "$(
        while read -r byte octal; do
            cp knot.plt bad.plt
            # shellcheck disable=SC2059
            printf "\\$octal" | dd of=bad.plt bs=1 seek="$byte" conv=notrunc 2>/dev/null
            trouble=$(
                is_refused info bad.plt
                is_refused render bad.plt -o x.png --size 16x16
                is_refused trace bad.plt ray x.hits
                is_refused trace bad.plt ray x.hits --source read)
            [ -z "$trouble" ] || echo "byte $byte: $trouble"
        done <flips
        ls x.png x.hits 2>/dev/null
        left_behind)"
done
run pack knot.ply -o knot.plt
verdict "a wrong check of a node is refused by what streams the scene alone" "$(
    at=$(od -An -t u4 -j 140 -N 4 knot.plt | tr -d ' ')
    cp knot.plt bad.plt
    byte=$(od -An -v -t u1 -j "$at" -N 1 knot.plt | tr -d ' ')
    # shellcheck disable=SC2059
    printf "\\$(printf %03o $((byte ^ 1)))" | dd of=bad.plt bs=1 seek="$at" conv=notrunc 2>/dev/null
    for residency in resident streamed; do
        "$PLANELET" render knot.plt -o good.ppm --size 16x16 --residency $residency >out 2>&1 ||
            cat out
        "$PLANELET" render bad.plt -o bad.ppm --size 16x16 --residency $residency >out 2>&1
        echo "$residency $?"
    done >statuses
    [ "$(tr '\n' ' ' <statuses)" = "resident 0 streamed 1 " ] || cat statuses
    grep -q '^bad.plt: byte 256: .*check' out || cat out)"
finish
