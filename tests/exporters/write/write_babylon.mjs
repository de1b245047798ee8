// write_babylon - Babylon.js: OBJExport, STLExport
//
// SPDX-License-Identifier: MIT
import { loadFile, made, objects, save } from "./shapes_made.mjs";

const core = (name) => loadFile(`@babylonjs/core/${name}.js`);
const { NullEngine } = await core("Engines/nullEngine");
const { Scene } = await core("scene");
const { Mesh } = await core("Meshes/mesh");
const { VertexData } = await core("Meshes/mesh.vertexData");
await core("Meshes/instancedMesh");
await core("Materials/standardMaterial");
const { OBJExport } = await loadFile("@babylonjs/serializers/OBJ/objSerializer.js");
const { STLExport } = await loadFile("@babylonjs/serializers/stl/stlSerializer.js");

const engine = new NullEngine();
for (const shape of made) {
    const scene = new Scene(engine);
    const meshes = objects(shape, "triangles").map((object, i) => {
        const mesh = new Mesh(`part${i}`, scene), data = new VertexData();
        data.positions = object.positions.flat();
        data.indices = object.faces.flat();
        data.normals = [];
        VertexData.ComputeNormals(data.positions, data.indices, data.normals);
        data.uvs = object.uv ? object.uv.flat() : object.positions.flatMap(() => [0, 0]);
        data.applyToMesh(mesh);
        return mesh;
    });
    save(shape, "obj", OBJExport.OBJ(meshes, false, "stone", true));
    save(shape, "ascii.stl", STLExport.CreateSTL(meshes, false, "part", false, false));
    save(shape, "binary.stl", STLExport.CreateSTL(meshes, false, "part", true));
    save(shape, "big.stl", STLExport.CreateSTL(meshes, false, "part", true, false));
}
engine.dispose();
