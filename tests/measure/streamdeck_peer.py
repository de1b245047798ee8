# streamdeck_peer.py FOLDER - Debian's python3-elgato-streamdeck on a device that only listens
#
# It gets each key's file, as it is in our reports, and must send the same reports. What the file
# shows must be the picture as this library would turn it: BMP to the last bit, JPEG, read by
# djpeg, to 38 dB.
# SPDX-License-Identifier: MIT
import math
import subprocess
import sys
from importlib.metadata import version

from StreamDeck.Devices.StreamDeckMini import StreamDeckMini
from StreamDeck.Devices.StreamDeckOriginal import StreamDeckOriginal
from StreamDeck.Devices.StreamDeckOriginalV2 import StreamDeckOriginalV2
from StreamDeck.Devices.StreamDeckXL import StreamDeckXL

FOLDER = sys.argv[1]
MODELS = [("streamdeck-mini", StreamDeckMini, 16), ("streamdeck-original", StreamDeckOriginal, 16),
          ("streamdeck", StreamDeckOriginalV2, 8), ("streamdeck-xl", StreamDeckXL, 8)]


class Listener:
    def __init__(self):
        self.reports, self.features = [], []

    def write(self, payload):
        self.reports.append(bytes(payload))

    def write_feature(self, payload):
        self.features.append(bytes(payload))

    def close(self):
        pass


def read_ppm(data):
    head = data.split(b"\n", 3)
    width, height = map(int, head[1].split())
    return width, height, head[3]


def read_reports(name):
    data, reports = open(f"{FOLDER}/{name}", "rb").read(), []
    while data:
        size = int.from_bytes(data[:4], "little")
        reports.append(data[4:4 + size])
        data = data[4 + size:]
    return reports


# Rows of pixels, turned by 90 degrees against the clock, then mirrored: as PIL would.
def oriented(rows, deck):
    if deck.KEY_ROTATION == 90:
        rows = [list(column) for column in zip(*rows)][::-1]
    elif deck.KEY_ROTATION != 0:
        sys.exit(f"streamdeck_peer.py: cannot turn by {deck.KEY_ROTATION}")
    if deck.KEY_FLIP[0]:
        rows = [row[::-1] for row in rows]
    return rows[::-1] if deck.KEY_FLIP[1] else rows


def rows_of_bmp(data, side):
    stride = (3 * side + 3) // 4 * 4
    rows = [data[54 + y * stride:54 + y * stride + 3 * side] for y in range(side)]
    return [[row[3 * x + 2::-1][:3] if x == 0 else row[3 * x + 2:3 * x - 1:-1] for x in range(side)]
            for row in rows[::-1]]


def rows_of_jpeg(data):
    ppm = subprocess.run(["djpeg", "-ppm"], input=data, stdout=subprocess.PIPE, check=True).stdout
    width, height, rgb = read_ppm(ppm)
    return [[rgb[3 * (y * width + x):][:3] for x in range(width)] for y in range(height)]


def decibels(ours, theirs):
    pairs = [(a, b) for row, other in zip(ours, theirs) for p, q in zip(row, other)
             for a, b in zip(p, q)]
    total = sum((a - b) ** 2 for a, b in pairs)
    return math.inf if total == 0 else 10 * math.log10(255 * 255 * len(pairs) / total)


def file_of(reports, deck, head):
    if deck.KEY_IMAGE_FORMAT == "BMP":
        size = int.from_bytes(reports[0][head + 2:head + 6], "little")
        part = size // 2 if isinstance(deck, StreamDeckOriginal) else len(reports[0]) - head
        return b"".join(r[head:head + part] for r in reports)[:size]
    return b"".join(r[head:head + int.from_bytes(r[4:6], "little")] for r in reports)


# Version 0.9.1 makes a brightness report of 33 bytes, for three go where it has room for two.
def starts(theirs, mine):
    return theirs[:len(mine)] == mine and not any(theirs[len(mine):])


def compare(name, kind, head):
    device = Listener()
    deck = kind(device)
    ours, side = read_reports(name + ".reports"), deck.KEY_PIXEL_WIDTH
    width, _, rgb = read_ppm(open(f"{FOLDER}/{name}.ppm", "rb").read())
    same, least = 0, math.inf
    if deck.KEY_IMAGE_FORMAT == "BMP": # it begins with the end of an image
        deck._reset_key_stream()
        same += ours[0] == device.reports[0]
        ours = ours[1:]
    at = 0
    for key in range(deck.KEY_COUNT):
        end = at
        while not ours[end][4 if head == 16 else 3]:
            end += 1
        mine = ours[at:end + 1]
        at = end + 1
        data, device.reports = file_of(mine, deck, head), []
        deck.set_key_image(key, data)
        same += sum(a == b for a, b in zip(mine, device.reports))
        if len(mine) != len(device.reports):
            print(f"    key {key}: {len(mine)} reports, theirs are {len(device.reports)}")
        left, top = key % deck.KEY_COLS * side, key // deck.KEY_COLS * side
        rows = [[rgb[3 * ((top + y) * width + left + x):][:3] for x in range(side)]
                for y in range(side)]
        shown = rows_of_bmp(data, side) if deck.KEY_IMAGE_FORMAT == "BMP" else rows_of_jpeg(data)
        least = min(least, decibels(shown, oriented(rows, deck)))
    deck.set_brightness(70)
    deck.reset()
    features = all(starts(theirs, mine) for theirs, mine in
                   zip(device.features, read_reports(name + ".features"), strict=True))
    total = len(read_reports(name + ".reports"))
    good = same == total and at == len(ours) and features and \
        least >= (math.inf if deck.KEY_IMAGE_FORMAT == "BMP" else 38)
    what = "every pixel" if least == math.inf else f"{least:.1f} dB at least"
    print(f"{'pass' if good else 'FAIL'} {name}: {same} of {total} reports and "
          f"{'both' if features else 'not both'} feature reports are the same, {what}")
    return good


print(f"python3-elgato-streamdeck {version('streamdeck')}:")
sys.exit(0 if all([compare(*model) for model in MODELS]) else 1)
