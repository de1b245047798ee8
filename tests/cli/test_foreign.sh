#!/bin/sh
# test_foreign.sh - files that pack does not read, and what it says to do with them
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin foreign
quad quad.ply
run pack quad.ply -o quad.plt

# foreign NAME SAYS: pack refuses the file with these words.
foreign() {
    refused "pack: $1" "$1" "$2" pack "$1" -o x.plt
}
foreign quad.plt "is a packed scene already; .*planelet info .*planelet render"
cp quad.plt plt.obj
foreign plt.obj "is a packed scene already"
"$PLANELET" pack - -o x.plt <quad.plt 2>err
status=$?
verdict "pack: a scene on standard input" "$(refusal "standard input" "is a packed scene already")"
echo "quad.plt 1 0 0 0" >scene.txt
refused "pack: a scene in a recipe" scene.txt "line 1: quad.plt: is a packed scene already" \
    pack scene.txt -o x.plt

# What begins like each format; an ending decides nothing.
bytes cube.glb 'glTF\002\000\000\000\050\000\000\000'
foreign cube.glb "glTF; .*assimp export in.glb out.ply"
cp cube.glb glb.stl
foreign glb.stl "glTF; .*assimp export in.glb out.ply"
echo '  { "scenes": [], "asset": { "version": "2.0" } }' >cube.gltf
foreign cube.gltf "glTF; .*assimp export in.gltf out.ply"
bytes cube.fbx 'Kaydara FBX Binary  \000\032\000\350\034\000\000'
foreign cube.fbx "FBX; .*assimp export in.fbx out.ply"
printf '; FBX 7.5.0 project file\n' >ascii.fbx
foreign ascii.fbx "FBX; .*assimp export in.fbx out.ply"
bytes cube.3mf 'PK\003\004\024\000\000\000[Content_Types].xmlPK\001\0023D/3dmodel.modelPK\005\006'
foreign cube.3mf "3MF; .*assimp export in.3mf out.ply"
sed s/3dmodel/3DModel/ cube.3mf >assimp.3mf
foreign assimp.3mf "3MF; .*assimp export in.3mf out.ply"
bytes cube.zip 'PK\003\004\024\000\000\000cube.objPK\001\002cube.objPK\005\006'
foreign cube.zip "zip archive; .*unzip"
printf 'ISO-10303-21;\nHEADER;\n' >cube.step
foreign cube.step "STEP; .*gmsh -2 in.step -o out.stl"
for word in OFF COFF NOFF CNOFF STOFF; do
    printf '\n %s\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' $word >$word.off
    foreign $word.off "OFF; .*assimp export in.off out.ply"
done
for pair in COLLADA:dae X3D:x3d amf:amf; do
    printf '<?xml version="1.0"?>\n<!-- -->\n<%s version="1">\n' "${pair%:*}" >"cube.${pair#*:}"
    foreign "cube.${pair#*:}" "is [A-Z3]*; .*assimp export in.${pair#*:} out.ply"
done
printf 'BLENDER-v279RENDH' >cube.blend
foreign cube.blend "Blender .*export it"
bytes cube.xz '\375\067zXZ\000\000\004'
foreign cube.xz "compressed; .*xz -dc in >out"
bytes cube.bz2 'BZh91AY&SY'
foreign cube.bz2 "compressed; .*bzip2 -dc in >out"
bytes cube.zst '\050\265\057\375\004\000'
foreign cube.zst "compressed; .*zstd -dc in >out"

if needs gzip; then
    gzip -c quad.ply >quad.ply.gz
    foreign quad.ply.gz "compressed; .*gunzip -c in >out"
    remedy=$(sed -n 's/.*: \(gunzip .*\)/\1/p' err)
    cp quad.ply.gz in
    sh -c "$remedy"
    same out quad.ply "... and that gives the mesh back"
fi

# What only looks like one.
printf 'OFFICE\n' >office
foreign office "is neither PLY nor OBJ nor STL"
printf '{ "vertices": [] }' >json
foreign json "is neither PLY nor OBJ nor STL"
printf '<html>' >html
foreign html "is neither PLY nor OBJ nor STL"
bytes short '\037'
foreign short "is neither PLY nor OBJ nor STL"
bytes header.stl "PK\\003\\004$(awk 'BEGIN { while (i++ < 76) printf "x" }')\\001\\000\\000\\000"
head -c 50 /dev/zero >>header.stl
run pack header.stl -o x.plt
verdict "an STL whose 80 bytes of text begin like a zip archive is an STL" "$(
    [ "$status" -eq 0 ] || cat err)"
verdict "nothing half-written is left" "$(left_behind)"
finish
