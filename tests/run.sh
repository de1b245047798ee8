#!/bin/sh
# run.sh PROGRAM|SCRIPT.sh... - runs tests and adds up their counts
#
# A test is a program, or a script for sh, that prints "pass SENTENCE" and
# "FAIL SENTENCE" lines and ends in "N passed, N failed". One that crashes,
# runs over its time or prints no count is one failure more. The failures are
# listed again at the end, each with the last of what it said, before the sum.
#
# TEST_JOBS tests run at a time, as many as there are processors, two at most,
# unless it says otherwise; what they print comes in the order of the arguments.
# Scripts outside tests/cli build what they test, all in one tree: one at a time, but for those
# that say "# Beside builders: " and why they may run beside one, as they write no file of its.
# SPDX-License-Identifier: MIT
limit=${TEST_SECONDS:-2400} # check_variants.sh builds and runs all programs
jobs=${TEST_JOBS:-$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)}
[ -n "$TEST_JOBS" ] || [ "$jobs" -le 2 ] || jobs=2
passed=0 failed=0
room=$(mktemp -d)
workers=
trap 'rm -rf "$room"' EXIT
trap '[ -z "$workers" ] || kill $workers 2>/dev/null; wait; exit 130' HUP INT TERM

# What a shell runs in the background ignores interrupts; tests are to meet them as they are.
plainly='env --default-signal=INT,QUIT'
$plainly true 2>/dev/null || plainly=

# run NUMBER TEST: leaves what it printed in NUMBER.log, then its status and seconds in NUMBER.end.
run() {
    began=$(date +%s)
    case $2 in
    *.sh) $plainly timeout "$limit" sh "$2" >"$room/$1.log" 2>&1 & ;;
    # shellcheck disable=SC2086
    *) $plainly timeout "$limit" $EMULATOR "$2" >"$room/$1.log" 2>&1 & ;;
    esac
    child=$!
    wait "$child"
    echo "$? $(($(date +%s) - began))" >"$room/$1.status"
    mv "$room/$1.status" "$room/$1.end"
}

# builds TEST: it is one of those that run one at a time.
builds() {
    case $1 in
    */cli/*) return 1 ;;
    *.sh) ! grep -q '^# Beside builders: ' "$1" ;;
    *) return 1 ;;
    esac
}

# work builders|others|all TEST...: runs those that nobody has begun.
work() {
    kind=$1 number=0 child=
    shift
    trap '[ -z "$child" ] || kill "$child" 2>/dev/null; exit 1' TERM
    trap - EXIT
    for test in "$@"; do
        number=$((number + 1))
        case $kind in
        builders) builds "$test" || continue ;;
        others) ! builds "$test" || continue ;;
        esac
        mkdir "$room/$number" 2>/dev/null || continue
        run "$number" "$test"
    done
}

# Some worker is: one that was killed ends no test.
are_alive() {
    for worker in $workers; do
        kill -0 "$worker" 2>/dev/null && return 0
    done
    return 1
}

# report NUMBER TEST: prints what it printed, once it has ended, and counts.
report() {
    while [ ! -e "$room/$1.end" ] && are_alive; do
        sleep 0.1
    done
    [ -e "$room/$1.end" ] || echo "unknown 0" >"$room/$1.end"
    [ -e "$room/$1.log" ] || : >"$room/$1.log"
    read -r status seconds <"$room/$1.end"
    log=$room/$1.log name=${2##*/}
    printf '== %s (%s s)\n' "$name" "$seconds"
    cat "$log"
    counts=$(sed -n 's/^\([0-9][0-9]*\) passed, \([0-9][0-9]*\) failed$/\1 \2/p' "$log" | tail -n 1)
    p=${counts% *} f=${counts#* }
    passed=$((passed + ${p:-0})) failed=$((failed + ${f:-0}))
    awk -v name="$name" '
        /^    / { detail[++count] = $0; next }
        sub(/^FAIL /, "") {
            print name ": " $0
            for (i = count > LINES ? count - LINES + 1 : 1; i <= count; i++) print detail[i]
        }
        { count = 0 }' LINES=6 "$log" >>"$room/failures"
    if [ -z "$counts" ] || { [ "$status" != 0 ] && [ "${f:-0}" -eq 0 ]; }; then
        echo "FAIL $name ended with status $status"
        echo "$name: ended with status $status" >>"$room/failures"
        failed=$((failed + 1))
    fi
}

# A test that runs tests of its own runs them one after another.
export TEST_JOBS=1
if [ "$jobs" -gt 1 ]; then
    (work builders "$@"; work others "$@") &
else
    work all "$@" &
fi
workers=$!
while [ "$jobs" -gt 1 ]; do
    work others "$@" &
    workers="$workers $!"
    jobs=$((jobs - 1))
done
number=0
for test in "$@"; do
    number=$((number + 1))
    report "$number" "$test"
done
wait
if [ -s "$room/failures" ]; then
    echo "== failed"
    cat "$room/failures"
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
