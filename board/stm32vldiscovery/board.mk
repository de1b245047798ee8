# stm32vldiscovery - STM32F100 with a Cortex-M3 and 8 KB of RAM, as QEMU models it: no FPU
# SPDX-License-Identifier: MIT

CROSS := arm-none-eabi-
CPU := -mthumb -mcpu=cortex-m3
LANES := scalar
ARENA_BYTES := 4096
STACK_BYTES := 3072
SHARED := platform/bare platform/cortex_m platform/cortex_m/armv7m platform/soft_float \
          board/semihosted board/debugger_clock
LIBGCC := yes
BOARD_PARTS := render thesis frames
BOARD_FLAGS := -DPLT_COMMAND_LINE_BYTES=512
FIRMWARE_FLAGS := -DPLT_PACKET_SIDE_MAX=2 -DPLT_TILE_SIDE=4
