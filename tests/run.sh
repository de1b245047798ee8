#!/bin/sh
# run.sh PROGRAM|SCRIPT.sh... - runs tests and adds up their counts
#
# A test is a program, or a script for sh, that prints "pass SENTENCE" and
# "FAIL SENTENCE" lines and ends in "N passed, N failed". One that crashes,
# runs over its time or prints no count is one failure more. The failures are
# listed again at the end, each with the last of what it said, before the sum.
# SPDX-License-Identifier: MIT
limit=${TEST_SECONDS:-1200} # check_variants.sh builds and runs all programs
passed=0 failed=0
log=$(mktemp) failures=$(mktemp)
trap 'rm -f "$log" "$failures"' EXIT
for program in "$@"; do
    printf '== %s\n' "${program##*/}"
    case $program in
    *.sh) timeout "$limit" sh "$program" >"$log" 2>&1 ;;
    *) timeout "$limit" "$program" >"$log" 2>&1 ;;
    esac
    status=$?
    cat "$log"
    counts=$(sed -n 's/^\([0-9][0-9]*\) passed, \([0-9][0-9]*\) failed$/\1 \2/p' "$log" | tail -n 1)
    p=${counts% *} f=${counts#* }
    passed=$((passed + ${p:-0})) failed=$((failed + ${f:-0}))
    awk -v name="${program##*/}" '
        /^    / { detail[++count] = $0; next }
        sub(/^FAIL /, "") {
            print name ": " $0
            for (i = count > LINES ? count - LINES + 1 : 1; i <= count; i++) print detail[i]
        }
        { count = 0 }' LINES=6 "$log" >>"$failures"
    if [ -z "$counts" ] || { [ "$status" -ne 0 ] && [ "${f:-0}" -eq 0 ]; }; then
        echo "FAIL ${program##*/} ended with status $status"
        echo "${program##*/}: ended with status $status" >>"$failures"
        failed=$((failed + 1))
    fi
done
if [ -s "$failures" ]; then
    echo "== failed"
    cat "$failures"
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
