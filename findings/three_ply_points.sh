#!/bin/sh
# three_ply_points.sh - one Points object in a scene, and three.js writes no face at all as PLY
#
# Software: npm package three 0.187.0, examples/jsm/exporters/PLYExporter.js.
# Input: a scene of a box (12 triangles), and the same with a Points object of one point beside it.
# Behaviour: with the Points object the file has all vertices of both, but neither the faces nor
# the element `face`; nothing is said on the console. OBJExporter and STLExporter write the box
# from the same scene. One would guess that points add vertices, or are left out.
# Output seen: "alone: 24 vertices, 12 faces", "with points: 25 vertices, 0 faces", "obj: 12
# faces", "stl: 12 faces", "0 warnings".
# Exit status 1 when that changes, 2 when the package cannot be had. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$folder" three@0.187.0 \
    >/dev/null 2>&1 || { echo "cannot get three"; exit 2; }
cat >"$folder/write.mjs" <<'END'
import * as THREE from "three";
import { OBJExporter } from "three/examples/jsm/exporters/OBJExporter.js";
import { PLYExporter } from "three/examples/jsm/exporters/PLYExporter.js";
import { STLExporter } from "three/examples/jsm/exporters/STLExporter.js";

let warnings = 0;
console.warn = console.error = () => warnings++;
globalThis.requestAnimationFrame = (then) => setTimeout(then, 0); // for its callback

const scene = new THREE.Scene();
scene.add(new THREE.Mesh(new THREE.BoxGeometry()));
const number = (text, pattern) => Number(text.match(pattern)?.[1] ?? 0);

function tell(name) {
    const text = new PLYExporter().parse(scene, () => {}, {});
    console.log(`${name}: ${number(text, /element vertex (\d+)/)} vertices, ` +
        `${number(text, /element face (\d+)/)} faces`);
}

tell("alone");
const point = new THREE.BufferGeometry();
point.setAttribute("position", new THREE.Float32BufferAttribute([2, 2, 2], 3));
scene.add(new THREE.Points(point));
tell("with points");
console.log(`obj: ${new OBJExporter().parse(scene).match(/^f /gm).length} faces`);
console.log(`stl: ${new STLExporter().parse(scene).match(/endfacet/g).length} faces`);
console.log(`${warnings} warnings`);
END
seen=$(node "$folder/write.mjs")
echo "$seen"
[ "$seen" = "alone: 24 vertices, 12 faces
with points: 25 vertices, 0 faces
obj: 12 faces
stl: 12 faces
0 warnings" ]
