#!/bin/sh
# upng_grey_rows.sh - upng-js shears grey PNGs of 1, 2 and 4 bits whose rows do not end with a byte
#
# Software: npm packages upng-js 2.1.0 (with pako 1.0.11), beside pngjs 7.0.0.
# Input: grey PNGs of 13 x 3 pixels, as for a monochrome panel: white where x is 0, so that each row
# is one white pixel and twelve black ones, with 1, 2, 4 and 8 bits per pixel.
# Behaviour: each row of a PNG begins with a byte of its own, and 13 pixels of fewer than 8 bits end
# in the middle of one. UPNG.toRGBA8 counts pixels on through all rows, padding taken for pixels, so
# the white column becomes a diagonal; palettes of the same depths are read row by row. Widths that
# are multiples of 8 hide it. One would guess that depths differ in nothing but the bits.
# Output seen: column of the white pixel in rows 0, 1 and 2, by upng-js: 1 bit 0 3 6, 2 bits 0 3 6,
# 4 bits 0 1 2, 8 bits 0 0 0; by pngjs 0 0 0 always.
# Exit status 1 when that changes, 2 when the packages cannot be had. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 2
npm install --silent --no-audit --no-fund --ignore-scripts upng-js@2.1.0 pako@1.0.11 pngjs@7.0.0 \
    >/dev/null 2>&1 || { echo "cannot get upng-js"; exit 2; }
cat >read.mjs <<'END_JS'
import { crc32, deflateSync } from "node:zlib";
import { PNG } from "pngjs";
import UPNG from "upng-js";

const width = 13, height = 3;

function chunk(name, data) {
    const body = Buffer.concat([Buffer.from(name), data]);
    const head = Buffer.alloc(4), check = Buffer.alloc(4);
    head.writeUInt32BE(data.length);
    check.writeUInt32BE(crc32(body));
    return Buffer.concat([head, body, check]);
}

function picture(bits) {
    const head = Buffer.alloc(13);
    head.writeUInt32BE(width);
    head.writeUInt32BE(height, 4);
    head[8] = bits;
    const row = Buffer.alloc(1 + Math.ceil(width * bits / 8));
    row[1] = 0x100 - (1 << 8 - bits);
    return Buffer.concat([Buffer.from("89504e470d0a1a0a", "hex"), chunk("IHDR", head),
        chunk("IDAT", deflateSync(Buffer.concat([row, row, row]))),
        chunk("IEND", row.subarray(0, 0))]);
}

function columns(rgba) {
    return [0, 1, 2].map((y) => {
        const row = Array.from({ length: width }, (_, x) => rgba[4 * (width * y + x)]);
        return row.includes(255) ? row.indexOf(255) : "-";
    }).join(" ");
}

for (const bits of [1, 2, 4, 8]) {
    const png = picture(bits);
    const read = UPNG.decode(Uint8Array.from(png).buffer);
    const upng = columns(new Uint8Array(UPNG.toRGBA8(read)[0]));
    console.log(`${bits} bits: upng-js ${upng}, pngjs ${columns(PNG.sync.read(png).data)}`);
}
END_JS
seen=$(node read.mjs 2>&1) || { echo "$seen"; exit 2; }
echo "$seen"
[ "$seen" = "1 bits: upng-js 0 3 6, pngjs 0 0 0
2 bits: upng-js 0 3 6, pngjs 0 0 0
4 bits: upng-js 0 1 2, pngjs 0 0 0
8 bits: upng-js 0 0 0, pngjs 0 0 0" ]
