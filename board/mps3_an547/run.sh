#!/bin/sh
# run.sh SCENE.plt|"" [key=value ...] - runs the firmware in QEMU and counts, by emulate.sh
# SPDX-License-Identifier: MIT
board=mps3_an547 cross=arm-none-eabi- machine='qemu-system-arm -M mps3-an547'
. board/tools/emulate.sh
