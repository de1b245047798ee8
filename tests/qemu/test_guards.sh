#!/bin/sh
# test_guards.sh - start-up, stack guard and faults of every board that an emulator runs
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. board/tools/limit.sh

# try WORD STATUS PATTERN SENTENCE
try() {
    text=$(FIRMWARE=$out QEMU_SECONDS=60 sh "board/$board/run.sh" "" "$1" 2>&1)
    status=$?
    verdict "$board: $4" "$(
        [ "$status" -eq "$2" ] || echo "status $status, expected $2: $text"
        echo "$text" | grep -q "$3" || echo "printed '$text', expected '$3'")"
}

# Where it was: the instruction, or of a stack that has run over the call nearest to its end.
where='FAULT .*(pc|near)=0*[1-9a-f][0-9a-f]*'
named=0
for board in $(boards); do
    out=$BUILD/$board-faults
    make_board "$board" PROGRAM=faults || continue
    verdict "$board: gcc compiles start-up without a warning" "$(
        find "$out" -name '*.log' -size +0 -exec cat {} +)"
    try float 42 '' "floats round to nearest, subnormals stay, roots are exact"
    try memory 42 '' "data is copied and bss cleared"
    try paint 42 '' "the painted stack has a mark inside"
    # Of an Armv8-M it is the limit that says so, not what lies below the stack: STKOF.
    over=FAULT
    grep -q armv8m "board/$board/board.mk" && over='FAULT .*cfsr=00100000'
    try overrun 99 "$over" "a stack that runs over its end is a fault, status 99"
    verdict "$board: ... which says where" "$(echo "$text" | grep -Eq "$where" || echo "$text")"
    if ! grep -q '^GUARD := none' "board/$board/board.mk"; then
        try store 99 FAULT "a store below the stack is a fault"
        verdict "$board: ... which says where" "$(echo "$text" | grep -Eq "$where" || echo "$text")"
    fi
    try undefined 99 FAULT "an undefined instruction is a fault"
    verdict "$board: ... which says where" "$(echo "$text" | grep -Eq "$where" || echo "$text")"
    FIRMWARE=$out QEMU_SECONDS=60 sh "board/$board/run.sh" "" nowhere 2>&1 |
        grep -q 'FAULT .*=30000000' && named=$((named + 1))
done
# Not every CPU names it, and some have memory there: of all boards it is asked.
[ -n "$ON" ] ||
    verdict "a read from nowhere is a fault that names the address on $named boards" "$(
        [ "$named" -gt 0 ] || echo "on none")"

QEMU_SECONDS=2 FIRMWARE=$out sh "board/$board/run.sh" "" limit >/dev/null 2>&1
status=$?
verdict "a firmware without end is ended after QEMU_SECONDS, status 124" "$(
    [ "$status" -eq 124 ] || echo "status $status")"
(QEMU_SECONDS=1
    limit_self
    while :; do :; done) 2>/dev/null
status=$?
verdict "... and one that is the shell's process after so much CPU time" "$(
    [ "$status" -gt 128 ] || echo "status $status")"

# refused PATTERN SENTENCE VARIABLE=...: does not link.
refused() {
    pattern=$1 sentence=$2
    shift 2
    text=$($MAKE -s BOARD="$board" PROGRAM=faults BUILD="$BUILD/refused" "$@" 2>&1) &&
        text="linked: $text"
    verdict "$sentence" "$(echo "$text" | grep -q "$pattern" || echo "$text")"
}
refused 'smaller than the worst path' "a stack smaller than the worst path does not link" \
    STACK_BYTES=64
refused "arena of 1048576 bytes and a stack of 1024 do not fit on $board: of its [0-9]* bytes" \
    "an arena that does not fit does not link, and both sizes are said" \
    ARENA_BYTES=1048576 STACK_BYTES=1024
rm -rf "$BUILD/refused"
finish
