"""write_open3d - Open3D: triangles as PLY, OBJ and binary STL

SPDX-License-Identifier: MIT
"""
import numpy
import open3d

from shapes_made import shapes

for made, stem in shapes():
    mesh = open3d.geometry.TriangleMesh(
        open3d.utility.Vector3dVector(numpy.array(made["positions"])),
        open3d.utility.Vector3iVector(numpy.array(made["triangles"])))
    if "colours" in made:
        mesh.vertex_colors = open3d.utility.Vector3dVector(numpy.array(made["colours"]) / 255)
    if "uv" in made:
        corners = [made["uv"][corner] for triangle in made["triangles"] for corner in triangle]
        mesh.triangle_uvs = open3d.utility.Vector2dVector(numpy.array(corners))
        picture = numpy.full((4, 4, 3), 128, dtype=numpy.uint8)
        mesh.textures = [open3d.geometry.Image(picture)]
        mesh.triangle_material_ids = open3d.utility.IntVector([0] * len(made["triangles"]))
    write = open3d.io.write_triangle_mesh
    write(f"{stem}.ascii.ply", mesh, write_ascii=True)
    write(f"{stem}.binary.ply", mesh)
    write(f"{stem}.obj", mesh)
    mesh.compute_vertex_normals()
    write(f"{stem}.binary.stl", mesh)
    write(f"{stem}.normals.ply", mesh)
    write(f"{stem}.normals.obj", mesh)
