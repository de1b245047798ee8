# x86_64 - what most hosts are: no emulator, then
# SPDX-License-Identifier: MIT
TRIPLE := x86_64-linux-gnu
EMULATOR := $(if $(filter x86_64,$(shell uname -m)),,qemu-x86_64)
HASHED := sse sse41 scalar
HASHED_BY := gcc clang-14 clang-16
PACKAGES := gcc-x86-64-linux-gnu libc6-dev-amd64-cross
IN_CI := no
