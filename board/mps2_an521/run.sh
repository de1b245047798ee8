#!/bin/sh
# run.sh SCENE.plt|"" [key=value ...] - runs the firmware in QEMU and counts, by emulate.sh
# SPDX-License-Identifier: MIT
board=mps2_an521 cross=arm-none-eabi- machine='qemu-system-arm -M mps2-an521'
. board/tools/emulate.sh
