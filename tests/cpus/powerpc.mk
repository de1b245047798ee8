# powerpc - PowerPC 7400 (G4) with Altivec: 32 bits, big-endian, char unsigned
# SPDX-License-Identifier: MIT
TRIPLE := powerpc-linux-gnu
CPU_FLAGS := -mcpu=7400 -maltivec \
    $(if $(filter gcc,$(COMPILER)),-mabi=altivec,-Wno-deprecated-altivec-src-compat)
EMULATOR := qemu-ppc -cpu 7447A
HASHED := altivec scalar
HASHED_BY := gcc clang-16
PACKAGES := gcc-powerpc-linux-gnu libc6-dev-powerpc-cross
IN_CI := yes
