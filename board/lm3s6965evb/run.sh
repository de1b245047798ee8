#!/bin/sh
# run.sh SCENE.plt|"" [key=value ...] - runs the firmware in QEMU and counts, by emulate.sh
# SPDX-License-Identifier: MIT
board=lm3s6965evb cross=arm-none-eabi- machine='qemu-system-arm -M lm3s6965evb'
. board/tools/emulate.sh
