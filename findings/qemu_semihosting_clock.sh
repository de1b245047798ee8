#!/bin/sh
# qemu_semihosting_clock.sh - semihosting's clocks tell the host's time, with -icount, too
#
# Software: Debian's qemu-system-arm 1:7.2+dfsg-7+deb12u18+b3 (QEMU 7.2), binutils-arm-none-eabi
# 2.40-2+18+b1. Input: firmware for mps2-an385 that counts ten million down, and writes what
# SYS_ELAPSED tells of it, and the board's timer of 25 MHz. It runs with -icount shift=0, one
# instruction a nanosecond, and with shift=10, where each takes 1024.
# Behaviour: the timer lives in the guest's time: 0.02 s and 20.48 s, as counted. SYS_ELAPSED,
# which Arm's text defines as ticks of the target, gives what the host's clock has advanced: well
# below 20.48 s with shift=10, and above 0.02 s with shift=0 on a host that needs longer, another
# number each time. SYS_CLOCK is the processor time of QEMU itself. One would guess that all clocks
# that firmware can read are virtual when instructions are counted, and timings by them repeat.
# Output seen: "shift=0: timer 0.02 s", "shift=10: timer 20.48 s, SYS_ELAPSED below 20 s".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/archives/partial" "$folder/tree"
for package in qemu-system-arm=1:7.2+dfsg-7+deb12u18+b3 binutils-arm-none-eabi=2.40-2+18+b1; do
    have=$(dpkg-query -W -f '${Package}=${Version}' "${package%%=*}" 2>/dev/null)
    if [ "$have" != "$package" ]; then
        apt-get install -y -qq --no-install-recommends --download-only \
            -o "Dir::Cache::archives=$folder/archives" "$package" >/dev/null 2>&1 ||
            { echo "cannot get $package"; exit 2; }
    fi
done
for package in "$folder"/archives/*.deb; do
    [ ! -e "$package" ] || dpkg-deb -x "$package" "$folder/tree" || exit 2
done
PATH=$folder/tree/usr/bin:$PATH
LD_LIBRARY_PATH=$folder/tree/usr/lib/$(uname -m)-linux-gnu
export PATH LD_LIBRARY_PATH
cd "$folder" || exit 2
cat >count.s <<'END'
    .syntax unified
    .cpu cortex-m3
    .thumb
    .word 0x20001000, _start + 1 @ the stack, the entry
    .global _start
_start:
    ldr r4, =0x40000000 @ the timer: control, value, reload; it counts down
    mvn r0, #0
    str r0, [r4, #8]
    str r0, [r4, #4]
    movs r0, #1
    str r0, [r4]
    ldr r6, =0x20000000 @ what is written: before, after (64 bits each), the timer
    mov r1, r6
    movs r0, #0x30 @ SYS_ELAPSED
    bkpt 0xab
    ldr r5, =10000000
loop:
    subs r5, #1
    bne loop
    add r1, r6, #8
    movs r0, #0x30
    bkpt 0xab
    ldr r0, [r4, #4]
    mvn r0, r0
    str r0, [r6, #16]
    adr r1, open
    movs r0, #1 @ SYS_OPEN
    bkpt 0xab
    movs r1, #20
    strd r0, r6, [r6, #20]
    str r1, [r6, #28]
    add r1, r6, #20
    movs r0, #5 @ SYS_WRITE: file, address, bytes
    bkpt 0xab
    ldr r1, =0x20026
    movs r0, #0x18 @ SYS_EXIT
    bkpt 0xab
    .align 2
open: .word name, 5, 3 @ "wb"
name: .asciz "out"
END
arm-none-eabi-as count.s -o count.o && arm-none-eabi-ld -Ttext=0 count.o -o count.elf || exit 2
run() { # SHIFT: the seconds of the timer and of SYS_ELAPSED
    rm -f out
    timeout 60 qemu-system-arm -M mps2-an385 -nographic -icount "shift=$1" \
        -semihosting-config enable=on,target=native -kernel count.elf </dev/null || return
    echo "$(od -An -tu8 -N16 out) $(od -An -tu4 -j16 out)" |
        awk '{ printf "%.2f %.3f\n", $3 / 25e6, ($2 - $1) / 1e9 }'
}
slow=$(run 0) && fast=$(run 10) || exit 2
seen=$(echo "$slow" | awk '{ print "shift=0: timer " $1 " s" }'
echo "$fast" | awk '{
    print "shift=10: timer " $1 " s, SYS_ELAPSED", $2 < 20 ? "below 20 s" : $2 " s" }')
echo "$seen"
[ "$seen" = "shift=0: timer 0.02 s
shift=10: timer 20.48 s, SYS_ELAPSED below 20 s" ]
