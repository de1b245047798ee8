#!/bin/sh
# initramfs.sh KERNEL OUT FILE... - busybox, USB and HID modules, the files in /t
#
# The files' shared libraries come along, and glibc's UTF-16, without which
# hidapi on libusb reads no names. SPDX-License-Identifier: MIT
set -e
kernel=$1 out=$2
shift 2
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
mkdir -p "$root/bin" "$root/dev" "$root/proc" "$root/sys" "$root/tmp" "$root/mod" "$root/t"
chmod 755 "$root"
cp "$(command -v busybox)" "$root/bin/busybox"
cp tests/hid/guest.sh "$root/init"
cp "$@" "$root/t/"
chmod 755 "$root/init" "$root"/t/*
for file in "$root/bin/busybox" "$@"; do
    ldd "$file" 2>/dev/null | awk '$2 == "=>" { print $3 } $1 ~ /^\// { print $1 }'
done | sort -u | while read -r library; do
    mkdir -p "$root$(dirname "$library")"
    cp -L "$library" "$root$library"
done
for gconv in /usr/lib/*/gconv; do
    if [ -e "$gconv/UTF-16.so" ]; then
        mkdir -p "$root$gconv"
        cp "$gconv/UTF-16.so" "$gconv/gconv-modules" "$root$gconv/"
    fi
done
version=$(ls "$kernel/lib/modules")
[ -e "$kernel/lib/modules/$version/modules.dep" ] || depmod -b "$kernel" "$version"
for module in hid-generic uhid usbhid vhci-hcd dummy_hcd libcomposite usb_f_hid; do
    modprobe -d "$kernel" -S "$version" --show-depends "$module" | awk '$1 == "insmod" { print $2 }'
done | awk '!seen[$0]++' | while read -r module; do
    cp "$module" "$root/mod/"
    basename "$module" >>"$root/mod/list"
done
(cd "$root" && find . | cpio -o -H newc --quiet | gzip -1) >"$out"
