#!/bin/sh
# streamdeck_brightness_long.sh - python-elgato-streamdeck sets brightness by a report too long
#
# Software: Debian's python3-elgato-streamdeck 0.9.1+ds-1 (python-elgato-streamdeck 0.9.1).
# Input: a fake device that says how long each feature report is, and the calls set_brightness(50)
# and reset() of each of the library's classes that share a shape of report.
# Behaviour: of the second generation (V2, XL) reset goes out as a feature report of 32 bytes, its
# number included, and brightness as one of 33: three bytes are assigned to a slice of two, which
# makes a bytearray longer. One would guess both to be 32, as the line above each says
# (`bytearray(32)`), and as other drivers of these devices send them. The Mini gets 17 for both.
# Output seen: "StreamDeckMini: 17 and 17, StreamDeckOriginalV2: 33 and 32, StreamDeckXL: 33 and 32".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/archives/partial" "$folder/tree"
(cd "$folder/archives" && apt-get download -qq python3-elgato-streamdeck=0.9.1+ds-1) \
    >/dev/null 2>&1 || { echo "cannot get python3-elgato-streamdeck 0.9.1+ds-1"; exit 2; }
dpkg-deb -x "$folder"/archives/*.deb "$folder/tree" || exit 2
cat >"$folder/lengths.py" <<'END'
import importlib

class Device:
    def write_feature(self, payload):
        self.length = len(payload)

    def close(self):
        pass

said = []
for name in ["StreamDeckMini", "StreamDeckOriginalV2", "StreamDeckXL"]:
    deck = getattr(importlib.import_module("StreamDeck.Devices." + name), name)(Device())
    deck.set_brightness(50)
    bright = deck.device.length
    deck.reset()
    said.append(f"{name}: {bright} and {deck.device.length}")
print(", ".join(said))
END
seen=$(PYTHONPATH=$folder/tree/usr/lib/python3/dist-packages python3 "$folder/lengths.py" 2>&1)
echo "$seen"
[ "$seen" = "StreamDeckMini: 17 and 17, StreamDeckOriginalV2: 33 and 32, StreamDeckXL: 33 and 32" ]
