#!/bin/sh
# check_stack.sh - the worst stack is known, and no frame is a large part of it
# SPDX-License-Identifier: MIT
. tests/check/report.sh
FRAME_LIMIT=${FRAME_LIMIT:-896}
STACK_LIMIT=${STACK_LIMIT:-2048}
out=$BUILD/mps2_an386

if make_board mps2_an386; then
    verdict "the worst path has no recursion, no frame of unknown size, no unknown callee" \
        "$(grep '^error' "$out/stack.txt"; grep -q '^worst' "$out/stack.txt" || echo 'no figure')"
    verdict "no frame of the firmware is larger than $FRAME_LIMIT bytes" "$(
        stack_of "$out" "engine platform board" -v root=machine_start \
            -v indirect='scene_start scene_wait' -v limit="$FRAME_LIMIT" | grep '^error')"
    lines=$(stack_of "$out" "engine platform/bare platform/cortex_m" \
        -v root="$(public_functions)" -v outward=1)
    verdict "no function of the engine needs more than $STACK_LIMIT bytes of stack" "$(
        printf '%s\n' "$lines" | awk -v limit="$STACK_LIMIT" '
            /^error/ { print }
            /^(worst|root)/ { seen++ }
            /^(worst|root)/ && $2 > limit { print $3 " needs " $2 " bytes" }
            END { if (seen < 10) print "only " seen + 0 " functions were seen" }')"
fi

# What the figure rests on: the script must see what it is for.
if needs arm-none-eabi-gcc; then
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
    cat >"$folder/bad.c" <<'C'
int round_one(int n);
int round_two(int n);
int of_any_size(int n);
int by_pointer(int (*f)(int));
int unknown(int);
int calls_unknown(int n);
int round_one(int n) { return n ? round_two(n - 1) + 1 : 0; }
int round_two(int n) { return n ? round_one(n - 2) + 2 : 0; }
int of_any_size(int n) { volatile char a[n]; a[0] = 1; return a[n - 1]; }
int by_pointer(int (*f)(int)) { return f(1) + 1; }
int calls_unknown(int n) { return unknown(n) + 1; }
C
    (cd "$folder" && arm-none-eabi-gcc -mthumb -mcpu=cortex-m4 -O1 -c bad.c \
        -fcallgraph-info=su,da)
    seen() { # SENTENCE ROOT WORDS
        verdict "$1" "$(awk -v root="$2" -f board/tools/stack.awk "$folder/bad.ci" |
            grep -q "$3" || echo "not seen in a file that has it")"
    }
    seen "recursion is seen" round_one "recursion"
    seen "a frame of unknown size is seen" of_any_size "no fixed size"
    seen "a call by pointer is seen" by_pointer "by a pointer"
    seen "a callee without call graph is seen" calls_unknown "no call graph for unknown"
    cat >"$folder/soft.c" <<'C'
double soft(double a, double b);
double soft(double a, double b) { return a * b; }
C
    (cd "$folder" && arm-none-eabi-gcc -mthumb -mcpu=cortex-m3 -O1 -c soft.c \
        -fcallgraph-info=su,da)
    arm-none-eabi-objdump -dtr "$(arm-none-eabi-gcc -mthumb -mcpu=cortex-m3 \
        -print-libgcc-file-name)" | awk -f board/tools/library.awk >"$folder/libgcc.ci"
    verdict "what the compiler's library pushes is seen in its code" "$(
        awk -v root=soft -f board/tools/stack.awk "$folder/soft.ci" "$folder/libgcc.ci" |
            awk '$2 == "__aeabi_dmul" { pushed = $1 } END { exit !(pushed >= 16) }' ||
            echo "__aeabi_dmul pushes r4, r5, r6 and lr; not seen")"
fi
finish
