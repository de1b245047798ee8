# mps2_an521 - Arm MPS2 board with two Cortex-M33, as QEMU models it: the first has no FPU
# SPDX-License-Identifier: MIT

CROSS := arm-none-eabi-
CPU := -mthumb -mcpu=cortex-m33+nodsp -mfloat-abi=soft
LANES := scalar
ARENA_BYTES := 262144
STACK_BYTES := 8192
SHARED := platform/bare platform/cortex_m platform/cortex_m/armv8m platform/soft_float \
          board/semihosted board/fpgaio
LIBGCC := yes
BOARD_FLAGS := -DPLT_FPGAIO=0x50302000u -DPLT_CLOCK_HERTZ=20000000u
FIRMWARE_FLAGS := -DPLT_PACKET_SIDE_MAX=8
