"""read_numpy_stl - numpy-stl, of the same mesh as STL

SPDX-License-Identifier: MIT
"""
import os
import sys

import stl

for path in sys.argv[1:]:
    mesh = stl.mesh.Mesh.from_file(path.replace(".ply", ".stl"), calculate_normals=False)
    print(os.path.basename(path), len(mesh.vectors), "-")
