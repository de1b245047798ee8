#!/bin/sh
# run.sh SCENE.plt|"" [key=value ...] - runs the firmware in QEMU and counts, by emulate.sh
# SPDX-License-Identifier: MIT
board=microbit cross=arm-none-eabi- machine='qemu-system-arm -M microbit'
. board/tools/emulate.sh
