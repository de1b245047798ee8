// shapes_made - the shapes of a folder, for the writers that are npm packages
//
// They run in the folder where npm has put their package: `load` looks there.
// SPDX-License-Identifier: MIT
import fs from "node:fs";
import path from "node:path";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

export const require = createRequire(path.join(process.cwd(), "of.js"));
export const load = (name) => import(pathToFileURL(require.resolve(name)));
// For what a package has but does not list in its `exports`.
export const loadFile = (file) => import(pathToFileURL(path.resolve("node_modules", file)));

const [shapes, out] = process.argv.slice(2);
export const made = fs.readdirSync(shapes).filter((name) => name.endsWith(".json")).sort()
    .map((name) => JSON.parse(fs.readFileSync(path.join(shapes, name))));

// save(shape, "ascii.ply", string or bytes)
export function save(shape, suffix, content) {
    const bytes = typeof content === "string" ? content
        : ArrayBuffer.isView(content)
            ? Buffer.from(content.buffer, content.byteOffset, content.byteLength)
            : Buffer.from(content);
    fs.writeFileSync(path.join(out, `${shape.name}.${suffix}`), bytes);
}

// The objects of a shape: positions, faces from 0, colours and uv where the shape has them.
export function objects(shape, faces) {
    return shape.objects.map((part) => {
        const [first, count] = part.positions, [begin, number] = part[faces];
        const own = (list) => list && list.slice(first, first + count);
        return {
            positions: own(shape.positions), colours: own(shape.colours), uv: own(shape.uv),
            faces: shape[faces].slice(begin, begin + number)
                .map((face) => face.map((corner) => corner - first)),
        };
    });
}
