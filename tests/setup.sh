#!/bin/sh
# setup.sh - installs what the tests need beside gcc, make and git
#
# With ALL_CPUS=all also what `make cpus` and `make hashes` need. Does nothing when all is there.
# Exit status 1, and what to install by hand, when it cannot. SPDX-License-Identifier: MIT

# tool:package
wanted='qemu-system-arm:qemu-system-arm
arm-none-eabi-gcc:gcc-arm-none-eabi
qemu-system-riscv32:qemu-system-misc
riscv64-unknown-elf-gcc:gcc-riscv64-unknown-elf
g++:g++
cppcheck:cppcheck
clang-format:clang-format
qemu-system-x86_64:qemu-system-x86
busybox:busybox-static
cpio:cpio
modprobe:kmod
pkg-config:pkg-config
assimp:assimp-utils
xz:xz-utils
bzip2:bzip2
zstd:zstd
unzip:unzip
parallel:parallel
qemu-arm:qemu-user
clang-16:clang-16
wasm-ld-16:lld-16
node:nodejs
chromium:chromium'
PATH=$PATH:/usr/sbin:/sbin

missing() {
    for pair in $wanted; do
        command -v "${pair%%:*}" >/dev/null 2>&1 || echo "${pair##*:}"
    done
    # The compiler alone has no string.h.
    if ! echo '#include <string.h>' | arm-none-eabi-gcc -E - >/dev/null 2>&1; then
        echo libnewlib-arm-none-eabi
    fi
    for arch in $(sh tests/cpus/archs.sh ${ALL_CPUS:-ci}); do
        compiler=$(sed -n 's/^TRIPLE := //p' "tests/cpus/$arch.mk")-gcc
        if ! echo '#include <string.h>' | "$compiler" -E - >/dev/null 2>&1; then
            sed -n 's/^PACKAGES := //p' "tests/cpus/$arch.mk"
        fi
    done
    if ! pkg-config --exists hidapi-hidraw hidapi-libusb 2>/dev/null; then
        echo libhidapi-dev libhidapi-hidraw0 libhidapi-libusb0
    fi
}

# The guest of the USB tests boots Debian's kernel, which is not installed.
# Without it those tests alone fail, and say why.
kernel() {
    sh tests/hid/kernel.sh >/dev/null || true
}

packages=$(missing | tr '\n' ' ')
if [ -z "$packages" ]; then
    kernel
    exit 0
fi
echo "setup: installing $packages"
root=
[ "$(id -u)" -eq 0 ] || root=sudo
if ! command -v apt-get >/dev/null 2>&1 || { [ -n "$root" ] && ! command -v sudo >/dev/null; }; then
    echo "setup: needs apt-get, as root or with sudo; install by hand what gives: $packages" >&2
    exit 1
fi
export DEBIAN_FRONTEND=noninteractive
# shellcheck disable=SC2086
$root apt-get install -y --no-install-recommends $packages >/dev/null 2>&1 ||
    { $root apt-get update && $root apt-get install -y --no-install-recommends $packages; }
packages=$(missing | tr '\n' ' ')
if [ -n "$packages" ]; then
    echo "setup: still missing: $packages- install them by hand; tests that need them fail" >&2
    exit 1
fi
kernel
