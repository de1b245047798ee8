"""counts - triangles and vertices of each mesh, and the mesh as binary STL beside it

counts.py PLANELET FILE.ply... prints "NAME TRIANGLES VERTICES"; exit status 1 where planelet
packs another number of triangles.

SPDX-License-Identifier: MIT
"""
import os
import struct
import sys

import image
import parser
from compare import packed


def write_stl(mesh, path):
    with open(path, "wb") as file:
        file.write(b" " * 80 + struct.pack("<I", len(mesh.polygons)))
        for corners in mesh.polygons:
            words = [word for corner in corners for word in mesh.positions[corner]]
            file.write(struct.pack("<12x9I2x", *words))


def main(planelet, *paths):
    result = 0
    for path in paths:
        mesh = parser.read(path)
        write_stl(mesh, path.replace(".ply", ".stl"))
        status, made, said = packed(planelet, path)
        if status != 0 or len(image.triangles(made)) != len(mesh.polygons):
            print(f"FAIL planelet: {path}: {said}", file=sys.stderr)
            result = 1
        print(os.path.basename(path), len(mesh.polygons), len(mesh.positions))
    return result


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
