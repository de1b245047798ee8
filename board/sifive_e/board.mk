# sifive_e - SiFive E31 (RV32IMAC) with 16 KB of RAM, as QEMU models it: no FPU
# SPDX-License-Identifier: MIT

CROSS := riscv64-unknown-elf-
CPU := -march=rv32imac -mabi=ilp32 -mcmodel=medany -msmall-data-limit=0 \
       -isystem platform/headers -Wno-maybe-uninitialized
LANES := scalar
ARENA_BYTES := 8192
STACK_BYTES := 4096
SHARED := platform/bare platform/riscv platform/soft_float board/semihosted board/riscv_cycles
LIBGCC := yes
BOARD_PARTS := render thesis frames
BOARD_FLAGS := -DPLT_COMMAND_LINE_BYTES=512 -DPLT_CLOCK_HERTZ=1000000000u
FIRMWARE_FLAGS := -DPLT_PACKET_SIDE_MAX=4 -DPLT_TILE_SIDE=8
