// write_vtkjs - vtk.js: PLYWriter, STLWriter, OBJWriter
//
// SPDX-License-Identifier: MIT
import { loadFile, made, save } from "./shapes_made.mjs";

const part = async (name) => (await loadFile(`@kitware/vtk.js/${name}.js`)).default;
globalThis.self ??= globalThis;
const PolyData = await part("Common/DataModel/PolyData");
const DataArray = await part("Common/Core/DataArray");
const PLYWriter = await part("IO/Geometry/PLYWriter");
const STLWriter = await part("IO/Geometry/STLWriter");
const OBJWriter = await part("IO/Misc/OBJWriter");

function polyData(shape, faces) {
    const data = PolyData.newInstance();
    data.getPoints().setData(Float32Array.from(shape.positions.flat()), 3);
    data.getPolys().setData(Uint32Array.from(shape[faces].flatMap((f) => [f.length, ...f])));
    if (shape.colours) {
        data.getPointData().setScalars(DataArray.newInstance({ name: "colours",
            values: Uint8Array.from(shape.colours.flat()), numberOfComponents: 3 }));
    }
    if (shape.uv) {
        data.getPointData().setTCoords(DataArray.newInstance({ name: "TextureCoordinates",
            values: Float32Array.from(shape.uv.flat()), numberOfComponents: 2 }));
    }
    return data;
}

function write(shape, suffix, writer, data, settings) {
    const made = writer.newInstance(settings);
    made.setInputData(data);
    save(shape, suffix, made.getOutputData());
}

for (const shape of made) {
    const whole = polyData(shape, "polygons"), cut = polyData(shape, "triangles");
    // PLYWriter takes triangles only, and normals stand in its header unless told otherwise.
    for (const [word, settings] of [["", { withNormals: false }], ["as_set.", {}]]) {
        write(shape, `${word}ascii.ply`, PLYWriter, cut, { format: "ascii", ...settings });
        write(shape, `${word}binary.ply`, PLYWriter, cut, { format: "binary", ...settings });
    }
    write(shape, "obj", OBJWriter, whole, {});
    write(shape, "ascii.stl", STLWriter, cut, { format: "ascii" });
    write(shape, "binary.stl", STLWriter, cut, { format: "binary" });
}
