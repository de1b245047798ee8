# i386 - x86 of 32 bits with SSE2, where long is 32 bits, too
# SPDX-License-Identifier: MIT
TRIPLE := i686-linux-gnu
CPU_FLAGS := -msse2 -mfpmath=sse
EMULATOR := qemu-i386
HASHED := sse scalar
HASHED_BY := gcc clang-16
PACKAGES := gcc-i686-linux-gnu libc6-dev-i386-cross
IN_CI := yes
