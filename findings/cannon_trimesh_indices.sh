#!/bin/sh
# cannon_trimesh_indices.sh - rays fall through meshes of more than 32768 vertices in cannon-es
#
# Software: npm package cannon-es 0.20.0, Trimesh and World.raycastClosest.
# Input: a flat grid of triangles without holes, once with 180 x 180 cells (32761 vertices) and
# once with 200 x 200 (40401), and a ray down into every tenth cell, both ways.
# Behaviour: Trimesh takes indices as an array of numbers and keeps them in an Int16Array. An index
# above 32767 wraps to a negative one, whose vertex has NaN for coordinates; its triangle is then
# never hit. Nothing is thrown or printed, the rest of the mesh works, so the far fifth of a
# terrain has no ground. One would guess that a list of numbers holds any index, or a mistake told.
# Output seen: "32761 vertices: 0 of 324 rays miss", "40401 vertices: 80 of 400 rays miss".
# Exit status 1 when that changes, 2 when the package cannot be had. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$folder" \
    cannon-es@0.20.0 >/dev/null 2>&1 || { echo "cannot get cannon-es"; exit 2; }
cat >"$folder/cast.mjs" <<'END'
import { Body, RaycastResult, Trimesh, Vec3, World } from "cannon-es";

function grid(side) {
    const points = [];
    const corners = [];
    for (let z = 0; z <= side; z++) {
        for (let x = 0; x <= side; x++) {
            points.push(x, 0, z);
            if (x < side && z < side) {
                const at = z * (side + 1) + x;
                const above = at + side + 1;
                corners.push(at, above, at + 1, at + 1, above, above + 1);
            }
        }
    }
    return new Trimesh(points, corners);
}

for (const side of [180, 200]) {
    const world = new World();
    world.addBody(new Body({ mass: 0, shape: grid(side) }));
    let rays = 0;
    let misses = 0;
    for (let z = 5; z < side; z += 10) {
        for (let x = 5; x < side; x += 10) {
            const hit = new RaycastResult();
            world.raycastClosest(new Vec3(x + 0.25, 5, z + 0.25),
                new Vec3(x + 0.25, -5, z + 0.25), {}, hit);
            rays++;
            misses += hit.hasHit ? 0 : 1;
        }
    }
    console.log(`${(side + 1) ** 2} vertices: ${misses} of ${rays} rays miss`);
}
END
seen=$(node "$folder/cast.mjs")
echo "$seen"
[ "$seen" = "32761 vertices: 0 of 324 rays miss
40401 vertices: 80 of 400 rays miss" ]
