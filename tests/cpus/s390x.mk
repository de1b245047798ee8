# s390x - IBM Z: 64 bits, big-endian, char unsigned; vectors of z14
# SPDX-License-Identifier: MIT
TRIPLE := s390x-linux-gnu
EMULATOR := qemu-s390x
LANES ?= vx
HASHED := vx scalar
HASHED_BY := gcc clang-16
PACKAGES := gcc-s390x-linux-gnu libc6-dev-s390x-cross
IN_CI := yes
