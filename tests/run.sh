#!/bin/sh
# run.sh PROGRAM... - runs test programs and adds up their counts.
# A program that crashes, runs over its time or prints no count is one
# failure more. SPDX-License-Identifier: MIT
limit=${TEST_SECONDS:-600}
passed=0 failed=0
for program in "$@"; do
    printf '== %s\n' "${program##*/}"
    log=$(mktemp)
    timeout "$limit" "$program" >"$log" 2>&1
    status=$?
    cat "$log"
    counts=$(sed -n 's/^\([0-9][0-9]*\) passed, \([0-9][0-9]*\) failed$/\1 \2/p' "$log" | tail -n 1)
    rm -f "$log"
    p=${counts% *} f=${counts#* }
    passed=$((passed + ${p:-0})) failed=$((failed + ${f:-0}))
    if [ -z "$counts" ] || { [ "$status" -ne 0 ] && [ "${f:-0}" -eq 0 ]; }; then
        echo "FAIL ${program##*/} ended with status $status"
        failed=$((failed + 1))
    fi
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
