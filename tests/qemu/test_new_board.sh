#!/bin/sh
# test_new_board.sh - a new board is a folder, and nothing outside it is touched
#
# The templates build. Then, in a copy of the tree that has no other board, boards are added as
# platform/PORTING.md says, each by the three files below: a Cortex-M55 with its RAM outside the
# core, and a RISC-V of 64 bits without an FPU, beside which another CPU starts. The copy's own
# tests try them by their names, guard their stacks and render the host's frame on them. Of that
# other CPU, which has an FPU, a third board tries start-up.
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

added second_hart "the second hart of an RV64GC, as the first has no FPU"
sed -n '/^CROSS/,$p' board/second_riscv/board.mk |
    sed 's/-march=rv64imac -mabi=lp64 /-march=rv64imafdc -mabi=lp64d /; s,platform/soft_float ,,
        s/^BOARD_FLAGS := /&-DPLT_HART=1 /' >>board/second_hart/board.mk
cp board/second_riscv/memory.ld board/second_hart
sed 's/=second_riscv/=second_hart/' board/second_riscv/run.sh >board/second_hart/run.sh

# both_pass SCRIPT SENTENCE: what the copy's own test says of both.
both_pass() {
    text=$(ON='second_m55 second_riscv' sh "$1" 2>&1)
    verdict "$2: $(echo "$text" | grep -c '^pass second_') of $(
        echo "$text" | grep -c '^[a-zA-Z]* second_')" "$(
        echo "$text" | grep -B 5 '^FAIL '
        for board in second_m55 second_riscv; do
            [ "$(echo "$text" | grep -c "^pass $board: ")" -ge 5 ] || echo "$board: $text"
        done)"
}
both_pass tests/boards/test_boards.sh "both new boards render the host's frame, and say sizes"
both_pass tests/qemu/test_guards.sh "... start, guard their stacks and say what was wrong"
text=$(${MAKE:-make} -s BOARD=second_riscv PROGRAM=wired 2>&1) && text="it was built: $text"
verdict "a board without a serial line is told how it gets one" "$(
    echo "$text" | grep -q 'no serial line; copy board/template/wired' || echo "$text")"

# hart WORD [SECONDS]: PROGRAM=faults of the third, sets text and status.
hart() {
    text=$(FIRMWARE=build/second_hart-faults QEMU_SECONDS=${2:-60} \
        sh board/second_hart/run.sh "" "$1" 2>&1)
    status=$?
}
if make_board second_hart PROGRAM=faults; then
    hart float
    verdict "second_hart: the FPU of the hart that PLT_HART names is right, status 42" "$(
        [ "$status" -eq 42 ] || echo "status $status: $text")"
    hart overrun
    verdict "second_hart: a stack that runs over is a fault there, status 99" "$(
        [ "$status" -eq 99 ] && echo "$text" | grep -q '^FAULT ' || echo "status $status: $text")"
    sed -i 's/-M sifive_u/&,start-in-flash=true/' board/second_hart/run.sh
    for seconds in 2 10 60; do # QEMU itself has to begin within them
        hart float $seconds
        case $text in *instructions*) break ;; esac
    done
    verdict "second_hart: a machine that begins elsewhere is told where the firmware is" "$(
        [ "$status" -eq 124 ] && echo "$text" | grep -q \
            '^error: machine_main was not reached in '$seconds' seconds; .* 0x0*80000' ||
            echo "status $status: $text")"
fi
sums >build/after.txt
verdict "no file outside their folders was touched" "$(diff build/before.txt build/after.txt)"
cd - >/dev/null && rm -rf "$copy"
finish
