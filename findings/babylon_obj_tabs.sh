#!/bin/sh
# babylon_obj_tabs.sh - Babylon.js makes NaN of an OBJ's coordinates when tabs stand between them
#
# Software: npm packages @babylonjs/core 9.35.0 and @babylonjs/loaders 9.28.0, OBJFileLoader, in
# Node.js with the NullEngine.
# Input: one triangle as OBJ, with blanks between numbers, with tabs in the lines of vertices, and
# with tabs in the line of the face.
# Behaviour: what a line is, the loader finds by patterns that take any white space; it then
# splits a vertex at blanks alone, so "1", tab, "2", tab, "3" is one word, of which parseFloat reads
# the 1. y and z are undefined, and NaN once they are in the buffer: the triangle is there, its box
# and normals are NaN, and nothing can be seen of it. The line of a face with tabs is dropped.
# Neither is reported. Exporters do write tabs, and one would guess that white space is white space,
# as the patterns say.
# Output seen: "blanks: 3 indices, -1 2 3", "vertices by tabs: 3 indices, -1 NaN NaN", "face by
# tabs: 0 indices, 1 2 3" (x is mirrored only when there are faces).
# Exit status 1 when that changes, 2 when the packages cannot be had. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 2
npm install --silent --no-audit --no-fund --ignore-scripts @babylonjs/core@9.35.0 \
    @babylonjs/loaders@9.28.0 >/dev/null 2>&1 || { echo "cannot get Babylon.js"; exit 2; }
cat >read.mjs <<'END_JS'
import { NullEngine } from "@babylonjs/core/Engines/nullEngine.js";
import { SceneLoader } from "@babylonjs/core/Loading/sceneLoader.js";
import { Logger } from "@babylonjs/core/Misc/logger.js";
import { Scene } from "@babylonjs/core/scene.js";
import "@babylonjs/loaders/OBJ/index.js";

Logger.LogLevels = Logger.ErrorLogLevel | Logger.WarningLogLevel;
globalThis.XMLHttpRequest = class {};
const engine = new NullEngine();
const inputs = [
    ["blanks", "v 1 2 3\nv 4 5 6\nv 7 8 9\nf 1 2 3\n"],
    ["vertices by tabs", "v 1\t2\t3\nv 4\t5\t6\nv 7\t8\t9\nf 1 2 3\n"],
    ["face by tabs", "v 1 2 3\nv 4 5 6\nv 7 8 9\nf 1\t2\t3\n"],
];
for (const [name, text] of inputs) {
    const scene = new Scene(engine);
    const data = "data:" + text;
    const read = await SceneLoader.ImportMeshAsync("", "", data, scene, undefined, ".obj");
    const mesh = read.meshes[0];
    const first = Array.from(mesh.getVerticesData("position")).slice(0, 3).join(" ");
    console.log(`${name}: ${mesh.getIndices().length} indices, ${first}`);
}
process.exit(0);
END_JS
seen=$(node read.mjs 2>&1) || { echo "$seen"; exit 2; }
echo "$seen"
[ "$seen" = "blanks: 3 indices, -1 2 3
vertices by tabs: 3 indices, -1 NaN NaN
face by tabs: 0 indices, 1 2 3" ]
