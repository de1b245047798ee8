#!/bin/sh
# gcc_s390x_wide_floats.sh - with -std=c11 gcc computes floats of s390x, too, as doubles
#
# Software: Debian's gcc-12-s390x-linux-gnu 12.2.0-14cross1 and qemu-user 7.2.
# Input: one line of C, a * b + c in float, with a * b a half of the last bit away from a float.
# Behaviour: with -std=gnu11 the product is rounded to float before the sum, and the result is 0.
# With -std=c11, at every level of optimisation and with -ffp-contract=off, product and sum are of
# doubles and only the assignment rounds: the result is 0x1.fffffcp-25, and FLT_EVAL_METHOD is 1.
# The CPU has instructions for single floats, and gcc uses them with -std=gnu11; one would expect
# excess precision of the x87 and the 68881 alone. -fexcess-precision=fast gives it up.
# Output seen: "gnu11: 0 0x0p+0, c11: 1 0x1.fffffcp-25, c11 fast: 0 0x0p+0".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
version=12.2.0-14cross1
mkdir -p "$folder/archives/partial" "$folder/tree"
apt-get install -y -qq --no-install-recommends --download-only \
    -o "Dir::Cache::archives=$folder/archives" "gcc-12-s390x-linux-gnu=$version" \
    libc6-dev-s390x-cross qemu-user >/dev/null 2>&1 ||
    { echo "cannot get gcc-12-s390x-linux-gnu $version"; exit 2; }
for package in "$folder"/archives/*.deb; do
    [ ! -e "$package" ] || dpkg-deb -x "$package" "$folder/tree" || exit 2
done
PATH=$folder/tree/usr/bin:$PATH
LD_LIBRARY_PATH=$folder/tree/usr/lib/$(uname -m)-linux-gnu
export PATH LD_LIBRARY_PATH
here=$folder/tree/usr/s390x-linux-gnu
[ -d "$here" ] || here=/usr/s390x-linux-gnu
cat >"$folder/float.c" <<'END'
#include <float.h>
#include <stdio.h>
int main(void) {
    volatile float a = 1 + FLT_EPSILON, b = 1 - FLT_EPSILON / 2, c = -1;
    const float r = a * b + c;
    printf("%d %a\n", (int)FLT_EVAL_METHOD, r);
    return 0;
}
END
result() { # FLAG...
    s390x-linux-gnu-gcc-12 -O2 -ffp-contract=off "$@" -static -isystem "$here/include" \
        "-B$here/lib" "-L$here/lib" -o "$folder/float" "$folder/float.c" || exit 2
    qemu-s390x "$folder/float"
}
said="gnu11: $(result -std=gnu11), c11: $(result -std=c11), c11 fast: $(
    result -std=c11 -fexcess-precision=fast)"
echo "$said"
[ "$said" = "gnu11: 0 0x0p+0, c11: 1 0x1.fffffcp-25, c11 fast: 0 0x0p+0" ]
