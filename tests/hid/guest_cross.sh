# guest_cross.sh - Planelet's wire in every combination; sourced by guest.sh in the guest
#
# Five pixel formats x eight sizes of reports x both backends x three ways to be
# plugged in; libusb sees no uhid. A display is plugged in once for a size and
# shows one format after the other. Every frame is confirmed before the next is sent
# (--every) and every pixel of it was compared when it was. Panels are 53x37: tiles
# are cut at both edges, and the last byte of a row is not full.
# SPDX-License-Identifier: MIT

cross_sizes="8 16 32 64 128 256 512 1024"
cross_pictures=3

# next_line: what the display has seen since the last; it goes on in the next format.
next_line() {
    line= tries=0
    : >"$scratch/device"
    kill -USR1 $device
    until read -r line <"$scratch/device" || [ $tries -eq 600 ]; do
        tries=$((tries + 1))
        usleep 5000
    done
}

# formats SENTENCE BACKEND: five formats of what is plugged in.
formats() {
    wrong=
    for format in 0 1 2 3 4; do
        "./planelet-hid-$2" show "$scratch/cross" --every >"$scratch/host" 2>&1
        status=$?
        next_line
        trouble=$(trouble_of planelet $cross_pictures
            [ "$(value format)" = $format ] || echo "$line")
        [ -z "$trouble" ] || wrong="$wrong format $format: $trouble;"
    done
    verdict "$1, $2: five formats, $cross_pictures pictures each, every pixel" "$wrong"
}

# A host's input reports are of at most 64 bytes.
cross_shape() { # BYTES
    echo "size=53x37 report=$1 in=$(($1 < 64 ? $1 : 64))"
}

cross() {
    ./make_pattern 53x37 $cross_pictures >"$scratch/cross"
    for bytes in $cross_sizes; do
        # shellcheck disable=SC2046
        start usbip planelet $(cross_shape "$bytes")
        formats "planelet over usbip, reports of $bytes" hidraw
        formats "planelet over usbip, reports of $bytes" libusb
        stop
        # shellcheck disable=SC2046
        start uhid planelet $(cross_shape "$bytes")
        formats "planelet over uhid, reports of $bytes" hidraw
        stop
        gadget "$bytes" planelet 1209 0001 $(cross_shape "$bytes")
        formats "planelet over the kernel's gadget, reports of $bytes" hidraw
        formats "planelet over the kernel's gadget, reports of $bytes" libusb
        no_gadget
    done
}
