"""write_numpy_stl - numpy-stl: STL, ASCII and binary

SPDX-License-Identifier: MIT
"""
import numpy
import stl

from shapes_made import shapes

for made, stem in shapes():
    mesh = stl.mesh.Mesh(numpy.zeros(len(made["triangles"]), dtype=stl.mesh.Mesh.dtype))
    for number, triangle in enumerate(made["triangles"]):
        mesh.vectors[number] = [made["positions"][corner] for corner in triangle]
    mesh.save(f"{stem}.ascii.stl", mode=stl.Mode.ASCII)
    mesh.save(f"{stem}.binary.stl", mode=stl.Mode.BINARY)
