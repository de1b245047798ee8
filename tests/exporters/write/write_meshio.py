"""write_meshio - meshio: PLY with polygons of one size per block, STL, OBJ

SPDX-License-Identifier: MIT
"""
import warnings

import meshio
import numpy

from shapes_made import shapes

KINDS = {3: "triangle", 4: "quad"}


def mesh_of(made, faces, more=()):
    blocks, more = [], list(more)
    for face in faces:
        kind = KINDS.get(len(face), "polygon")
        if not blocks or blocks[-1][0] != kind or len(blocks[-1][1][0]) != len(face):
            blocks.append((kind, []))
        blocks[-1][1].append(face)
    extra = {}
    if "colours" in made:
        colours = numpy.array(made["colours"], dtype=numpy.uint8)
        extra = {name: colours[:, i] for i, name in enumerate(("red", "green", "blue"))}
    return meshio.Mesh(numpy.array(made["positions"]), more + blocks, point_data=extra)


warnings.simplefilter("ignore")
for made, stem in shapes():
    whole = mesh_of(made, made["polygons"])
    cut = mesh_of(made, made["triangles"])
    # What Gmsh leaves in a mesh: nodes and lines of the boundary as cells.
    lines = mesh_of(made, made["triangles"],
                    [("vertex", [[0]]), ("line", [face[:2] for face in made["polygons"]])])
    for binary, word in ((False, "ascii"), (True, "binary")):
        whole.write(f"{stem}.{word}.ply", file_format="ply", binary=binary)
        cut.write(f"{stem}.cut.{word}.ply", file_format="ply", binary=binary)
        lines.write(f"{stem}.lines.{word}.ply", file_format="ply", binary=binary)
        cut.write(f"{stem}.{word}.stl", file_format="stl", binary=binary)
    cut.write(f"{stem}.obj", file_format="obj")
