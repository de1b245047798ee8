# riscv64 - RV64GC, little-endian, char unsigned; its vectors by make ARCH=riscv64 LANES=rvv
# COMPILER=clang-16, as gcc 12 has none
# SPDX-License-Identifier: MIT
comma := ,
TRIPLE := riscv64-linux-gnu
EMULATOR := qemu-riscv64 -cpu rv64$(comma)v=true$(comma)vext_spec=v1.0
HASHED := scalar rvv
HASHED_BY := gcc clang-16
PACKAGES := gcc-riscv64-linux-gnu libc6-dev-riscv64-cross
IN_CI := no
