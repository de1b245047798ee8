# mps3_an547 - Arm MPS3 board with a Cortex-M55 at 32 MHz, as QEMU models it; all RAM is DTCM
# SPDX-License-Identifier: MIT

CROSS := arm-none-eabi-
# GCC must not use vectors for floats by itself, as they flush subnormals; the engine does where
# it asks whether they did.
CPU := -mthumb -mcpu=cortex-m55 -mfloat-abi=hard -fno-tree-vectorize
LANES := mve
ARENA_BYTES := 262144
STACK_BYTES := 8192
SHARED := platform/bare platform/cortex_m platform/cortex_m/armv8m board/semihosted board/fpgaio
BOARD_FLAGS := -DPLT_FPGAIO=0x59302000u -DPLT_CLOCK_HERTZ=32000000u
FIRMWARE_FLAGS := -DPLT_PACKET_SIDE_MAX=8
