#!/bin/sh
# test_start.sh - start-up, stack guard and faults of a Cortex-M, in QEMU
# SPDX-License-Identifier: MIT
. tests/check/report.sh
needs arm-none-eabi-gcc qemu-system-arm || { finish; exit; }

out=$BUILD/mps2_an386/tests
mkdir -p "$out"
elf=$out/faults.elf

# link ELF WORST: the program of faults, with a stack of 1024 bytes.
link() {
    arm-none-eabi-gcc -mthumb -mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16 -std=c11 -O2 \
        -Wall -Wextra -Werror -ffreestanding -fno-tree-loop-distribute-patterns -I. -L. \
        -nostdlib -T board/mps2_an386/memory.ld -Wl,--defsym=plt_arena_bytes=16 \
        -Wl,--defsym=plt_stack_bytes=1024,--defsym=plt_stack_worst="$2" \
        -o "$1" tests/qemu/faults.c platform/cortex_m/*.c 2>&1
}
trouble=$(link "$elf" 1024)
verdict "the program of faults links with the board's memory map" "$trouble"

# try WORD STATUS PATTERN SENTENCE
try() {
    text=$(timeout 60 qemu-system-arm -M mps2-an386 -display none -monitor none -serial null \
        -semihosting-config "enable=on,target=native,arg=faults,arg=$1" -kernel "$elf" 2>&1)
    status=$?
    verdict "$4" "$(
        [ "$status" -eq "$2" ] || echo "status $status, expected $2: $text"
        echo "$text" | grep -q "$3" || echo "printed '$text', expected '$3'")"
}

try float 42 '' "the FPU is on and rounds to nearest"
try memory 42 '' "data is copied and bss cleared"
try paint 42 '' "the painted stack has a mark inside"
try guard 99 'FAULT .*cfsr=000000[0-9a-f]2 ' "a store below the stack is a fault, status 99"
try nowhere 99 'FAULT .*bfar=30000000' "a read from nowhere is a fault that names the address"
try undefined 99 'FAULT .*cfsr=00010000' "an undefined instruction is a fault"

trouble=$(link "$out/refused.elf" 1032)
verdict "a stack smaller than the worst path does not link" "$(
    echo "$trouble" | grep -q 'smaller than the worst path' || echo "linked: $trouble")"
finish
