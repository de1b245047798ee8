#!/bin/sh
# vtkjs_ply_normals.sh - vtk.js's PLYWriter promises normals that it does not write
#
# Software: npm package @kitware/vtk.js 37.4.3. Input: two triangles, four points, no normals.
# Behaviour: with its settings untouched (withNormals is true) the header lists x y z nx ny nz,
# while an ASCII line of a vertex has three numbers. The binary file is as long as the header
# asks for: the four positions lie in its first half, three floats each, zeros follow. So every
# reader takes points 1 and 3 for normals of points 0 and 2, and the file tells nobody. One would
# guess that an attribute which the mesh has not is left out, as colours and texture coordinates
# are; withNormals: false is needed for a right file.
# Output seen: "ascii: 6 properties, 3 numbers", "binary: 2nd vertex 0 1 0, 4th 0 0 0, not 1 0 0
# and 1 1 0".
# Exit status 1 when that changes, 2 when the package cannot be had. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$folder" \
    @kitware/vtk.js@37.4.3 >/dev/null 2>&1 || { echo "cannot get @kitware/vtk.js"; exit 2; }
cat >"$folder/write.mjs" <<'END'
globalThis.self ??= globalThis;
const part = async (name) =>
    (await import(`./node_modules/@kitware/vtk.js/${name}.js`)).default;
const PolyData = await part("Common/DataModel/PolyData");
const PLYWriter = await part("IO/Geometry/PLYWriter");

const data = PolyData.newInstance();
data.getPoints().setData(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0), 3);
data.getPolys().setData(Uint32Array.of(3, 0, 1, 2, 3, 2, 1, 3));

function written(settings) {
    const writer = PLYWriter.newInstance(settings);
    writer.setInputData(data);
    return writer.getOutputData();
}

const text = written({ format: "ascii" });
const [header, body] = text.split("end_header\n");
const properties = header.match(/property float/g).length;
console.log(`ascii: ${properties} properties, ${body.split("\n")[0].split(" ").length} numbers`);

const view = written({ format: "binary" });
const bytes = Buffer.from(view.buffer, view.byteOffset, view.byteLength);
const start = bytes.indexOf("end_header\n") + "end_header\n".length;
const vertex = (i) => [0, 4, 8].map((k) => bytes.readFloatLE(start + 24 * i + k)).join(" ");
console.log(`binary: 2nd vertex ${vertex(1)}, 4th ${vertex(3)}, not 1 0 0 and 1 1 0`);
END
seen=$(node "$folder/write.mjs")
echo "$seen"
[ "$seen" = "ascii: 6 properties, 3 numbers
binary: 2nd vertex 0 1 0, 4th 0 0 0, not 1 0 0 and 1 1 0" ]
