# armhf - Armv7 with NEON: 32 bits, little-endian, char unsigned
# SPDX-License-Identifier: MIT
TRIPLE := arm-linux-gnueabihf
CPU_FLAGS := -mcpu=cortex-a15 -mfpu=neon-vfpv4
EMULATOR := qemu-arm -cpu cortex-a15
HASHED := neon scalar
HASHED_BY := gcc clang-16
PACKAGES := gcc-arm-linux-gnueabihf libc6-dev-armhf-cross
IN_CI := yes
