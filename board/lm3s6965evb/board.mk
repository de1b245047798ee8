# lm3s6965evb - Stellaris board with a Cortex-M3 and 64 KB of RAM, as QEMU models it: no FPU
# SPDX-License-Identifier: MIT

CROSS := arm-none-eabi-
CPU := -mthumb -mcpu=cortex-m3
LANES := scalar
ARENA_BYTES := 49152
STACK_BYTES := 4096
SHARED := platform/bare platform/cortex_m platform/cortex_m/armv7m platform/soft_float \
          platform/ssd0323 board/semihosted board/debugger_clock
LIBGCC := yes
BOARD_PARTS := render thesis frames
BOARD_FLAGS := -DPLT_BOARD_PANEL=1
FIRMWARE_FLAGS := -DPLT_PACKET_SIDE_MAX=8
