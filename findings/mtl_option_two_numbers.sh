#!/bin/sh
# mtl_option_two_numbers.sh - a texture scaled by two numbers is lost in three.js and in assimp
#
# Software: npm package three 0.187.0, MTLLoader; Debian's assimp-utils 5.2.5~ds0-1+b1.
# Input: an MTL of two materials, with the lines "map_Kd -s 2 2 1 three.png" and "map_Kd -s 2 2
# two.png", and an OBJ that uses them.
# Behaviour: Alias|Wavefront's text on MTL says of -s, -o and -t that the second and the third
# number are optional, and a texture of an image needs no third. Both readers step over three words
# behind the option all the same, so the file's name is taken for the third number. three.js then
# asks for a texture of an empty name, with the scale in force, and assimp's material has no
# texture. Neither says a word. One would guess that a word which is no number ends the list.
# Output seen: "three.js: three.png scale 2 2", "three.js: no name scale 2 2", "assimp: three.png".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$folder" three@0.187.0 \
    >/dev/null 2>&1 || { echo "cannot get three"; exit 2; }
version=5.2.5~ds0-1+b1
mkdir -p "$folder/archives/partial" "$folder/tree"
apt-get install -y -qq --no-install-recommends --download-only \
    -o "Dir::Cache::archives=$folder/archives" "assimp-utils=$version" >/dev/null 2>&1 ||
    { echo "cannot get assimp-utils $version"; exit 2; }
for package in "$folder"/archives/*.deb; do
    [ ! -e "$package" ] || dpkg-deb -x "$package" "$folder/tree" || exit 2
done
PATH=$folder/tree/usr/bin:$PATH
LD_LIBRARY_PATH=$folder/tree/usr/lib/$(uname -m)-linux-gnu
export PATH LD_LIBRARY_PATH
cd "$folder" || exit 2
printf '%s\n' 'newmtl a' 'map_Kd -s 2 2 1 three.png' 'newmtl b' 'map_Kd -s 2 2 two.png' >in.mtl
printf '%s\n' 'mtllib in.mtl' 'v 0 0 0' 'v 1 0 0' 'v 0 1 0' 'v 1 1 0' 'vt 0 0' 'vt 1 0' 'vt 0 1' \
    'usemtl a' 'f 1/1 2/2 3/3' 'usemtl b' 'f 2/1 4/2 3/3' >in.obj
cat >read.mjs <<'END'
import { readFileSync } from "node:fs";
import { LoadingManager, Texture } from "three";
import { MTLLoader } from "three/examples/jsm/loaders/MTLLoader.js";

const manager = new LoadingManager();
const named = [];
manager.addHandler(/^/, { load: (name) => named.push(name) && new Texture() });
const read = new MTLLoader(manager).parse(readFileSync("in.mtl", "utf8"), "");
read.preload();
Object.values(read.materials).forEach((material, at) => {
    const scale = material.map.repeat.toArray().join(" ");
    console.log(`three.js: ${named[at] || "no name"} scale ${scale}`);
});
END
assimp export in.obj out.obj -fobj >assimp.txt || exit 2
seen=$(node read.mjs 2>&1) || exit 2
seen="$seen
$(sed -n 's/^map_Kd /assimp: /p' out.mtl out.obj.mtl 2>/dev/null)"
echo "$seen"
[ "$seen" = "three.js: three.png scale 2 2
three.js: no name scale 2 2
assimp: three.png" ]
