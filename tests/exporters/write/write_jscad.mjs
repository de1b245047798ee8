// write_jscad - JSCAD's serializers: STL, OBJ; OBJ keeps polygons, STL cuts them
//
// SPDX-License-Identifier: MIT
import { made, objects, require, save } from "./shapes_made.mjs";

const { geometries } = require("@jscad/modeling");
const stl = require("@jscad/stl-serializer"), obj = require("@jscad/obj-serializer");

for (const shape of made) {
    for (const faces of ["polygons", "triangles"]) {
        const solids = objects(shape, faces).map(
            (object) => geometries.geom3.fromPoints(
                object.faces.map((face) => face.map((corner) => object.positions[corner]))));
        const word = faces === "triangles" ? "cut." : "";
        save(shape, `${word}obj`, obj.serialize({}, solids).join(""));
        save(shape, `${word}ascii.stl`, stl.serialize({ binary: false }, solids).join(""));
        save(shape, `${word}binary.stl`, Buffer.concat(
            stl.serialize({ binary: true }, solids).map((part) => Buffer.from(part))));
    }
}
