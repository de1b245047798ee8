#!/bin/sh
# rapier_cast_limit.sh - a ray that ends on a surface hits it or not, by who is asked in Rapier
#
# Software: npm package @dimforge/rapier3d-compat 0.21.0.
# Input: a box whose top is the plane y = 0, and a ray down from y = 1 with maxToi 1: all numbers
# are exact in float. Then the same with the next larger limit, 1.0000001.
# Behaviour: the collider's own castRay and the world's intersectionsWithRay report a hit at 1. The
# world's castRay and castRayAndGetNormal, the ones for the closest hit, report none, with the same
# ray and limit. The documentation calls maxToi the largest time of impact that can be reported. So
# "does anything lie between these two points", asked with a limit of 1, has two answers in one
# library. One would guess one interval, open or closed, for every query.
# Output seen: "limit 1: world null null, all 1, collider 1", "limit 1.0000001: world 1 1, all 1,
# collider 1".
# Exit status 1 when that changes, 2 when the package cannot be had. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$folder" \
    @dimforge/rapier3d-compat@0.21.0 >/dev/null 2>&1 ||
    { echo "cannot get @dimforge/rapier3d-compat"; exit 2; }
cat >"$folder/cast.mjs" <<'END'
import rapier from "@dimforge/rapier3d-compat";

console.warn = () => {}; // the loader's word on its own arguments
await rapier.init();
const world = new rapier.World({ x: 0, y: 0, z: 0 });
const box = world.createCollider(rapier.ColliderDesc.cuboid(1, 0.5, 1).setTranslation(0, -0.5, 0));
world.step(); // only then does the world know it
const ray = new rapier.Ray({ x: 0.25, y: 1, z: 0.25 }, { x: 0, y: -1, z: 0 });
for (const limit of [1, 1.0000001]) {
    const first = world.castRay(ray, limit, true)?.timeOfImpact ?? null;
    const normal = world.castRayAndGetNormal(ray, limit, true)?.timeOfImpact ?? null;
    const all = [];
    world.intersectionsWithRay(ray, limit, true, (hit) => all.push(hit.timeOfImpact) > 0);
    console.log(`limit ${limit}: world ${first} ${normal}, all ${all}, ` +
        `collider ${box.castRay(ray, limit, true)}`);
}
END
seen=$(node "$folder/cast.mjs")
echo "$seen"
[ "$seen" = "limit 1: world null null, all 1, collider 1
limit 1.0000001: world 1 1, all 1, collider 1" ]
