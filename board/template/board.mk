# template - the beginning of a board: copy this folder to board/NAME, then go through its files
#
# In the order: this file, memory.ld, run.sh, then board.c, or the folders of SHARED that give the
# same (platform/PORTING.md has the list). As it is, it is built for a CPU with the family of
# platform/template, which starts none.
# SPDX-License-Identifier: MIT

# What the compiler is called, without "gcc".
CROSS := arm-none-eabi-
# CPU and FPU. Never -ffast-math; -fno-tree-vectorize where vectors flush subnormals. Without a C
# library also -isystem platform/headers. platform/PORTING.md has the line of each family.
CPU := -mthumb -mcpu=cortex-m3
# scalar, or another NAME of platform/lanes.txt.
LANES := scalar
# Both are refused when they do not fit RAM, or the stack is below the worst path of calls.
ARENA_BYTES := 65536
STACK_BYTES := 4096
# Folders beside this one whose C files belong to the board.
SHARED := platform/bare platform/template platform/soft_float
# Without an FPU, or with 64-bit integers by calls: functions of libgcc.
LIBGCC := yes
# Leave this out for the whole engine. Here: frames of thesis nodes, the smallest.
BOARD_PARTS := render thesis frames
# What plt_source calls by pointer, for the stack bound.
SOURCE_FUNCTIONS := scene_start scene_wait
# For the C files of the board, and of SHARED: a clock of board/fpgaio or board/riscv_cycles wants
# -DPLT_CLOCK_HERTZ=..., a RISC-V whose first hart is not the one -DPLT_HART=1. FIRMWARE_FLAGS are
# limits of the engine (engine/planelet_config.h).
BOARD_FLAGS :=
FIRMWARE_FLAGS := -DPLT_PACKET_SIDE_MAX=8
# Only of a CPU that cannot guard its stack (Armv6-M): GUARD := none
