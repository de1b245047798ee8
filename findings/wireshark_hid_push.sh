#!/bin/sh
# wireshark_hid_push.sh - Wireshark shows nothing of a HID device whose descriptor pushes
#
# Software: Debian's tshark 4.0.17-0+deb12u3.
# Input: captures of a USB device that is enumerated and sends one report: X, eight buttons and Y,
# of 16, 8 x 1 and 16 bits. Its report descriptor sets the sizes of the buttons between Push and
# Pop, or writes them out without; a third has one usage, X, for three fields of a byte.
# Behaviour: written out, all ten fields are shown. With Push and Pop, which HID 1.11 (6.2.2.7) has
# for this and drivers read, the report is not taken apart: raw bytes only, no warning. Of the
# third, the first field is shown as X and the others as padding, while 6.2.2.8 gives the last usage
# to all fields that remain. One would guess that an analyser knows each of the few item tags.
# Output seen: "plain: 10 fields, padding 0", "push: 0 fields, padding 0", "repeat: 1 fields,
# padding 1".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
version=4.0.17-0+deb12u3
mkdir -p "$folder/archives/partial" "$folder/tree"
apt-get install -y -qq --no-install-recommends --download-only \
    -o "Dir::Cache::archives=$folder/archives" "tshark=$version" python3 >/dev/null 2>&1 ||
    { echo "cannot get tshark $version"; exit 2; }
for package in "$folder"/archives/*.deb; do
    [ ! -e "$package" ] || dpkg-deb -x "$package" "$folder/tree" || exit 2
done
PATH=$folder/tree/usr/bin:$PATH
LD_LIBRARY_PATH=$folder/tree/usr/lib/$(uname -m)-linux-gnu
HOME=$folder
export PATH LD_LIBRARY_PATH HOME
cat >"$folder/capture.py" <<'END'
import struct
import sys

axes = "1601 80 26ff7f 7510 9501 "  # signed, one field of 16 bits
buttons = "0509 1901 2908 1500 2501 7501 9508 8102 "
bodies = {
    "plain": axes + "0930 8102 " + buttons + "0501 " + axes + "0931 8102",
    "push": axes + "0930 8102 a4 " + buttons + "b4 0931 8102",
    "repeat": "1581 257f 7508 9503 0930 8102",
}
descriptor = bytes.fromhex("0501 0904 a101 " + bodies[sys.argv[1]] + " c0")
report = bytes.fromhex("010203" if sys.argv[1] == "repeat" else "fbff812c01")
device = bytes.fromhex("1201000200000040 0912 0100 0001 000000 01")
interface = bytes.fromhex("0904000001 030000 00 092111010001 22") + struct.pack("<H", len(descriptor))
interface += bytes.fromhex("0705810340000a")
configuration = struct.pack("<BBHBBBBB", 9, 2, 9 + len(interface), 1, 1, 0, 0x80, 50) + interface

out = open(sys.argv[2], "wb")
out.write(struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 220))
count = 0


def packet(kind, transfer, endpoint, setup, data, length):
    head = struct.pack("<QBBBBHccqiiII", 1 + count // 2, ord(kind), transfer, endpoint, 5, 1,
                       b"\0" if setup else b"-", b"\0" if data else b"<", count, 0, 0, length,
                       len(data))
    head += (setup or bytes(8)) + bytes(16)
    out.write(struct.pack("<IIII", count, 0, 64 + len(data), 64 + len(data)) + head + data)


for transfer, endpoint, setup, data in [
        (2, 0x80, struct.pack("<BBHHH", 0x80, 6, 0x100, 0, 18), device),
        (2, 0x80, struct.pack("<BBHHH", 0x80, 6, 0x200, 0, 255), configuration),
        (2, 0x80, struct.pack("<BBHHH", 0x81, 6, 0x2200, 0, 255), descriptor),
        (1, 0x81, None, report)]:
    packet("S", transfer, endpoint, setup, b"", len(data))
    count += 1
    packet("C", transfer, endpoint, None, data, len(data))
    count += 1
END
seen=$(for kind in plain push repeat; do
    python3 "$folder/capture.py" $kind "$folder/in.pcap" || exit 2
    tshark -r "$folder/in.pcap" -V -Y usb.endpoint_address==0x81 2>/dev/null >"$folder/text"
    sed -n '/^HID Data/,$p' "$folder/text" >"$folder/report"
    [ -s "$folder/report" ] || exit 2
    echo "$kind: $(grep -c ' = ' "$folder/report") fields," \
        "padding $(grep -c Padding "$folder/report")"
done) || exit 2
echo "$seen"
[ "$seen" = "plain: 10 fields, padding 0
push: 0 fields, padding 0
repeat: 1 fields, padding 1" ]
