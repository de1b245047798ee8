#!/bin/sh
# objdump_no_mve.sh - objdump shows MVE as coprocessor instructions, though the object says its CPU
#
# Software: Debian's binutils-arm-none-eabi 2.40-2+18+b1 and gcc-arm-none-eabi 15:12.2.rel1-1.
# Input: a function that copies four floats by vld1q and vst1q, compiled for a Cortex-M55.
# Behaviour: the object's attributes name the CPU, Armv8.1-M and "MVE Integer and FP" (readelf -A).
# objdump -d takes no notice of the last and prints "ldc" and "stc" of coprocessor 15; with
# -m armv8.1-m.main it prints "vldrw" and "vstrw". Without the flag there is no warning. What
# looks for vector instructions, or counts what a store moves, finds none, and one would guess
# that what the assembler wrote down is what the disassembler reads.
# Output seen: "as it is: ldc stc, with -m: vldrw.u32 vstrw.32".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/archives/partial" "$folder/tree"
apt-get install -y -qq --no-install-recommends --download-only \
    -o "Dir::Cache::archives=$folder/archives" gcc-arm-none-eabi=15:12.2.rel1-1 \
    binutils-arm-none-eabi=2.40-2+18+b1 >/dev/null 2>&1 ||
    { echo "cannot get gcc-arm-none-eabi 15:12.2.rel1-1"; exit 2; }
for package in "$folder"/archives/*.deb; do
    [ ! -e "$package" ] || dpkg-deb -x "$package" "$folder/tree" || exit 2
done
PATH=$folder/tree/usr/bin:$PATH
LD_LIBRARY_PATH=$folder/tree/usr/lib/$(uname -m)-linux-gnu
export PATH LD_LIBRARY_PATH
cat >"$folder/copy.c" <<'END'
#include <arm_mve.h>
void copy(const float *from, float *to) {
    vst1q(to, vld1q(from));
}
END
arm-none-eabi-gcc -mcpu=cortex-m55 -mthumb -mfloat-abi=hard -O2 -c -o "$folder/copy.o" \
    "$folder/copy.c" || exit 2
arm-none-eabi-readelf -A "$folder/copy.o" | grep -q 'MVE Integer and FP' || exit 1
names() { # FLAG...
    arm-none-eabi-objdump "$@" -d "$folder/copy.o" | awk -F '\t' '/^ / && $3 ~ /^(ld|st|v)/ {
        printf "%s%s", separator, $3; separator = " " }'
}
said="as it is: $(names), with -m: $(names -m armv8.1-m.main)"
echo "$said"
[ "$said" = "as it is: ldc stc, with -m: vldrw.u32 vstrw.32" ]
