// write_stl_exporter - the npm package stl-exporter: STL, ASCII and binary
//
// SPDX-License-Identifier: MIT
import { made, require, save } from "./shapes_made.mjs";

const exporter = require("stl-exporter");

for (const shape of made) {
    const mesh = { name: shape.name, vertexCoordinates: shape.positions.flat(),
        faceVertexIndices: shape.triangles.flat(),
        faceNormalCoordinates: shape.triangles.flatMap(() => [0, 0, 1]) };
    save(shape, "ascii.stl", exporter.toAsciiStl(mesh, {}));
    save(shape, "binary.stl", exporter.toBinaryStl(mesh, {}));
}
