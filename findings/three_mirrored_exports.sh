#!/bin/sh
# three_mirrored_exports.sh - what three.js shows as a solid is inside out as STL, OBJ and PLY
#
# Software: npm packages three 0.187.0, and @babylonjs/core 9.35.0 and @babylonjs/serializers 9.28.0
# as another exporter, in Node.js.
# Input: a box of side 2 whose object is mirrored, scale.x = -1, as symmetric parts are made.
# Behaviour: three.js turns the front of a mesh round where its matrix mirrors, in the renderer and
# for rays: with a one-sided material a ray from outside stops at the near side. The exporters apply
# the matrix to the corners and keep their order, so each triangle shows its back, and the volume by
# corners is -8. The normals in the OBJ and the PLY point out nevertheless, against their own faces;
# those of the STL are computed from the corners and point in. Nothing is said, though USDZExporter
# warns of such a matrix. Babylon.js's two have +8. One would guess that what a program draws as a
# solid leaves it as one, or that normals and corners of one file agree.
# Output seen: "ray: 4", "stl: volume -8, 12 of 12 normals as the corners", "obj: volume -8, 0 of
# 12 ...", "ply: volume -8, 0 of 12 ...", "babylon stl: volume 8, 12 of 12 ..." and "babylon obj".
# Exit status 1 when that changes, 2 when the packages cannot be had. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$folder" three@0.187.0 \
    @babylonjs/core@9.35.0 @babylonjs/serializers@9.28.0 >/dev/null 2>&1 ||
    { echo "cannot get three or @babylonjs"; exit 2; }
cat >"$folder/mirror.mjs" <<'END'
import * as three from "three";
import { OBJExporter } from "three/examples/jsm/exporters/OBJExporter.js";
import { PLYExporter } from "three/examples/jsm/exporters/PLYExporter.js";
import { STLExporter } from "three/examples/jsm/exporters/STLExporter.js";
import { MeshBuilder, NullEngine, Scene } from "@babylonjs/core";
import { OBJExport } from "@babylonjs/serializers/OBJ/objSerializer.js";
import { STLExport } from "@babylonjs/serializers/stl/stlSerializer.js";

const cross = (a, b) => [0, 1, 2].map((axis) => {
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    return a[u] * b[v] - a[v] * b[u];
});
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a, b) => a.map((coordinate, axis) => coordinate - b[axis]);

function tell(name, triangles) { // each: three corners and a normal
    let volume = 0;
    let alike = 0;
    for (const { corners: [a, b, c], normal } of triangles) {
        volume += dot(a, cross(b, c)) / 6;
        alike += dot(cross(minus(b, a), minus(c, a)), normal) > 0;
    }
    console.log(`${name}: volume ${Math.round(volume)}, ` +
        `${alike} of ${triangles.length} normals as the corners`);
}

const lines = (text, word) => text.split("\n").map((line) => line.trim().split(/\s+/))
    .filter(([first]) => first === word).map((words) => words.slice(1));

function stl(text) {
    const corners = lines(text, "vertex").map((words) => words.map(Number));
    return lines(text, "facet").map((words, at) =>
        ({ corners: corners.slice(3 * at, 3 * at + 3), normal: words.slice(1).map(Number) }));
}

function obj(text) {
    const [points, normals] = ["v", "vn"].map((word) =>
        lines(text, word).map((words) => words.map(Number)));
    return lines(text, "f").map((words) => {
        const indices = words.map((word) => word.split("/").map(Number));
        return { corners: indices.map(([v]) => points[v - 1]), normal: normals[indices[0][2] - 1] };
    });
}

function ply(text) { // ASCII: x y z nx ny nz, then faces
    const [header, body] = text.split("end_header\n");
    const rows = body.trim().split("\n").map((line) => line.trim().split(/\s+/).map(Number));
    const vertices = Number(/element vertex (\d+)/.exec(header)[1]);
    return rows.slice(vertices).map(([, ...face]) => ({
        corners: face.map((v) => rows[v].slice(0, 3)), normal: rows[face[0]].slice(3, 6) }));
}

const mesh = new three.Mesh(new three.BoxGeometry(2, 2, 2), new three.MeshBasicMaterial());
mesh.scale.x = -1;
mesh.updateMatrixWorld(true);
const ray = new three.Raycaster(new three.Vector3(0.1, 0.2, 5), new three.Vector3(0, 0, -1));
console.log("ray:", ...ray.intersectObject(mesh).map((hit) => hit.distance));
tell("stl", stl(new STLExporter().parse(mesh)));
tell("obj", obj(new OBJExporter().parse(mesh)));
tell("ply", ply(new PLYExporter().parse(mesh, null, {})));

const scene = new Scene(new NullEngine());
scene.useRightHandedSystem = true;
const box = MeshBuilder.CreateBox("box", { size: 2 }, scene);
box.scaling.x = -1;
box.computeWorldMatrix(true);
tell("babylon stl", stl(STLExport.CreateSTL([box], false, "box", false)));
tell("babylon obj", obj(OBJExport.OBJ([box], false, undefined, true)));
END
seen=$(node "$folder/mirror.mjs" 2>&1 | grep -v '^BJS')
echo "$seen"
[ "$seen" = "ray: 4
stl: volume -8, 12 of 12 normals as the corners
obj: volume -8, 0 of 12 normals as the corners
ply: volume -8, 0 of 12 normals as the corners
babylon stl: volume 8, 12 of 12 normals as the corners
babylon obj: volume 8, 12 of 12 normals as the corners" ]
