#!/bin/sh
# gltf_tint_lost.sh - a textured material loses its colour on the way from MTL to glTF, in two tools
#
# Software: npm packages obj2gltf 3.2.0 and gltfpack 1.3.0.
# Input: an OBJ of two triangles whose materials have the same colour, Kd 0.5 0.25 0.125; one of
# them has a texture, too (map_Kd, a white PNG of one pixel).
# Behaviour: by Alias|Wavefront's text on MTL, Kd and map_Kd are multiplied. glTF 2.0 multiplies
# baseColorFactor and baseColorTexture as well, so both could be copied, and obj2gltf's README has
# Kd in its table as the base color, map_Kd as its texture. The plain material's colour is copied;
# for the textured one both tools write the factor 1, or none, which means 1, and what was brown is
# white. One would guess that what two formats define alike comes across unchanged.
# Output seen: "obj2gltf: plain 0.5 0.25 0.125, textured 1 1 1", and the same of gltfpack.
# Exit status 1 when that changes, 2 when the packages cannot be had. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$folder" obj2gltf@3.2.0 \
    gltfpack@1.3.0 >/dev/null 2>&1 || { echo "cannot get obj2gltf, gltfpack"; exit 2; }
cd "$folder" || exit 2
cat >write.mjs <<'END'
import { writeFileSync } from "node:fs";
import { crc32, deflateSync } from "node:zlib";

function chunk(name, data) {
    const body = Buffer.concat([Buffer.from(name), data]);
    const ends = Buffer.alloc(8);
    ends.writeUInt32BE(data.length, 0);
    ends.writeUInt32BE(crc32(body), 4);
    return Buffer.concat([ends.subarray(0, 4), body, ends.subarray(4)]);
}

writeFileSync("white.png", Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]),
    chunk("IHDR", Buffer.from([0, 0, 0, 1, 0, 0, 0, 1, 8, 2, 0, 0, 0])),
    chunk("IDAT", deflateSync(Buffer.from([0, 255, 255, 255]))), chunk("IEND", Buffer.alloc(0))]));
const brown = "Kd 0.5 0.25 0.125";
writeFileSync("in.mtl",
    ["newmtl plain", brown, "newmtl textured", brown, "map_Kd white.png", ""].join("\n"));
writeFileSync("in.obj", ["mtllib in.mtl", "v 0 0 0", "v 1 0 0", "v 0 1 0", "v 1 1 0", "vt 0 0",
    "vt 1 0", "vt 0 1", "usemtl plain", "f 1/1 2/2 3/3", "usemtl textured", "f 2/1 4/2 3/3", ""]
    .join("\n"));
END
cat >tell.mjs <<'END'
import { readFileSync } from "node:fs";

for (const tool of ["obj2gltf", "gltfpack"]) {
    const told = JSON.parse(readFileSync(`${tool}.gltf`, "utf8")).materials.map((material) => {
        const { baseColorFactor = [1, 1, 1, 1], baseColorTexture } = material.pbrMetallicRoughness;
        const kind = baseColorTexture ? "textured" : "plain";
        return `${kind} ${baseColorFactor.slice(0, 3).join(" ")}`;
    });
    console.log(`${tool}: ${told.sort().join(", ")}`);
}
END
node write.mjs || exit 2
node node_modules/obj2gltf/bin/obj2gltf.js -i in.obj -o obj2gltf.gltf >/dev/null || exit 2
node node_modules/gltfpack/cli.js -i in.obj -o gltfpack.gltf -noq >/dev/null || exit 2
seen=$(node tell.mjs) || exit 2
echo "$seen"
[ "$seen" = "obj2gltf: plain 0.5 0.25 0.125, textured 1 1 1
gltfpack: plain 0.5 0.25 0.125, textured 1 1 1" ]
