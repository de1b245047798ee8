#!/bin/sh
# jscad_snapped_stl.sh - JSCAD's serializers move vertices to a grid, each object to its own
#
# Software: npm packages @jscad/modeling 2.13.0, @jscad/stl-serializer 2.1.23.
# Input: a cuboid of side 2 and one of 10 x 10.1 x 10.3 that touches it at x = 2.
# Behaviour: before it writes, the serializer snaps a solid to a grid of 1e-5 times the mean of
# its sides. So x = 2 of the large one, which floats hold exactly, becomes another number, in
# binary files, too; and as each solid has its own grid, the plane that the two share lies at two
# places in one file. One would guess that a binary STL has the model's coordinates, rounded to
# float.
# Output seen: "2 2.0000159740448", the x that are near 2.
# Exit status 1 when that changes, 2 when a package cannot be had. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$folder" \
    @jscad/modeling@2.13.0 @jscad/stl-serializer@2.1.23 >/dev/null 2>&1 ||
    { echo "cannot get @jscad/modeling, @jscad/stl-serializer"; exit 2; }
cat >"$folder/write.js" <<'END'
const { primitives } = require("@jscad/modeling");
const stl = require("@jscad/stl-serializer");
const small = primitives.cuboid({ size: [2, 2, 2], center: [1, 1, 1] });
const large = primitives.cuboid({ size: [10, 10.1, 10.3], center: [7, 5, 5] });
const bytes = Buffer.concat(stl.serialize({ binary: true }, [small, large])
    .map((part) => Buffer.from(part)));
const xs = new Set();
for (let at = 84; at < bytes.length; at += 50) {
    for (const corner of [12, 24, 36]) {
        xs.add(bytes.readFloatLE(at + corner));
    }
}
console.log([...xs].filter((x) => Math.abs(x - 2) < 0.01).sort().join(" "));
END
seen=$(node "$folder/write.js")
echo "$seen"
[ "$seen" = "2 2.0000159740448" ]
