"""write_blender - Blender: both PLY and both OBJ exporters that it has, STL

Run by blender -b --factory-startup -P write_blender.py -- SHAPES OUT.

SPDX-License-Identifier: MIT
"""
import os
import sys

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.argv = sys.argv[sys.argv.index("--"):]
from shapes_made import shapes


def add(made, part):
    first, count = part["positions"]
    begin, faces = part["polygons"]
    mesh = bpy.data.meshes.new(made["name"])
    mesh.from_pydata(made["positions"][first: first + count], [],
                     [[c - first for c in f] for f in made["polygons"][begin: begin + faces]])
    corners = [c for polygon in mesh.polygons for c in polygon.vertices]
    if "colours" in made:
        layer = mesh.vertex_colors.new()
        for i, corner in enumerate(corners):
            layer.data[i].color = [c / 255 for c in made["colours"][corner]] + [1.0]
    if "uv" in made:
        layer = mesh.uv_layers.new()
        for i, corner in enumerate(corners):
            layer.data[i].uv = made["uv"][corner]
        mesh.materials.append(bpy.data.materials.new("stone"))
    bpy.context.collection.objects.link(bpy.data.objects.new(made["name"], mesh))


for made, stem in shapes():
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    for part in made["objects"]:
        add(made, part)
    for word, is_ascii in (("ascii", True), ("binary", False)):
        bpy.ops.export_mesh.ply(filepath=f"{stem}.{word}.ply", use_ascii=is_ascii)
        bpy.ops.export_mesh.stl(filepath=f"{stem}.{word}.stl", ascii=is_ascii)
    bpy.ops.wm.obj_export(filepath=f"{stem}.obj")
    bpy.ops.export_scene.obj(filepath=f"{stem}.old.obj")
    bpy.ops.export_scene.obj(filepath=f"{stem}.groups.obj", use_triangles=True, use_edges=True,
                             group_by_object=True, use_vertex_groups=True)
