#!/bin/sh
# irrlicht_mesh_axes.sh - one mesh lies elsewhere in Irrlicht as PLY than as OBJ or STL
#
# Software: Debian's libirrlicht-dev 1.8.5+ds2-1 (Irrlicht 1.8.5), its null device.
# Input: the triangle (1 2 3) (4 2 3) (1 6 3) as OBJ, ASCII STL and ASCII PLY.
# Behaviour: Irrlicht's space is left-handed, so its readers mirror what they read and turn the
# corners round. Those of OBJ and STL mirror by changing the sign of x, the one of PLY by exchange
# of y and z. None of the formats names an axis, and no setting is asked for, yet one mesh comes at
# two places, upright in one and lying in the other. One would guess one rule for every format.
# Output seen: "obj (-1 6 3) (-4 2 3) (-1 2 3)", the same for stl, "ply (1 3 2) (1 3 6) (4 3 2)".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
version=1.8.5+ds2-1
mkdir -p "$folder/archives/partial" "$folder/tree"
apt-get install -y -qq --no-install-recommends --download-only \
    -o "Dir::Cache::archives=$folder/archives" "libirrlicht-dev=$version" g++ >/dev/null 2>&1 ||
    { echo "cannot get libirrlicht-dev $version"; exit 2; }
for package in "$folder"/archives/*.deb; do
    [ ! -e "$package" ] || dpkg-deb -x "$package" "$folder/tree" || exit 2
done
PATH=$PATH:$folder/tree/usr/bin
LD_LIBRARY_PATH=$folder/tree/usr/lib/$(uname -m)-linux-gnu
export PATH LD_LIBRARY_PATH
cd "$folder" || exit 2
printf 'v %s\n' '1 2 3' '4 2 3' '1 6 3' >in.obj
echo 'f 1 2 3' >>in.obj
printf '%s\n' 'solid a' 'facet normal 0 0 1' 'outer loop' 'vertex 1 2 3' 'vertex 4 2 3' \
    'vertex 1 6 3' endloop endfacet 'endsolid a' >in.stl
printf '%s\n' ply 'format ascii 1.0' 'element vertex 3' 'property float x' 'property float y' \
    'property float z' 'element face 1' 'property list uchar int vertex_indices' end_header \
    '1 2 3' '4 2 3' '1 6 3' '3 0 1 2' >in.ply
cat >read.cpp <<'END'
#include <irrlicht/irrlicht.h>
#include <cstdio>

int main(int count, char **names) {
    irr::IrrlichtDevice *device = irr::createDevice(irr::video::EDT_NULL);
    for (int i = 1; i < count; i++) {
        irr::scene::IAnimatedMesh *mesh = device->getSceneManager()->getMesh(names[i]);
        if (!mesh) { return 2; }
        irr::scene::IMeshBuffer *part = mesh->getMesh(0)->getMeshBuffer(0);
        printf("seen %s", names[i] + 3);
        for (unsigned k = 0; k < part->getIndexCount(); k++) {
            const irr::core::vector3df &at = part->getPosition(part->getIndices()[k]);
            printf(" (%g %g %g)", at.X, at.Y, at.Z);
        }
        printf("\n");
    }
    device->drop();
}
END
g++ -I tree/usr/include read.cpp "-L$LD_LIBRARY_PATH" -lIrrlicht -Wl,--allow-shlib-undefined \
    -o read || exit 2
seen=$(./read in.obj in.stl in.ply | sed -n 's/^seen //p')
echo "$seen"
[ "$seen" = "obj (-1 6 3) (-4 2 3) (-1 2 3)
stl (-1 6 3) (-4 2 3) (-1 2 3)
ply (1 3 2) (1 3 6) (4 3 2)" ]
