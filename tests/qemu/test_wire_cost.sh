#!/bin/sh
# test_wire_cost.sh - instructions per pixel of the wire's codec on a Cortex-M4F, in QEMU
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. board/tools/limit.sh
needs arm-none-eabi-gcc qemu-system-arm && make_board mps2_an386 || { finish; exit; }

out=$BUILD/mps2_an386/tests
mkdir -p "$out"
elf=$out/wire_cost.elf
trouble=$(arm-none-eabi-gcc -mthumb -mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16 -std=c11 \
    -O2 -Wall -Wextra -Werror -ffreestanding -fbuiltin -fno-tree-loop-distribute-patterns \
    -ffunction-sections -Wl,--gc-sections -I. -L. -nostdlib -T board/mps2_an386/memory.ld \
    -Wl,--defsym=plt_arena_bytes=16,--defsym=plt_stack_bytes=4096,--defsym=plt_stack_worst=4096 \
    -o "$elf" tests/qemu/wire_cost.c platform/wire/wire_format.c platform/wire/model.c \
    platform/wire/tile_encode.c platform/wire/tile_decode.c \
    engine/base/crc32.c platform/bare/*.c platform/cortex_m/*.c platform/cortex_m/armv7m/*.c 2>&1)
verdict "the codec links for a Cortex-M4F without a library" "$trouble"

symbol() {
    arm-none-eabi-nm "$elf" | awk -v name="$1" '$3 == name { print "0x" $1 }'
}
plugin=$BUILD/mps2_an386/libcount.so,out=$out/wire_cost.txt
for region in hash encode decode near; do
    plugin=$plugin,region=$region:$(symbol wire_${region}_begin):$(symbol wire_${region}_end)
done
QEMU_SECONDS=60
limited qemu-system-arm -M mps2-an386 -display none -monitor none -serial null -icount shift=0 \
    -semihosting-config enable=on,target=native -plugin "$plugin" -kernel "$elf"
status=$?
verdict "tiles encoded there have the bytes they have here, and come back bit for bit" "$(
    [ "$status" -eq 42 ] || echo "status $status")"

# 64 tiles of 256 pixels
costs=$(tr ' ' '\n' <"$out/wire_cost.txt" | awk -F= '
    /^(hash|encode|decode|near)=/ { printf "%s %.1f  ", $1, $2 / 16384 }')
echo "    instructions per pixel of RGB565: $costs"
verdict "a pixel costs at most 25 instructions to look at, 350 or 300 to encode, 360 to decode" "$(
    echo "$costs" | awk '
        function out(x, most) { return !(x > 0 && x <= most) }
        out($2, 25) || out($4, 350) || out($6, 360) || out($8, 300)')"
finish
