// write_itkwasm - ITK as WebAssembly: OBJ of polygons, STL of triangles
//
// SPDX-License-Identifier: MIT
import path from "node:path";
import { loadFile, made } from "./shapes_made.mjs";

const { FloatTypes, IntTypes, Mesh, MeshType } =
    await loadFile("itk-wasm/dist/index-node.js");
const { writeMeshNode } = await loadFile("@itk-wasm/mesh-io/dist/index-node.js");
const TRIANGLE = 2, QUAD = 3, POLYGON = 4;

function meshOf(shape, faces) {
    const type = new MeshType(3, FloatTypes.Float32);
    type.pointPixelComponentType = FloatTypes.Float32;
    type.cellPixelComponentType = FloatTypes.Float32;
    type.cellComponentType = IntTypes.UInt32;
    const kind = (face) => ({ 3: TRIANGLE, 4: QUAD })[face.length] ?? POLYGON;
    const mesh = new Mesh(type);
    mesh.points = Float32Array.from(shape.positions.flat());
    mesh.numberOfPoints = shape.positions.length;
    mesh.cells = Uint32Array.from(faces.flatMap((face) => [kind(face), face.length, ...face]));
    mesh.numberOfCells = faces.length;
    mesh.cellBufferSize = mesh.cells.length;
    return mesh;
}

for (const shape of made) {
    const stem = path.join(process.argv[3], shape.name);
    const whole = meshOf(shape, shape.polygons), cut = meshOf(shape, shape.triangles);
    await writeMeshNode(whole, `${stem}.obj`);
    await writeMeshNode(cut, `${stem}.cut.obj`);
    await writeMeshNode(cut, `${stem}.ascii.stl`, { binaryFileType: false });
    await writeMeshNode(cut, `${stem}.binary.stl`, { binaryFileType: true });
}
