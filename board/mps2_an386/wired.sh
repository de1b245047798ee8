#!/bin/sh
# wired.sh SOCKET [key=value ...] - becomes the wired firmware in QEMU, fed at SOCKET
#
# Waits for SOCKET, which `planelet serve --socket SOCKET` makes, and joins it to
# the second UART; tries again every second when the host has gone. Prints what
# the firmware prints. Replaces the shell, so that its process id is QEMU's.
# FIRMWARE is the folder that it was built in (build/mps2_an386-wired). PROFILE=PATH writes
# a count for every instruction there when it ends.
# SPDX-License-Identifier: MIT
. board/tools/limit.sh
folder=${FIRMWARE:-${BUILD:-build}/mps2_an386-wired}
socket=$1
shift
until [ -S "$socket" ]; do
    sleep 0.1
done
# A comma ends an option of QEMU unless it is doubled.
path=$(printf '%s' "$socket" | sed 's/,/,,/g')
parameters=$(printf '%s' "$*" | sed 's/,/,,/g')
set --
[ -z "$PROFILE" ] ||
    set -- -plugin "$folder/libcount.so,out=/dev/null,code=0:0x100000,profile=$PROFILE"
limit_self
exec qemu-system-arm -M mps2-an386 -display none -monitor none -serial null \
    -chardev "socket,id=wire,path=$path,reconnect=1" -serial chardev:wire \
    -chardev stdio,id=text,signal=off \
    -semihosting-config "enable=on,target=native,chardev=text,arg=firmware,arg=$parameters" \
    "$@" -kernel "$folder/firmware.elf" </dev/null
