"""read_freecad - FreeCAD's Mesh; it merges vertices and leaves out what it cannot use

SPDX-License-Identifier: MIT
"""
import os

import Mesh

for path in os.environ["ARGUMENTS"].splitlines():
    mesh = Mesh.Mesh(path)
    print("\n" + os.path.basename(path), mesh.CountFacets, mesh.CountPoints)
