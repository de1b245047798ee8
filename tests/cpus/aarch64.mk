# aarch64 - Armv8 of 64 bits, little-endian, char unsigned
# SPDX-License-Identifier: MIT
TRIPLE := aarch64-linux-gnu
EMULATOR := qemu-aarch64
HASHED := neon scalar
HASHED_BY := gcc clang-16
PACKAGES := gcc-aarch64-linux-gnu libc6-dev-arm64-cross
IN_CI := yes
