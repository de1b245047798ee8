#!/bin/sh
# run.sh SCENE.plt|"" [key=value ...] - runs the firmware in QEMU and counts, by emulate.sh
# SPDX-License-Identifier: MIT
board=rv32_virt cross=riscv64-unknown-elf- machine='qemu-system-riscv32 -M virt -m 64M -bios none'
. board/tools/emulate.sh
