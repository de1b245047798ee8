#!/bin/sh
# qemu_ppc64_memset.sh - of what memset is to clear, qemu-ppc64's 970 and power5+ clear a quarter
#
# Software: Debian's qemu-user 1:7.2+dfsg-7+deb12u18+b3 (QEMU 7.2), gcc-12-powerpc64-linux-gnu
# 12.2.0-13cross1, libc6-dev-ppc64-cross 2.36-8cross1 (glibc 2.36).
# Input: a static program that asks for the data cache's line (AT_DCACHEBSIZE), clears one with the
# instruction dcbz, and 4,096 bytes of ones with memset, on four of the emulator's CPUs.
# Behaviour: all four tell of lines of 128 bytes, as the CPUs have. On 970, 970fx and power5+ dcbz
# clears 32, what a 970 does only in a mode for older programs (HID5), in which QEMU starts it for
# programs of users alone, not of machines. glibc's memset clears whole lines by dcbz, so that from
# 128 bytes on three quarters keep what was there; memory that is zero at first hides it. One would
# guess that memset of any C library works on a CPU that an emulator offers. power8 is right.
# Output seen: "970: line 128, dcbz 32, memset 1024", the same of 970fx and power5+, and
# "power8: line 128, dcbz 128, memset 4096".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/archives/partial" "$folder/tree"
for package in qemu-user=1:7.2+dfsg-7+deb12u18+b3 gcc-12-powerpc64-linux-gnu=12.2.0-13cross1 \
    libc6-dev-ppc64-cross=2.36-8cross1; do
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
here=$folder/tree/usr/powerpc64-linux-gnu
[ -d "$here" ] || here=/usr/powerpc64-linux-gnu
cat >"$folder/clear.c" <<'END'
#include <stdio.h>
#include <string.h>
#include <sys/auxv.h>
static _Alignas(4096) unsigned char bytes[4096];
static void *(*volatile set)(void *, int, size_t) = memset; /* none of the compiler's own */
static int cleared(void) {
    int count = 0;
    for (int i = 0; i < 4096; i++) {
        count += bytes[i] == 0;
    }
    return count;
}
int main(void) {
    set(bytes, 1, sizeof bytes);
    __asm__ volatile("dcbz 0, %0" : : "r"(bytes) : "memory");
    const int line = cleared();
    set(bytes, 1, sizeof bytes);
    set(bytes, 0, sizeof bytes);
    printf("line %lu, dcbz %d, memset %d\n", getauxval(AT_DCACHEBSIZE), line, cleared());
    return 0;
}
END
powerpc64-linux-gnu-gcc-12 -O1 -static -isystem "$here/include" "-B$here/lib" "-L$here/lib" \
    -o "$folder/clear" "$folder/clear.c" || exit 2
said=$(for cpu in 970 970fx power5+ power8; do
    echo "$cpu: $(qemu-ppc64 -cpu "$cpu" "$folder/clear")"
done)
echo "$said"
[ "$said" = "970: line 128, dcbz 32, memset 1024
970fx: line 128, dcbz 32, memset 1024
power5+: line 128, dcbz 32, memset 1024
power8: line 128, dcbz 128, memset 4096" ]
