"""read_meshio - meshio

SPDX-License-Identifier: MIT
"""
import os
import sys

import meshio

for path in sys.argv[1:]:
    mesh = meshio.read(path)
    triangles = sum(len(block.data) for block in mesh.cells if block.type == "triangle")
    print(os.path.basename(path), triangles, len(mesh.points))
