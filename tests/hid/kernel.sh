#!/bin/sh
# kernel.sh - Debian's kernel, downloaded and unpacked under build/, never installed
#
# Prints the folder it is in. Exit status 1 and a sentence when it cannot be
# had. SPDX-License-Identifier: MIT
build=${BUILD:-build}
folder=$build/hid/kernel
if ! ls "$folder"/unpacked/boot/vmlinuz-* >/dev/null 2>&1; then
    if ! command -v apt-get >/dev/null 2>&1; then
        echo "hid: needs apt-get to download Debian's kernel" >&2
        exit 1
    fi
    name=$(apt-cache depends linux-image-amd64 2>/dev/null |
        awk '/Depends:/ && $2 ~ /^linux-image-/ { print $2; exit }')
    if [ -z "$name" ]; then
        echo "hid: apt knows no linux-image-amd64 (run apt-get update; amd64 Debian alone)" >&2
        exit 1
    fi
    mkdir -p "$folder/unpacked"
    (cd "$folder" && apt-get download "$name" >/dev/null 2>&1 &&
        dpkg-deb -x "$name"_*.deb unpacked && rm -f "$name"_*.deb) || {
        echo "hid: $name could not be downloaded; is there a network?" >&2
        rm -rf "$folder"
        exit 1
    }
fi
echo "$folder/unpacked"
