#!/bin/sh
# run.sh SCENE.plt|"" [key=value ...] - how the firmware is run; the template's runs nowhere
#
# Prints what the firmware prints, and ends with its status. In QEMU it is two lines, a description
# of the machine and the one that does the rest, which stands at the beginning of its line:
#     board=NAME cross=riscv64-unknown-elf- machine='qemu-system-riscv64 -M virt -m 64M -bios none'
#     . board/tools/emulate.sh
# With a probe it loads $FIRMWARE/firmware.elf (build/NAME) and the scene, and shows what comes.
# SPDX-License-Identifier: MIT
echo "error: board/template has no machine; copy the folder, and say in run.sh what runs it" >&2
exit 2
