#!/bin/sh
# watertight_ray_misses_nothing.sh - a ray that looks down an axis hits every triangle there is
#
# Software: npm package watertight-ray-triangle-intersection 0.0.1, which follows the paper of
# Woop, Benthin and Wald. Input: one triangle in the plane y = 0, rays along y, above and below it.
# Behaviour: the paper shears along the axis where the direction is largest by magnitude, and the
# package takes the largest with its sign. So for (0, -1, 0) that is an axis whose component is
# zero, and a triangle 50 units off the ray is hit, at NaN, as no test of a NaN is true; the ray
# (0, 1, 0), the same line from below, is right. (The README says that a zero in a ray is unsolved,
# not that each triangle is then hit.) There is no test of the distance either: a ray that starts
# above the triangle and points up hits it, behind its start, and nothing of what is returned tells
# that. One would guess misses from an algorithm that is known for losing none and adding none.
# Output seen: "down, 50 beside: NaN NaN NaN", "up, 50 beside: none", "up, from above: 0.25 0 0.25".
# Exit status 1 when that changes, 2 when the package cannot be had. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$folder" \
    watertight-ray-triangle-intersection@0.0.1 >/dev/null 2>&1 ||
    { echo "cannot get watertight-ray-triangle-intersection"; exit 2; }
cat >"$folder/ask.js" <<'END'
const intersect = require("watertight-ray-triangle-intersection");
const triangle = [[0, 0, 0], [1, 0, 0], [0, 0, 1]];
function tell(name, origin, direction) {
    const point = intersect([], origin, direction, triangle);
    console.log(`${name}: ${point ? point.join(" ") : "none"}`);
}
tell("down, 50 beside", [50, 1, 50], [0, -1, 0]);
tell("up, 50 beside", [50, -1, 50], [0, 1, 0]);
tell("up, from above", [0.25, 1, 0.25], [0, 1, 0]);
END
seen=$(node "$folder/ask.js")
echo "$seen"
[ "$seen" = "down, 50 beside: NaN NaN NaN
up, 50 beside: none
up, from above: 0.25 0 0.25" ]
