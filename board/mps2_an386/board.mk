# mps2_an386 - Arm MPS2 board with a Cortex-M4F at 25 MHz, as QEMU models it
# SPDX-License-Identifier: MIT

CROSS := arm-none-eabi-
CPU := -mthumb -mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16
LANES := scalar
ARENA_BYTES := 262144
STACK_BYTES := 8192
PLATFORM_FAMILY := cortex_m
LINK_SCRIPT := board/mps2_an386/memory.ld
# For the stack bound: where it starts, and where plt_source's pointers may lead.
STACK_ROOT := cortex_m_start
SOURCE_FUNCTIONS := scene_start scene_wait
# The handler that may come on top of it once, and what the CPU itself stacks: 26
# words with those of the FPU, and one to align.
INTERRUPTS_wired := serial_interrupt
INTERRUPT_FRAME := 108
# 16 groups per packet: their mask is one register, not two.
FIRMWARE_FLAGS := -DPLT_PACKET_SIDE_MAX=8
