#!/bin/sh
# write_meshlab.sh SHAPES OUT - MeshLab (vcglib): PLY, OBJ, STL with colours and normals
#
# It needs a screen with GL: Xvfb and Mesa. SPDX-License-Identifier: MIT
export LIBGL_ALWAYS_SOFTWARE=1
for mesh in "$1"/*.off; do
    stem=$2/$(basename "$mesh" .off)
    for kind in ply obj stl; do
        xvfb-run -a -s '-screen 0 640x480x24 +extension GLX' \
            meshlabserver -i "$mesh" -o "$stem.$kind" -m vc vn >/dev/null 2>&1 || exit 1
    done
done
