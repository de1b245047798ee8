// write_stl - the npm packages stl and stl-exporter: STL, ASCII and binary
//
// SPDX-License-Identifier: MIT
import { made, require, save } from "./shapes_made.mjs";

const stl = require("stl");

for (const shape of made) {
    const facets = shape.triangles.map((t) => ({ normal: [0, 0, 1],
        verts: t.map((corner) => shape.positions[corner]) }));
    save(shape, "ascii.stl", stl.fromObject({ description: shape.name, facets }));
    save(shape, "binary.stl", stl.fromObject({ description: shape.name, facets }, true));
}
