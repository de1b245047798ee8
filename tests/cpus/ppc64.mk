# ppc64 - PowerPC of 64 bits with Altivec, big-endian, char unsigned: the Cell's, by gcc
#
# The emulator is a power8. Of what memset is to clear, QEMU 7.2's 970 clears a quarter:
# findings/qemu_ppc64_memset.sh. clang knows no Cell. SPDX-License-Identifier: MIT
TRIPLE := powerpc64-linux-gnu
CPU_FLAGS := -maltivec \
    $(if $(filter gcc,$(COMPILER)),-mcpu=cell,-mcpu=970 -Wno-deprecated-altivec-src-compat)
EMULATOR := qemu-ppc64 -cpu power8
HASHED := altivec scalar
HASHED_BY := gcc clang-16
PACKAGES := gcc-powerpc64-linux-gnu libc6-dev-ppc64-cross
IN_CI := no
