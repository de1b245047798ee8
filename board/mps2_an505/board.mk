# mps2_an505 - Arm MPS2 board with a Cortex-M33 and its FPU at 20 MHz, as QEMU models it
# SPDX-License-Identifier: MIT

CROSS := arm-none-eabi-
CPU := -mthumb -mcpu=cortex-m33 -mfloat-abi=hard -mfpu=fpv5-sp-d16
LANES := scalar
ARENA_BYTES := 262144
STACK_BYTES := 8192
SHARED := platform/bare platform/cortex_m platform/cortex_m/armv8m board/semihosted board/fpgaio
BOARD_FLAGS := -DPLT_FPGAIO=0x50302000u -DPLT_CLOCK_HERTZ=20000000u
FIRMWARE_FLAGS := -DPLT_PACKET_SIDE_MAX=8
