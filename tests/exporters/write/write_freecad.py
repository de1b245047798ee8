"""write_freecad - FreeCAD's Mesh: PLY, OBJ, STL

Every argument of freecadcmd is a document to open: they come in the environment instead.

SPDX-License-Identifier: MIT
"""
import os
import sys

import Mesh

sys.path.insert(0, os.environ["FOLDER"])
sys.argv = ["", *os.environ["ARGUMENTS"].splitlines()]
from shapes_made import shapes

for made, stem in shapes():
    mesh = Mesh.Mesh([[made["positions"][c] for c in t] for t in made["triangles"]])
    for suffix, kind in (("ply", "PLY"), ("ascii.ply", "APLY"), ("obj", "OBJ"),
                         ("binary.stl", "STL"), ("ascii.stl", "AST")):
        mesh.write(Filename=f"{stem}.{suffix}", Format=kind)
