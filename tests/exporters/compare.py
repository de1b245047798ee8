"""compare - what planelet reads, beside what the parser reads

compare.py PLANELET FOLDER [DIFFERENCES]: every file of FOLDER/EXPORTER, one line where the two
differ; the last line is "N exporters, N files, N differences". Triangles shall have the same
bits at the same corners in the same order. A polygon of n corners shall become n - 2 triangles
of its own corners which cover it: each side of the outline once and in its direction, every
other side twice and there and back, and the areas, seen along its normal, none the other way
round and in sum the polygon's. A file that the parser refuses planelet shall refuse, too, and
one without faces, and one with a coordinate that is not finite or beyond 2^40. What it
leaves out or misses in a file that it reads it shall say.

SPDX-License-Identifier: MIT
"""
import collections
import os
import subprocess
import sys
import tempfile

import image
import parser
from single import value_of

FARTHEST = 2.0 ** 40
# Of the polygon's size squared: the sums here are in double, and the caps, which alone have
# corners that are almost in line, lie in planes of constant z (or y), so no rounding bends them.
AREA_ERROR = 1e-9


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def area_vector(corners):
    """Twice the area along the normal, from exact corners near the first one."""
    sides = [minus(corner, corners[0]) for corner in corners]
    total = [0.0, 0.0, 0.0]
    for a, b in zip(sides, sides[1:] + sides[:1]):
        total = [t + c for t, c in zip(total, cross(a, b))]
    return total


def places(corners):
    return [[value_of(word) for word in corner] for corner in corners]


def sides_of(corners):
    return [(a, b) for a, b in zip(corners, corners[1:] + corners[:1])]


def polygon_difference(outline, triangles):
    """What is wrong with the triangles of one polygon, or None."""
    foreign = {corner for t in triangles for corner in t} - set(outline)
    if foreign:
        return "a corner that is not the polygon's"
    left = collections.Counter(side for t in triangles for side in sides_of(t))
    left.subtract(sides_of(outline))
    if any(n != left[b, a] for (a, b), n in list(left.items())):
        return "its outline is not covered"
    whole = area_vector(places(outline))
    size = max(max(map(abs, minus(corner, places(outline)[0]))) for corner in places(outline))
    length = dot(whole, whole) ** 0.5
    if length == 0:
        return None
    areas = [dot(area_vector(places(t)), whole) / length for t in triangles]
    if min(areas) < -AREA_ERROR * size * size:
        return "a triangle the other way round"
    if abs(sum(areas) - length) > AREA_ERROR * size * size:
        return f"area {sum(areas) / 2:.9g}, not {length / 2:.9g}"
    return None


def mesh_difference(mesh, found):
    wanted = sum(len(corners) - 2 for corners in mesh.polygons)
    if len(found) != wanted:
        return f"{len(found)} triangles, not {wanted}"
    at = 0
    for number, corners in enumerate(mesh.polygons):
        outline = [mesh.positions[corner] for corner in corners]
        triangles = found[at: at + len(corners) - 2]
        at += len(triangles)
        if len(corners) == 3 and triangles[0] != outline:
            return f"face {number}: {places(triangles[0])}, not {places(outline)}"
        wrong = len(corners) > 3 and polygon_difference(outline, triangles)
        if wrong:
            return f"face {number} of {len(corners)} corners: {wrong}"
    return None


def packed(planelet, path):
    """The status, the image and what was said."""
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out.plt")
        run = subprocess.run([planelet, "pack", path, "-o", out, "--build", "none"],
                             stdin=subprocess.DEVNULL, capture_output=True, timeout=120)
        made = b""
        if run.returncode == 0:
            with open(out, "rb") as file:
                made = file.read()
    return run.returncode, made, run.stderr.decode("utf-8", "replace").strip()


def file_difference(planelet, path):
    """What differs, or None, and a word on what the file is."""
    status, made, said = packed(planelet, path)
    said = said.replace(path, os.path.basename(path))
    try:
        mesh = parser.read(path)
    except parser.Refused as refusal:
        wrong = None if status == 1 else f"status {status}, but the parser refuses: {refusal}"
        return wrong, f"refused: {refusal}"
    short = f", {mesh.short} short" if mesh.short else ""
    corners = max(map(len, mesh.polygons), default=0)
    what = f"{len(mesh.polygons)} faces of up to {corners} corners{short}"
    if not mesh.polygons:
        vertices = str(len(mesh.positions))
        right = status == 1 and vertices in said
        return None if right else f"status {status} for {vertices} vertices, no faces: {said}", what
    if not all(abs(value_of(word)) <= FARTHEST for corner in mesh.positions for word in corner):
        return None if status == 1 else f"status {status} for a coordinate beyond 2^40", what
    if status != 0:
        return f"refused: {said}", what
    if mesh.short and str(mesh.short) not in said:
        return f"no word about {mesh.short} faces of fewer than 3 corners: {said}", what
    if not mesh.is_ended and "endsolid" not in said:
        return f"no word about the missing endsolid: {said}", what
    return mesh_difference(mesh, image.triangles(made)), what


def main(planelet, folder, listed=False):
    exporters = files = differences = 0
    for exporter in sorted(os.listdir(folder)):
        names = sorted(name for name in os.listdir(os.path.join(folder, exporter))
                       if name.endswith((".ply", ".obj", ".stl")))
        exporters += bool(names)
        wrongs = []
        for name in names:
            files += 1
            wrong, what = file_difference(planelet, os.path.join(folder, exporter, name))
            if listed:
                print(f"    {name}: {what}")
            if wrong:
                wrongs.append(f"FAIL {exporter}/{name}: {wrong}")
        print(f"{exporter}: {len(names)} files, {len(wrongs)} differences")
        for wrong in wrongs:
            print(wrong)
        differences += len(wrongs)
    print(f"{exporters} exporters, {files} files, {differences} differences")
    return 0 if files and not differences else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
