#!/bin/sh
# osg_obj_opacity.sh - osgconv reads Tr upside down and writes opacity where no one looks for it
#
# Software: Debian's openscenegraph 3.6.5+dfsg1-8+b2 (OpenSceneGraph 3.6.5), osgconv, and
# assimp-utils 5.2.5~ds0-1+b1 as another reader.
# Input: an OBJ with two materials of the same opacity, 0.75: one by "d 0.75", one by "Tr 0.25".
# Behaviour: OpenSceneGraph takes the number behind Tr for the opacity itself, so the second is
# three quarters clear; assimp, three.js and tinyobjloader have 1 - Tr, which those mean who write
# it. Writing OBJ, OpenSceneGraph puts the opacity behind each colour as a fourth number, which only
# its own reader knows: the text on MTL has three for Ka, Kd and Ks, and the line d for this. It
# writes no d, so all else is told that both are opaque. One would guess d, in both directions.
# Output seen: "straight: d 0.75 d 0.75", "written: Kd 0.25 0.5 1 0.25, Kd 1 0.5 0.25 0.75", "read
# again: d 1 d 1".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/archives/partial" "$folder/tree" "$folder/out" "$folder/again"
for package in openscenegraph=3.6.5+dfsg1-8+b2 assimp-utils=5.2.5~ds0-1+b1; do
    apt-get install -y -qq --no-install-recommends --download-only \
        -o "Dir::Cache::archives=$folder/archives" "$package" >/dev/null 2>&1 ||
        { echo "cannot get $package"; exit 2; }
done
for package in "$folder"/archives/*.deb; do
    [ ! -e "$package" ] || dpkg-deb -x "$package" "$folder/tree" || exit 2
done
PATH=$folder/tree/usr/bin:$PATH
LD_LIBRARY_PATH=$folder/tree/usr/lib/$(uname -m)-linux-gnu
export PATH LD_LIBRARY_PATH
cd "$folder" || exit 2
printf '%s\n' 'newmtl a' 'Kd 1 0.5 0.25' 'd 0.75' 'newmtl b' 'Kd 0.25 0.5 1' 'Tr 0.25' >in.mtl
printf '%s\n' 'mtllib in.mtl' 'v 0 0 0' 'v 1 0 0' 'v 0 1 0' 'v 1 1 0' 'usemtl a' 'f 1 2 3' \
    'usemtl b' 'f 2 4 3' >in.obj
# opacities FILE.obj - what assimp makes of the two materials' opacity
opacities() {
    rm -rf again/*
    assimp export "$1" again/out.obj -fobj >/dev/null || exit 2
    sed -n '/^newmtl DefaultMaterial/,/^$/d; /^d /p' again/*mtl | paste -s -d' ' -
}
osgconv in.obj out/out.obj >/dev/null 2>&1 || exit 2
straight=$(opacities in.obj) || exit 2
again=$(opacities out/out.obj) || exit 2
seen="straight: $straight
written: $(sed -n 's/^ *Kd /Kd /p' out/out.mtl | sort | paste -s -d, - | sed 's/,/, /')
read again: $again"
echo "$seen"
[ "$seen" = "straight: d 0.75 d 0.75
written: Kd 0.25 0.5 1 0.25, Kd 1 0.5 0.25 0.75
read again: d 1 d 1" ]
