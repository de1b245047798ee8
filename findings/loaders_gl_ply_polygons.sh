#!/bin/sh
# loaders_gl_ply_polygons.sh - loaders.gl leaves polygons of five corners out of a PLY, unsaid
#
# Software: npm packages @loaders.gl/ply 4.4.5 and @loaders.gl/core 4.4.5.
# Input: an ASCII PLY of a house's front: a triangle, a quad and a pentagon, and one that is the
# pentagon alone. PLY's lists may have any length.
# Behaviour: triangles and quads come as triangles, a face of more corners is left out, without an
# error or a warning; a file of such faces only comes as a point cloud (topology "point-list"). The
# quad 0 1 2 3 is cut from corner 1 to 3, where a fan cuts from 0 to 2: for a quad that is not flat
# this is another surface than most readers make of it. One would guess that each face is cut into
# triangles, or that a reader refuses what it cannot cut.
# Output seen: "house: triangle-list 0 1 2 0 1 3 1 2 3", "pentagon: point-list", "0 warnings".
# Exit status 1 when that changes, 2 when a package cannot be had. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$folder" \
    @loaders.gl/ply@4.4.5 @loaders.gl/core@4.4.5 >/dev/null 2>&1 ||
    { echo "cannot get @loaders.gl/ply, @loaders.gl/core"; exit 2; }
cat >"$folder/read.mjs" <<'END'
import { parse } from "@loaders.gl/core";
import { PLYLoader } from "@loaders.gl/ply";

let warnings = 0;
console.warn = console.error = () => warnings++;

async function tell(name, ...faces) {
    const lines = ["ply", "format ascii 1.0", "element vertex 5", "property float x",
        "property float y", "property float z", `element face ${faces.length}`,
        "property list uchar int vertex_indices", "end_header",
        "0 0 0", "1 0 0", "1 1 0", "0 1 0", "0.5 2 0", ...faces, ""];
    const bytes = new TextEncoder().encode(lines.join("\n")).buffer;
    const mesh = await parse(bytes, PLYLoader, { core: { worker: false } });
    console.log([`${name}:`, mesh.topology, ...(mesh.indices?.value ?? [])].join(" "));
}

await tell("house", "3 0 1 2", "4 0 1 2 3", "5 0 1 2 4 3");
await tell("pentagon", "5 0 1 2 4 3");
console.log(`${warnings} warnings`);
END
seen=$(node "$folder/read.mjs")
echo "$seen"
[ "$seen" = "house: triangle-list 0 1 2 0 1 3 1 2 3
pentagon: point-list
0 warnings" ]
