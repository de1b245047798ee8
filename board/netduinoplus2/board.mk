# netduinoplus2 - STM32F405 with a Cortex-M4F and 192 KB of RAM, as QEMU models it
# SPDX-License-Identifier: MIT

CROSS := arm-none-eabi-
CPU := -mthumb -mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16
LANES := scalar
ARENA_BYTES := 163840
STACK_BYTES := 8192
SHARED := platform/bare platform/cortex_m platform/cortex_m/armv7m board/semihosted \
          board/debugger_clock
FIRMWARE_FLAGS := -DPLT_PACKET_SIDE_MAX=8
