#!/bin/sh
# babylon_stl_left_out.sh - Babylon.js reads nothing of a nameless STL, and drops corners like ".5"
#
# Software: npm packages @babylonjs/core 9.35.0 and @babylonjs/loaders 9.28.0, STLFileLoader, in
# Node.js with the NullEngine.
# Input: one triangle as an ASCII STL: named; without a name behind "solid" and "endsolid", as many
# programs write it; with a coordinate of .5; and with a normal of three nan, as exporters give
# triangles without area.
# Behaviour: a pattern finds a solid by what stands on both sides of its name, so that a file
# without one has no solid: no mesh, no word. Numbers have a pattern, too, that wants a digit before
# the point, and knows no nan: the corner is left out, and the triangle is left with two positions
# for its three indices; a normal of nan takes its whole triangle along. One would guess that the
# name is optional, as it is in all other readers, and that numbers are what parseFloat reads.
# Output seen: "named: 1 meshes, 3 positions, 3 indices", "nameless: 0 meshes", ".5: 1 meshes, 2
# positions, 3 indices", "nan: 1 meshes, 0 positions, 0 indices".
# Exit status 1 when that changes, 2 when the packages cannot be had. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 2
npm install --silent --no-audit --no-fund --ignore-scripts @babylonjs/core@9.35.0 \
    @babylonjs/loaders@9.28.0 >/dev/null 2>&1 || { echo "cannot get Babylon.js"; exit 2; }
cat >read.mjs <<'END_JS'
import { NullEngine } from "@babylonjs/core/Engines/nullEngine.js";
import { Logger } from "@babylonjs/core/Misc/logger.js";
import { Scene } from "@babylonjs/core/scene.js";
import { STLFileLoader } from "@babylonjs/loaders/STL/index.js";

Logger.LogLevels = Logger.NoneLogLevel;
const engine = new NullEngine();

function stl(name, normal, x) {
    return `solid${name}\nfacet normal ${normal}\nouter loop\nvertex ${x} 0 0\nvertex 1 0 0\n`
        + `vertex 1 1 0\nendloop\nendfacet\nendsolid${name}\n`;
}

const inputs = [["named", stl(" a", "0 0 1", "0.5")], ["nameless", stl("", "0 0 1", "0.5")],
    [".5", stl(" a", "0 0 1", ".5")], ["nan", stl(" a", "nan nan nan", "0.5")]];
for (const [name, text] of inputs) {
    const scene = new Scene(engine);
    new STLFileLoader().importMesh(null, scene, text, "", null);
    const of = scene.meshes.map((mesh) => `, ${mesh.getTotalVertices()} positions, `
        + `${mesh.getIndices().length} indices`);
    console.log(`${name}: ${scene.meshes.length} meshes${of.join("")}`);
}
process.exit(0);
END_JS
seen=$(node read.mjs 2>&1 | grep -v "Null engine") || { echo "$seen"; exit 2; }
echo "$seen"
[ "$seen" = "named: 1 meshes, 3 positions, 3 indices
nameless: 0 meshes
.5: 1 meshes, 2 positions, 3 indices
nan: 1 meshes, 0 positions, 0 indices" ]
