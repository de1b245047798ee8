#!/bin/sh
# online_viewer_ply_places.sh - normals that come first in a PLY are the mesh to Online 3D Viewer
#
# Software: npm package online-3d-viewer 0.18.0, its importer of PLY, in Node.js.
# Input: a tetrahedron as binary and as ASCII PLY, each vertex with a normal (0, 0, 1), declared
# behind the place and before it. The order of properties is what the header says, by the format.
# Behaviour: names of colours are looked up, names of coordinates are not: the first three
# properties of a vertex are taken for x, y and z, whatever they are called. With normals first all
# four vertices lie at (0, 0, 1). The counts are right, nothing is reported, and nothing is seen.
# Output seen: "binary, place first: 4 triangles, 0 0 0 to 1 1 1", "binary, normal first: 4
# triangles, 0 0 1 to 0 0 1", and the same of ASCII.
# Exit status 1 when that changes, 2 when the packages cannot be had. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 2
npm install --silent --no-audit --no-fund --ignore-scripts online-3d-viewer@0.18.0 \
    >/dev/null 2>&1 || { echo "cannot get online-3d-viewer"; exit 2; }
cat >read.mjs <<'END_JS'
import { ImporterPly } from "online-3d-viewer/source/engine/import/importerply.js";

const places = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
const faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
const normal = [0, 0, 1];

function ply(form, first) {
    const names = first === "place" ? "x y z nx ny nz" : "nx ny nz x y z";
    const lines = names.split(" ").map((name) => `property float ${name}\n`).join("");
    const head = `ply\nformat ${form} 1.0\nelement vertex 4\n${lines}element face 4\n` +
        "property list uchar int vertex_indices\nend_header\n";
    const rows = places.map((p) => (first === "place" ? [...p, ...normal] : [...normal, ...p]));
    if (form === "ascii") {
        const text = [...rows, ...faces.map((f) => [3, ...f])].map((r) => r.join(" "));
        return new TextEncoder().encode(head + text.join("\n") + "\n").buffer;
    }
    const bytes = Buffer.alloc(head.length + 4 * 24 + 4 * 13);
    let at = bytes.write(head, "latin1");
    for (const number of rows.flat()) at = bytes.writeFloatLE(number, at);
    for (const face of faces) {
        at = bytes.writeUInt8(3, at);
        for (const corner of face) at = bytes.writeInt32LE(corner, at);
    }
    return bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
}

for (const form of ["binary_little_endian", "ascii"]) {
    for (const first of ["place", "normal"]) {
        const importer = new ImporterPly();
        const name = `${form.split("_")[0]}, ${first} first`;
        const none = () => null;
        importer.Import("a.ply", "ply", ply(form, first), {
            getDefaultLineMaterialColor: none,
            getDefaultMaterialColor: () => ({ r: 0, g: 0, b: 0 }),
            getFileBuffer: none,
            onSuccess() {
                importer.GetModel().EnumerateMeshes((mesh) => {
                    const ends = ["x", "y", "z"].map((axis) => {
                        const all = [...Array(mesh.VertexCount()).keys()]
                            .map((i) => mesh.GetVertex(i)[axis]);
                        return [Math.min(...all), Math.max(...all)];
                    });
                    console.log(`${name}: ${mesh.TriangleCount()} triangles, ` +
                        `${ends.map((e) => e[0]).join(" ")} to ${ends.map((e) => e[1]).join(" ")}`);
                });
            },
            onError: () => console.log(`${name}: ${importer.GetErrorMessage()}`),
            onComplete: none,
        });
    }
}
END_JS
seen=$(node read.mjs 2>&1) || { echo "$seen"; exit 2; }
echo "$seen"
[ "$seen" = "binary, place first: 4 triangles, 0 0 0 to 1 1 1
binary, normal first: 4 triangles, 0 0 1 to 0 0 1
ascii, place first: 4 triangles, 0 0 0 to 1 1 1
ascii, normal first: 4 triangles, 0 0 1 to 0 0 1" ]
