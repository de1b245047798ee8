#!/bin/sh
# run.sh SCENE.plt|"" [key=value ...] - how the firmware is run; the template's runs nowhere
#
# Prints what the firmware prints, and ends with its status. In QEMU it is two lines, a description
# of the machine and the one that does the rest (see board/mps2_an386/run.sh); with a probe it loads
# build/NAME/firmware.elf and the scene, and shows what comes.
# SPDX-License-Identifier: MIT
echo "error: board/template has no machine; copy the folder, and say in run.sh what runs it" >&2
exit 2
