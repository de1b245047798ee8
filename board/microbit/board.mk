# microbit - nRF51822 with a Cortex-M0 and 16 KB of RAM, as QEMU models it: no FPU, no MPU
# SPDX-License-Identifier: MIT

CROSS := arm-none-eabi-
CPU := -mthumb -mcpu=cortex-m0 -Wno-maybe-uninitialized
LANES := scalar
ARENA_BYTES := 8192
STACK_BYTES := 4096
SHARED := platform/bare platform/cortex_m platform/cortex_m/armv6m platform/soft_float \
          board/semihosted board/debugger_clock
LIBGCC := yes
# A stack that runs over leaves RAM, and faults; a store below it by another pointer does not.
GUARD := none
BOARD_PARTS := render thesis frames
BOARD_FLAGS := -DPLT_COMMAND_LINE_BYTES=512
FIRMWARE_FLAGS := -DPLT_PACKET_SIDE_MAX=4 -DPLT_TILE_SIDE=8
