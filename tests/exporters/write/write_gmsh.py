"""write_gmsh - Gmsh: STL, ASCII and binary, of discrete surfaces

SPDX-License-Identifier: MIT
"""
import gmsh

from shapes_made import shapes

gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
for made, stem in shapes():
    gmsh.clear()
    gmsh.model.add(made["name"])
    for number, part in enumerate(made["objects"]):
        tag = gmsh.model.addDiscreteEntity(2)
        first, count = part["positions"]
        nodes = range(first + 1, first + count + 1)
        places = [x for i in nodes for x in made["positions"][i - 1]]
        gmsh.model.mesh.addNodes(2, tag, list(nodes), places)
        first, count = part["triangles"]
        corners = [c + 1 for t in made["triangles"][first: first + count] for c in t]
        gmsh.model.mesh.addElementsByType(tag, 2, [], corners)
    for binary, word in ((0, "ascii"), (1, "binary")):
        gmsh.option.setNumber("Mesh.Binary", binary)
        gmsh.write(f"{stem}.{word}.stl")
