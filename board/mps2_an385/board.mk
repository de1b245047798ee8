# mps2_an385 - Arm MPS2 board with a Cortex-M3 at 25 MHz, as QEMU models it: no FPU
# SPDX-License-Identifier: MIT

CROSS := arm-none-eabi-
CPU := -mthumb -mcpu=cortex-m3
LANES := scalar
ARENA_BYTES := 262144
STACK_BYTES := 8192
SHARED := platform/bare platform/cortex_m platform/cortex_m/armv7m platform/soft_float \
          board/semihosted board/fpgaio
LIBGCC := yes
BOARD_FLAGS := -DPLT_FPGAIO=0x40028000u -DPLT_CLOCK_HERTZ=25000000u
FIRMWARE_FLAGS := -DPLT_PACKET_SIDE_MAX=8
