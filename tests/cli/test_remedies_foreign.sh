#!/bin/sh
# test_remedies_foreign.sh - the commands that messages about files of other kinds name, help
#
# Each is run as it stands in the message, on a file of that kind. What needs a program that is
# not here is not tried, which is said. SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/remedies.sh
begin remedies_foreign
quad quad.ply
mkdir there

# has PROGRAM...: they are here.
has() {
    for tool in "$@"; do
        command -v "$tool" >/dev/null 2>&1 || { echo "    not tried without $tool"; return 1; }
    done
}
# converted MESSAGE IN OUT: pack refuses the file IN with the message; what that says is done, in
# the folder of IN, and then OUT holds both triangles.
converted() {
    message=$1 in=$2 made=$3
    rm -f there/out*
    says "$message" pack "there/$in" -o x.plt
    remedy=$(sed 's/ (Debian: .*)$//; s/.*: //' err)
    (cd there && sh -c "$remedy") >log 2>&1 </dev/null || said=$(cat log)
    packs 2 "there/$made"
}

# ---- compressed -----------------------------------------------------------------------------

if has gzip; then
    gzip -c quad.ply >there/in
    converted "is compressed; decompress it: gunzip -c in >out" in out
fi
if has xz; then
    xz -c quad.ply >there/in
    converted "is compressed; decompress it: xz -dc in >out" in out
fi
if has bzip2; then
    bzip2 -c quad.ply >there/in
    converted "is compressed; decompress it: bzip2 -dc in >out" in out
fi
if has zstd; then
    zstd -qc quad.ply >there/in
    converted "is compressed; decompress it: zstd -dc in >out" in out
fi
if has zip unzip; then
    cp quad.ply packed.ply
    zip -q there/in.zip packed.ply
    rm packed.ply
    converted "is a zip archive; pack what is in it: unzip in.zip" in.zip packed.ply
fi

# ---- meshes of other formats ------------------------------------------------------------------

if has assimp; then
    printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n' >quad.obj
    for ending in glb gltf dae x3d 3mf; do
        assimp export quad.obj there/in.$ending >log 2>&1 || cat log
    done
    # Assimp 5.2 does not read the binary FBX that it writes; text has the same message.
    assimp export quad.obj there/in.fbx -ffbxa >log 2>&1 || cat log
    converted "is a binary glTF; convert it: assimp export in.glb out.ply (Debian: assimp-utils)" \
        in.glb out.ply
    converted "is glTF; convert it: assimp export in.gltf out.ply (Debian: assimp-utils)" \
        in.gltf out.ply
    converted "is FBX; convert it: assimp export in.fbx out.ply (Debian: assimp-utils)" \
        in.fbx out.ply
    converted "is COLLADA; convert it: assimp export in.dae out.ply (Debian: assimp-utils)" \
        in.dae out.ply
    converted "is X3D; convert it: assimp export in.x3d out.ply (Debian: assimp-utils)" \
        in.x3d out.ply
    converted "is 3MF; convert it: assimp export in.3mf out.ply (Debian: assimp-utils)" \
        in.3mf out.ply
    printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n' >there/in.off
    converted "is OFF; convert it: assimp export in.off out.ply (Debian: assimp-utils)" \
        in.off out.ply
    {
        echo '<?xml version="1.0" encoding="utf-8"?><amf unit="millimeter"><object id="0"><mesh>'
        echo '<vertices>'
        for v in '0 0' '1 0' '1 1' '0 1'; do
            echo "<vertex><coordinates><x>${v% *}</x><y>${v#* }</y><z>0</z></coordinates></vertex>"
        done
        echo '</vertices><volume>'
        for t in '1 2' '2 3'; do
            echo "<triangle><v1>0</v1><v2>${t% *}</v2><v3>${t#* }</v3></triangle>"
        done
        echo '</volume></mesh></object></amf>'
    } >there/in.amf
    converted "is AMF; convert it: assimp export in.amf out.ply (Debian: assimp-utils)" \
        in.amf out.ply
fi
if has gmsh; then
    printf 'SetFactory("OpenCASCADE");\nRectangle(1) = {0, 0, 0, 1, 1};\n' >square.geo
    gmsh -0 square.geo -o there/in.step >log 2>&1 || cat log
    says "is STEP; make triangles of it: gmsh -2 in.step -o out.stl" pack there/in.step -o x.plt
    remedy=$(sed 's/.*: //' err)
    (cd there && sh -c "$remedy") >log 2>&1 </dev/null || said=$(cat log)
    cured pack there/out.stl -o x.plt
fi

# ---- our own ----------------------------------------------------------------------------------

run pack quad.ply -o quad.plt
run pack quad.ply -o quad.h
for remedy in 'info quad.plt' 'render quad.plt -o x.png'; do
    says "is a packed scene already; planelet info and planelet render take it" \
        pack quad.plt -o x.plt
    # shellcheck disable=SC2086
    cured $remedy
done
says "is a packed scene as a C array; pack its meshes again, with -o SCENE.plt" \
    pack quad.h -o x.plt
cured pack quad.ply -o SCENE.plt
finish
