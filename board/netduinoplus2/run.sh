#!/bin/sh
# run.sh SCENE.plt|"" [key=value ...] - runs the firmware in QEMU and counts, by emulate.sh
# SPDX-License-Identifier: MIT
board=netduinoplus2 cross=arm-none-eabi- machine='qemu-system-arm -M netduinoplus2'
. board/tools/emulate.sh
