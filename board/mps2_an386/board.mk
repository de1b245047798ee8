# mps2_an386 - Arm MPS2 board with a Cortex-M4F at 25 MHz, as QEMU models it
# SPDX-License-Identifier: MIT

CROSS := arm-none-eabi-
CPU := -mthumb -mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16
LANES := scalar
ARENA_BYTES := 262144
STACK_BYTES := 8192
SHARED := platform/bare platform/cortex_m platform/cortex_m/armv7m board/semihosted board/fpgaio
BOARD_FLAGS := -DPLT_FPGAIO=0x40028000u -DPLT_CLOCK_HERTZ=25000000u
# The handler that may come on top of the stack once, and what the CPU itself stacks: 26
# words with those of the FPU, and one to align.
INTERRUPTS_wired := serial_interrupt
INTERRUPT_FRAME := 108
# 16 groups per packet: their mask is one register, not two.
FIRMWARE_FLAGS := -DPLT_PACKET_SIDE_MAX=8
