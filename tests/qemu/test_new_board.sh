#!/bin/sh
# test_new_board.sh - a new board is a folder, and nothing outside it is touched
#
# The templates build. Then, in a copy of the tree that has no other board, two boards are added as
# platform/PORTING.md says, each by the three files below: a Cortex-M55 with its RAM outside the
# core, and a RISC-V of 64 bits without an FPU, beside which another CPU starts. The copy's own
# tests find them, guard their stacks and render the host's frame on them.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
copy=$BUILD/new_board
rm -rf "$copy"
mkdir -p "$copy/board" "$copy/build"

for program in '' wired faults; do
    make_board template PROGRAM=$program || continue
    verdict "board/template and platform/template are a firmware${program:+, PROGRAM=$program}" \
        "$([ -s "$BUILD/template${program:+-$program}/firmware.elf" ] || echo "there is none")"
done
text=$(sh board/template/run.sh "" 2>&1)
status=$?
verdict "the template has no machine, and says so" "$(
    [ "$status" -eq 2 ] && echo "$text" | grep -q '^error: .*run.sh' || echo "$status: $text")"

tar cf - Makefile engine platform tests | (cd "$copy" && tar xf -)
for file in board/*; do
    [ -e "$file/memory.ld" ] && [ "$file" != board/template ] || cp -r "$file" "$copy/board/"
done
ln -s "$(realpath "$BUILD/host")" "$copy/build/host"
cd "$copy" || exit 1
unset BUILD
sums() { # of all that was there before
    find Makefile engine platform tests board -type f | grep -v '^board/second_' | sort |
        xargs cksum
}
sums >build/before.txt

# added NAME COMMENT: its folder, as the template's; the text of board.mk and memory.ld comes here.
added() {
    cp -r board/template "board/$1"
    rm -r "board/$1/board.c" "board/$1/wired"
    printf '# %s - %s\n# SPDX-License-Identifier: MIT\n\n' "$1" "$2" >"board/$1/board.mk"
}
added second_m55 "a Cortex-M55 with code in its ITCM and all else in memory outside"
cat >>board/second_m55/board.mk <<'MK'
CROSS := arm-none-eabi-
CPU := -mthumb -mcpu=cortex-m55 -mfloat-abi=hard -fno-tree-vectorize
LANES := scalar
ARENA_BYTES := 131072
STACK_BYTES := 4096
SHARED := platform/bare platform/cortex_m platform/cortex_m/armv8m board/semihosted \
          board/debugger_clock
BOARD_PARTS := render thesis frames
FIRMWARE_FLAGS := -DPLT_PACKET_SIDE_MAX=8
MK
cat >board/second_m55/memory.ld <<'LD'
MEMORY
{
    FLASH (rx)  : ORIGIN = 0x00000000, LENGTH = 512K
    RAM   (rwx) : ORIGIN = 0x21000000, LENGTH = 1M
    SCENE (r)   : ORIGIN = 0x60000000, LENGTH = 8M
}
plt_scene_start = ORIGIN(SCENE);
plt_scene_end = ORIGIN(SCENE) + LENGTH(SCENE);
INCLUDE platform/bare/sections.ld
LD
cat >board/second_m55/run.sh <<'RUN'
board=second_m55 cross=arm-none-eabi- machine='qemu-system-arm -M mps3-an547'
. board/tools/emulate.sh
RUN
added second_riscv "an RV64IMAC, with a hart beside it"
cat >>board/second_riscv/board.mk <<'MK'
CROSS := riscv64-unknown-elf-
CPU := -march=rv64imac -mabi=lp64 -mcmodel=medany -msmall-data-limit=0 \
       -isystem platform/headers -Wno-maybe-uninitialized
LANES := scalar
ARENA_BYTES := 131072
STACK_BYTES := 8192
SHARED := platform/bare platform/riscv platform/soft_float board/semihosted board/riscv_cycles
LIBGCC := yes
BOARD_PARTS := render thesis frames
BOARD_FLAGS := -DPLT_CLOCK_HERTZ=1000000000u
FIRMWARE_FLAGS := -DPLT_PACKET_SIDE_MAX=8
MK
cat >board/second_riscv/memory.ld <<'LD'
MEMORY
{
    FLASH (rx)  : ORIGIN = 0x80000000, LENGTH = 1M
    RAM   (rwx) : ORIGIN = 0x80100000, LENGTH = 1M
    SCENE (r)   : ORIGIN = 0x80800000, LENGTH = 8M
}
plt_scene_start = ORIGIN(SCENE);
plt_scene_end = ORIGIN(SCENE) + LENGTH(SCENE);
INCLUDE platform/bare/sections.ld
LD
cat >board/second_riscv/run.sh <<'RUN'
board=second_riscv cross=riscv64-unknown-elf-
machine='qemu-system-riscv64 -M sifive_u -smp 2 -m 64M -bios none'
. board/tools/emulate.sh
RUN

# both_pass SCRIPT SENTENCE: what the copy's own test says of both.
both_pass() {
    text=$(sh "$1" 2>&1)
    verdict "$2: $(echo "$text" | grep -c '^pass second_') of $(
        echo "$text" | grep -c '^[a-zA-Z]* second_')" "$(
        echo "$text" | grep -B 5 '^FAIL second_'
        for board in second_m55 second_riscv; do
            [ "$(echo "$text" | grep -c "^pass $board: ")" -ge 5 ] || echo "$board: $text"
        done)"
}
both_pass tests/boards/test_boards.sh "both new boards render the host's frame, and say sizes"
both_pass tests/qemu/test_guards.sh "... start, guard their stacks and say what was wrong"
sums >build/after.txt
verdict "no file outside their folders was touched" "$(diff build/before.txt build/after.txt)"
cd - >/dev/null && rm -rf "$copy"
finish
