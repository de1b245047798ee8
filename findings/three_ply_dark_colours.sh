#!/bin/sh
# three_ply_dark_colours.sh - three.js's PLYLoader makes one black of the darkest greys of a mesh
#
# Software: npm package three 0.187.0, examples/jsm/loaders/PLYLoader.js.
# Input: a PLY of 256 points with all greys from 0 to 255 as uchar red, green and blue, and the same
# with the colours as float, from 0 to 1.
# Behaviour: the loader takes colours for sRGB and converts them to linear light, as OBJLoader does.
# But where the file has bytes, the linear values are bytes again: 0 to 6 are all black, 7 to 17 are
# one grey, and 73 of 256 greys are lost, the dark ones, where an eye sees steps best. The float
# file of the same colours keeps every one. Bytes are what nearly all PLY files with colours have.
# One would guess 256 greys from a file that has 256, as linear light in a byte is known to be short
# of dark tones: either floats, or the file's bytes and a conversion by who draws them.
# Output seen: "uchar: 183 greys in Uint8Array, the first that is not black is 7", "float: 256
# greys in Float32Array, the first that is not black is 1".
# Exit status 1 when that changes, 2 when the package cannot be had. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$folder" three@0.187.0 \
    >/dev/null 2>&1 || { echo "cannot get three"; exit 2; }
cat >"$folder/read.mjs" <<'END'
import { PLYLoader } from "three/examples/jsm/loaders/PLYLoader.js";

function tell(type, grey) {
    const lines = ["ply", "format ascii 1.0", "element vertex 256"];
    lines.push(...["x", "y", "z"].map((name) => `property float ${name}`));
    lines.push(...["red", "green", "blue"].map((name) => `property ${type} ${name}`), "end_header");
    for (let at = 0; at < 256; at++) lines.push(`${at} 0 0 ${`${grey(at)} `.repeat(3)}`);
    const color = new PLYLoader().parse(`${lines.join("\n")}\n`).getAttribute("color");
    const reds = Array.from({ length: color.count }, (_, at) => color.getX(at));
    console.log(`${type}: ${new Set(reds).size} greys in ${color.array.constructor.name}, ` +
        `the first that is not black is ${reds.findIndex((red) => red > 0)}`);
}

tell("uchar", (at) => at);
tell("float", (at) => at / 255);
END
seen=$(node "$folder/read.mjs") || exit 2
echo "$seen"
[ "$seen" = "uchar: 183 greys in Uint8Array, the first that is not black is 7
float: 256 greys in Float32Array, the first that is not black is 1" ]
