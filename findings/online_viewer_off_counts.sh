#!/bin/sh
# online_viewer_off_counts.sh - Online 3D Viewer finds no mesh in an OFF as OpenSCAD writes it
#
# Software: npm package online-3d-viewer 0.18.0, its importer of OFF, in Node.js.
# Input: a tetrahedron as OFF, with the counts on a line of their own, and behind the word OFF.
# Behaviour: a line that begins with OFF is left out, with all that stands on it. With the counts
# there ("OFF 4 4 6": white space is all that separates them from the word, OpenSCAD's exporter
# writes them so) the first vertex is read for the counts, 0 vertices and 0 faces, then the
# second, 1 and 0; what comes next is a vertex, the rest is skipped. The message says that the model
# contains no meshes. One would expect a viewer that names OFF to read what the commonest
# free exporter of OFF writes.
# Output seen: "own line: 4 vertices, 4 triangles", "first line: The model doesn't contain any
# meshes."
# Exit status 1 when that changes, 2 when the packages cannot be had. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 2
npm install --silent --no-audit --no-fund --ignore-scripts online-3d-viewer@0.18.0 \
    >/dev/null 2>&1 || { echo "cannot get online-3d-viewer"; exit 2; }
cat >read.mjs <<'END_JS'
import { ImporterOff } from "online-3d-viewer/source/engine/import/importeroff.js";

const solid = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
for (const [name, head] of [["own line", "OFF\n4 4 6\n"], ["first line", "OFF 4 4 6\n"]]) {
    const importer = new ImporterOff();
    const none = () => null;
    importer.Import("a.off", "off", new TextEncoder().encode(head + solid).buffer, {
        getDefaultLineMaterialColor: none,
        getDefaultMaterialColor: () => ({ r: 0, g: 0, b: 0 }),
        getFileBuffer: none,
        onSuccess() {
            let vertices = 0, triangles = 0;
            importer.GetModel().EnumerateMeshes((mesh) => {
                vertices += mesh.VertexCount();
                triangles += mesh.TriangleCount();
            });
            console.log(`${name}: ${vertices} vertices, ${triangles} triangles`);
        },
        onError: () => console.log(`${name}: ${importer.GetErrorMessage()}`),
        onComplete: none,
    });
}
END_JS
seen=$(node read.mjs 2>&1) || { echo "$seen"; exit 2; }
echo "$seen"
[ "$seen" = "own line: 4 vertices, 4 triangles
first line: The model doesn't contain any meshes." ]
