"""read_open3d - Open3D

SPDX-License-Identifier: MIT
"""
import os
import sys

import open3d

for path in sys.argv[1:]:
    mesh = open3d.io.read_triangle_mesh(path)
    print(os.path.basename(path), len(mesh.triangles), len(mesh.vertices))
