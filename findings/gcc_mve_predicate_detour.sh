#!/bin/sh
# gcc_mve_predicate_detour.sh - gcc 12 takes every MVE predicate through a core register
#
# Software: Debian's gcc-arm-none-eabi 15:12.2.rel1-1 (gcc 12.2), -mcpu=cortex-m55 -O2.
# Input: the smaller of two vectors of floats, lane by lane: vpselq(a, b, vcmpltq(a, b)).
# Behaviour: the compare writes the predicate, VPR.P0, and the select reads it there; two
# instructions would do. The compiler puts three between them: vmrs to a core register, sxth or uxth
# (mve_pred16_t is an integer of 16 bits), and vmsr back to where it came from. One would guess that
# intrinsics of adjacent instructions become adjacent instructions, as those of Neon do.
# Output seen: "between vcmp and vpsel: vmrs sxth vmsr".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/archives/partial" "$folder/tree"
apt-get install -y -qq --no-install-recommends --download-only \
    -o "Dir::Cache::archives=$folder/archives" gcc-arm-none-eabi=15:12.2.rel1-1 \
    >/dev/null 2>&1 || { echo "cannot get gcc-arm-none-eabi 15:12.2.rel1-1"; exit 2; }
for package in "$folder"/archives/*.deb; do
    [ ! -e "$package" ] || dpkg-deb -x "$package" "$folder/tree" || exit 2
done
PATH=$folder/tree/usr/bin:$PATH
LD_LIBRARY_PATH=$folder/tree/usr/lib/$(uname -m)-linux-gnu
export PATH LD_LIBRARY_PATH
cat >"$folder/smaller.c" <<'END'
#include <arm_mve.h>
float32x4_t smaller(float32x4_t a, float32x4_t b) {
    return vpselq(a, b, vcmpltq(a, b));
}
END
between=$(arm-none-eabi-gcc -mcpu=cortex-m55 -mthumb -mfloat-abi=hard -O2 -S -o - \
    "$folder/smaller.c" | awk '$1 == "vpsel" { inside = 0 } inside && $1 ~ /^[a-z]/ {
        printf "%s%s", separator, $1; separator = " " } $1 ~ /^vcmp/ { inside = 1 }')
said="between vcmp and vpsel: $between"
echo "$said"
[ "$said" = "between vcmp and vpsel: vmrs sxth vmsr" ]
