#!/bin/sh
# test_hid_kernel.sh - real hidapi, both backends, on a real kernel, in QEMU
#
# Software emulation with one processor: with two the paced bus falls behind.
# What runs inside is tests/hid/guest_tests.sh; HID_GROUPS=a,b picks groups of
# it. SPDX-License-Identifier: MIT
. tests/check/report.sh
PATH=$PATH:/usr/sbin:/sbin
out=${OUT:-$BUILD/host}
work=$BUILD/hid
limit=550 # seconds; a quiet machine needs 160

give_up() { # SENTENCE TROUBLE
    verdict "$1" "$2"
    finish
    exit 1
}

needs qemu-system-x86_64 busybox cpio modprobe depmod pkg-config || { finish; exit; }
for backend in hidraw libusb; do
    pkg-config --exists "hidapi-$backend" ||
        give_up "hidapi-$backend is installed" "pkg-config does not know it; run: make setup"
done
kernel=$(sh tests/hid/kernel.sh 2>&1) || give_up "Debian's kernel is there" "$kernel"
trouble=$($MAKE -s all hid-bench 2>&1 >/dev/null) || give_up "the bench builds" "$trouble"
trouble=$(sh tests/hid/films.sh "$work/films" 2>&1) || give_up "the films are made" "$trouble"
mkdir -p "$work/t"
for backend in hidraw libusb; do
    cp "$out/planelet-hid-$backend" "$work/t/planelet-hid-$backend"
    cp "$out/hid-sanitize/$backend" "$work/t/planelet-hid-$backend-sanitize"
done
cp "$work"/films/*.ppm "$work/films/orbit.y4m" "$work/films/knot.plt" "$out/hid-bench/device" \
    "$out/hid-bench/make_pattern" tests/hid/guest_*.sh "$work/t/"
trouble=$(sh tests/hid/initramfs.sh "$kernel" "$work/initramfs" "$work"/t/* 2>&1) ||
    give_up "the guest's files are packed" "$trouble"

groups=${HID_GROUPS:+HID_GROUPS=$HID_GROUPS}
timeout "$limit" qemu-system-x86_64 -M q35 -accel tcg -cpu max -smp 1 -m 512 -nographic \
    -no-reboot -nodefaults -serial stdio -kernel "$kernel"/boot/vmlinuz-* \
    -initrd "$work/initramfs" \
    -append "console=ttyS0 quiet panic=-1 loglevel=3 tsc=reliable $groups" \
    </dev/null 2>&1 | tr -d '\r' >"$work/log"
# What the guest's own firmware writes stands before its first line.
sed -n 's/^.*\(pass .*\)$/\1/p; s/^.*\(FAIL .*\)$/\1/p; /^    /p; /^DONE/p' "$work/log" \
    >"$work/lines"
cat "$work/lines"
passed=$((passed + $(grep -c '^pass ' "$work/lines")))
failed=$((failed + $(grep -c '^FAIL ' "$work/lines")))
verdict "the guest came to its end within $limit seconds" "$(
    grep -q '^DONE' "$work/log" || tail -n 5 "$work/log")"
finish
