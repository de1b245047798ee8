// write_three - three.js: PLYExporter, OBJExporter, STLExporter of a scene
//
// SPDX-License-Identifier: MIT
import { loadFile, made, objects, save } from "./shapes_made.mjs";

globalThis.requestAnimationFrame ??= (then) => setTimeout(then, 0);
const THREE = await loadFile("three/build/three.module.js");
const addon = (name) => loadFile(`three/examples/jsm/exporters/${name}.js`);
const { PLYExporter } = await addon("PLYExporter");
const { OBJExporter } = await addon("OBJExporter");
const { STLExporter } = await addon("STLExporter");

function meshOf(object) {
    const geometry = new THREE.BufferGeometry();
    const attribute = (name, list, size) => geometry.setAttribute(name,
        new THREE.Float32BufferAttribute(list.flat(), size));
    attribute("position", object.positions, 3);
    geometry.setIndex(object.faces.flat());
    if (object.colours) {
        attribute("color", object.colours.map((c) => c.map((x) => x / 255)), 3);
    }
    if (object.uv) {
        attribute("uv", object.uv, 2);
    }
    return new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ name: "stone" }));
}

function write(shape, group, word) {
    const ply = new PLYExporter();
    save(shape, `${word}ascii.ply`, ply.parse(group, () => {}, {}));
    save(shape, `${word}big.ply`, ply.parse(group, () => {}, { binary: true }));
    save(shape, `${word}little.ply`,
        ply.parse(group, () => {}, { binary: true, littleEndian: true }));
    save(shape, `${word}obj`, new OBJExporter().parse(group));
    save(shape, `${word}ascii.stl`, new STLExporter().parse(group));
    save(shape, `${word}binary.stl`, new STLExporter().parse(group, { binary: true }));
}

for (const shape of made) {
    const group = new THREE.Group();
    objects(shape, "triangles").forEach((object) => group.add(meshOf(object)));
    group.updateMatrixWorld(true);
    write(shape, group, "");
    // A helper of points or lines in the same scene.
    group.add(new THREE.Points(meshOf(objects(shape, "triangles")[0]).geometry));
    write(shape, group, "points.");
    const loose = new THREE.Group();
    loose.add(new THREE.Mesh(group.children[0].geometry.toNonIndexed()));
    write(shape, loose, "loose.");
}
