"""shapes - the seven meshes that every exporter writes

shapes.py FOLDER writes NAME.json (positions, polygons, triangles, colours, texture coordinates,
objects) for the exporters that are libraries, and NAME.obj, cut/NAME.obj (triangles), NAME.off
and NAME.stl for those that are programs and convert. Few coordinates are short in decimal or in
binary.

SPDX-License-Identifier: MIT
"""
import json
import math
import os
import sys


def cube():
    x, y, z = (-1 / 3, 0.7), (0.1, 1.2345678), (-2.0, math.pi)
    positions = [(x[i & 1], y[i >> 1 & 1], z[i >> 2]) for i in range(8)]
    return positions, [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4],
                       [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]


def torus(around=12, across=8):
    positions = []
    for i in range(around):
        for k in range(across):
            a, b = 2 * math.pi * i / around, 2 * math.pi * k / across
            out = 2 + 0.7 * math.cos(b)
            positions.append((out * math.cos(a), out * math.sin(a), 0.7 * math.sin(b)))
    corner = lambda i, k: i % around * across + k % across
    return positions, [[corner(i, k), corner(i + 1, k), corner(i + 1, k + 1), corner(i, k + 1)]
                       for i in range(around) for k in range(across)]


def prism(outline, height):
    n = len(outline)
    positions = [(x, y, z) for z in (0.0, height) for x, y in outline]
    polygons = [list(range(n - 2, -1, -1)) + [n - 1], list(range(n, 2 * n))]
    polygons += [[i, (i + 1) % n, n + (i + 1) % n, n + i] for i in range(n)]
    return positions, polygons


def star(tips=5):
    """A cap begins at a tip; a fan from there leaves the star."""
    n = 2 * tips
    return [(out * math.cos(2 * math.pi * i / n), out * math.sin(2 * math.pi * i / n))
            for i, out in enumerate([1.1, 0.4] * tips)]


# One corner lies in the middle of a side.
ELL = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)]


def tetrahedron(at=0.0):
    positions = [(at, 0.1, 0.2), (at + 1.1, 0.1, 0.2), (at, 1.3, 0.2), (at, 0.1, 1.7)]
    return positions, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]


def octahedron(at):
    positions = [(at + 0.9 * x, 0.9 * y, 0.9 * z) for x, y, z in
                 [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]]
    return positions, [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4],
                       [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]


def convex_at(positions, polygon, k):
    """Whether corner k of a cap can be cut off: no other corner lies in its triangle."""
    a, b, c = (positions[polygon[(k + d) % len(polygon)]] for d in (-1, 0, 1))
    turn = lambda p, q, r: (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    sign = sum(turn(positions[polygon[0]], positions[polygon[i]], positions[polygon[i + 1]])
               for i in range(1, len(polygon) - 1))
    if turn(a, b, c) * sign <= 0:
        return False
    return not any(all(turn(p, q, positions[corner]) * sign >= 0
                       for p, q in ((a, b), (b, c), (c, a)))
                   for corner in polygon if positions[corner] not in (a, b, c))


def triangulated(positions, polygons):
    """Quads along a diagonal, as all of them are convex; caps corner by corner."""
    triangles = []
    for polygon in polygons:
        rest = list(polygon)
        while len(rest) > 3:
            k = 1 if len(polygon) == 4 else next(
                k for k in range(len(rest)) if convex_at(positions, rest, k))
            triangles.append([rest[k - 1], rest[k], rest[(k + 1) % len(rest)]])
            del rest[k]
        triangles.append(rest)
    return triangles


def shape(name, *objects, colours=False, texture=None):
    positions, polygons, parts = [], [], []
    for own, faces in objects:
        parts.append({"polygons": [len(polygons), len(faces)],
                      "positions": [len(positions), len(own)]})
        polygons += [[corner + len(positions) for corner in face] for face in faces]
        positions += own
    for part in parts:
        first, count = part["polygons"]
        begin = len(triangulated(positions, polygons[:first]))
        end = len(triangulated(positions, polygons[: first + count]))
        part["triangles"] = [begin, end - begin]
    made = {"name": name, "positions": positions, "polygons": polygons,
            "triangles": triangulated(positions, polygons), "objects": parts}
    if colours:
        made["colours"] = [[(37 * i + 11) % 256, (91 * i + 5) % 256, (53 * i + 200) % 256]
                           for i in range(len(positions))]
    if texture:
        made["texture"] = texture
        made["uv"] = [[round(0.1 + 0.07 * i % 1, 4), round(0.9 - 0.05 * i % 1, 4)]
                      for i in range(len(positions))]
    return made


SHAPES = [
    shape("cube", cube()),
    shape("torus", torus()),
    shape("prism", prism(star(), 0.3)),
    shape("ell", prism(ELL, 0.3)),
    shape("coloured", torus(7, 5), colours=True),
    shape("textured", torus(6, 5), texture="stone.png"),
    shape("two", tetrahedron(), octahedron(4.0)),
]


def write_obj(made, stem, faces):
    lines = []
    if "texture" in made:
        lines.append(f"mtllib {os.path.basename(stem)}.mtl")
        with open(stem + ".mtl", "w") as file:
            file.write(f"newmtl stone\nKd 1 1 1\nmap_Kd {made['texture']}\n")
    for i, position in enumerate(made["positions"]):
        colour = [c / 255 for c in made["colours"][i]] if "colours" in made else []
        lines.append("v " + " ".join(repr(x) for x in [*position, *colour]))
    lines += ["vt %r %r" % tuple(uv) for uv in made.get("uv", [])]
    if "uv" in made:
        lines.append("usemtl stone")
    for number, part in enumerate(made["objects"]):
        lines.append(f"o part{number}")
        first, count = part[faces]
        for polygon in made[faces][first: first + count]:
            pattern = "%d/%d" if "uv" in made else "%d"
            lines.append("f " + " ".join(
                pattern % ((corner + 1,) * pattern.count("%")) for corner in polygon))
    with open(stem + ".obj", "w") as file:
        file.write("\n".join(lines) + "\n")


def write_off(made, stem):
    with open(stem + ".off", "w") as file:
        file.write(f"OFF\n{len(made['positions'])} {len(made['polygons'])} 0\n")
        for position in made["positions"]:
            file.write("%r %r %r\n" % tuple(position))
        for polygon in made["polygons"]:
            file.write(f"{len(polygon)} {' '.join(map(str, polygon))}\n")


def write_stl(made, stem):
    with open(stem + ".stl", "w") as file:
        file.write("solid shape\n")
        for triangle in made["triangles"]:
            file.write(" facet normal 0 0 0\n  outer loop\n")
            for corner in triangle:
                file.write("   vertex %r %r %r\n" % tuple(made["positions"][corner]))
            file.write("  endloop\n endfacet\n")
        file.write("endsolid shape\n")


def main(folder):
    os.makedirs(os.path.join(folder, "cut"), exist_ok=True)
    for made in SHAPES:
        stem = os.path.join(folder, made["name"])
        with open(stem + ".json", "w") as file:
            json.dump(made, file)
        write_obj(made, stem, "polygons")
        write_obj(made, os.path.join(folder, "cut", made["name"]), "triangles")
        write_off(made, stem)
        write_stl(made, stem)


if __name__ == "__main__":
    main(sys.argv[1])
