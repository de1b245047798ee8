// read_three - three.js: PLYLoader
//
// SPDX-License-Identifier: MIT
import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const file = path.resolve("node_modules/three/examples/jsm/loaders/PLYLoader.js");
const { PLYLoader } = await import(pathToFileURL(file));
for (const mesh of process.argv.slice(2)) {
    const bytes = fs.readFileSync(mesh);
    const geometry = new PLYLoader().parse(
        bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
    console.log(path.basename(mesh), geometry.index.count / 3,
        geometry.attributes.position.count);
}
