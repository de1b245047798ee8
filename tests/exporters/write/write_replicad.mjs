// write_replicad - Open CASCADE as WebAssembly, through replicad: STL of solids it models itself
//
// SPDX-License-Identifier: MIT
import { load, loadFile, require, save } from "./shapes_made.mjs";
import fs from "node:fs";
import path from "node:path";

const folder = path.resolve("node_modules/replicad-opencascadejs/dist");
globalThis.__dirname = folder;
globalThis.require = require;
const start = (await loadFile("replicad-opencascadejs/dist/replicad_single.js")).default;
const wasmBinary = fs.readFileSync(path.join(folder, "replicad_single.wasm"));
const cascade = await start({ wasmBinary });
const replicad = await load("replicad");
replicad.setOC(cascade);

const { drawRectangle, draw, makeSphere, makeCylinder } = replicad;
const star = draw([1.1, 0]);
for (let i = 1; i < 10; i++) {
    const out = i % 2 ? 0.4 : 1.1, angle = Math.PI * i / 5;
    star.lineTo([out * Math.cos(angle), out * Math.sin(angle)]);
}
const solids = {
    cube: drawRectangle(1.0333, 1.1346).sketchOnPlane().extrude(5.1416),
    prism: star.close().sketchOnPlane().extrude(0.3),
    ball: makeSphere(0.7).cut(makeCylinder(0.2, 2, [0, 0, -1])),
};
for (const [name, solid] of Object.entries(solids)) {
    for (const binary of [false, true]) {
        const blob = solid.blobSTL({ tolerance: 0.01, angularTolerance: 0.3, binary });
        save({ name }, `${binary ? "binary" : "ascii"}.stl`, await blob.arrayBuffer());
    }
}
