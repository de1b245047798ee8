#!/bin/sh
# bullet_triangle_border.sh - Bullet's triangles are larger for rays than they are, on some sides
#
# Software: Debian's libbullet-dev 3.24+dfsg-2 (Bullet 3.24, btScalar is float).
# Input: a mesh of one triangle in y = 0 with legs of 10000 along x and z, and rays along y that
# pass each side at a distance, and one that ends on the triangle.
# Behaviour: each side may be missed by 1e-4 of the triangle's size: a ray that passes the
# hypotenuse 0.9 (along x) outside is a hit, at 1.1 it is a miss. At the legs, which are parallel
# to axes, the node's box, which has no such border, cuts first: 0.01 outside is a miss. So how far
# a mesh reaches depends on how it lies, and grows with its triangles. A ray whose last point is on
# the surface does not hit it, nor does one whose first is. One would guess a border of some units
# of rounding at most, the same all round, and a closed segment.
# Output seen: "hypotenuse: 0.9 hit, 1.1 none", "leg: 0.01 none", "ends on it: none, starts on it:
# none, passes: hit".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
version=3.24+dfsg-2
mkdir -p "$folder/archives/partial" "$folder/tree"
apt-get install -y -qq --no-install-recommends --download-only \
    -o "Dir::Cache::archives=$folder/archives" "libbullet-dev=$version" g++ >/dev/null 2>&1 ||
    { echo "cannot get libbullet-dev $version"; exit 2; }
for package in "$folder"/archives/*.deb; do
    [ ! -e "$package" ] || dpkg-deb -x "$package" "$folder/tree" || exit 2
done
PATH=$PATH:$folder/tree/usr/bin
LD_LIBRARY_PATH=$folder/tree/usr/lib/$(uname -m)-linux-gnu
export PATH LD_LIBRARY_PATH
cat >"$folder/cast.cpp" <<'END'
#include <btBulletCollisionCommon.h>
#include <cstdio>

static btCollisionWorld *world;

static const char *cast(float x, float z, float start, float end) {
    const btVector3 from(x, start, z);
    const btVector3 to(x, end, z);
    btCollisionWorld::ClosestRayResultCallback hit(from, to);
    world->rayTest(from, to, hit);
    return hit.hasHit() ? "hit" : "none";
}

int main() {
    const float side = 10000;
    btTriangleMesh mesh;
    mesh.addTriangle(btVector3(0, 0, 0), btVector3(0, 0, side), btVector3(side, 0, 0));
    btBvhTriangleMeshShape shape(&mesh, true);
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    world = new btCollisionWorld(&dispatcher, &broadphase, &configuration);
    btCollisionObject object;
    object.setCollisionShape(&shape);
    world->addCollisionObject(&object);
    printf("hypotenuse: 0.9 %s, 1.1 %s\n", cast(5000.9f, 5000, 1, -1), cast(5001.1f, 5000, 1, -1));
    printf("leg: 0.01 %s\n", cast(-0.01f, 3000, 1, -1));
    printf("ends on it: %s, starts on it: %s, passes: %s\n", cast(2000, 2000, 1, 0),
        cast(2000, 2000, 0, -1), cast(2000, 2000, 1, -1));
    world->removeCollisionObject(&object);
    delete world;
}
END
g++ -I "$folder/tree/usr/include/bullet" -I /usr/include/bullet "$folder/cast.cpp" \
    "-L$LD_LIBRARY_PATH" -lBulletCollision -lLinearMath -o "$folder/cast" || exit 2
seen=$("$folder/cast")
echo "$seen"
[ "$seen" = "hypotenuse: 0.9 hit, 1.1 none
leg: 0.01 none
ends on it: none, starts on it: none, passes: hit" ]
