#!/bin/sh
# run.sh SCENE.plt|"" [key=value ...] - runs the firmware in QEMU and counts, by emulate.sh
# SPDX-License-Identifier: MIT
board=stm32vldiscovery cross=arm-none-eabi- machine='qemu-system-arm -M stm32vldiscovery'
. board/tools/emulate.sh
