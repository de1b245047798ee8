"""read_blender - Blender's PLY importer

SPDX-License-Identifier: MIT
"""
import os
import sys

import bpy

for path in sys.argv[sys.argv.index("--") + 1:]:
    bpy.ops.import_mesh.ply(filepath=path)
    mesh = bpy.context.object.data
    print(os.path.basename(path), len(mesh.polygons), len(mesh.vertices))
