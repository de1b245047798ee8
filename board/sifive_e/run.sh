#!/bin/sh
# run.sh SCENE.plt|"" [key=value ...] - runs the firmware in QEMU and counts, by emulate.sh
# SPDX-License-Identifier: MIT
board=sifive_e cross=riscv64-unknown-elf- machine='qemu-system-riscv32 -M sifive_e -bios none'
loader_bytes=16384
. board/tools/emulate.sh
