"""test_compare - that the comparison passes what is right and sees what is wrong

SPDX-License-Identifier: MIT
"""
import copy
import struct
import sys
from decimal import Decimal
from fractions import Fraction

import parser
from compare import mesh_difference
from shapes import SHAPES
from single import bits_of, bits_of_text, value_of


def mesh_of(made):
    mesh = parser.Mesh()
    mesh.positions = [tuple(bits_of(x) for x in position) for position in made["positions"]]
    mesh.polygons = made["polygons"]
    return mesh


def fan(polygon):
    return [[polygon[0], polygon[i], polygon[i + 1]] for i in range(1, len(polygon) - 1)]


def spoilt(triangles):
    """One wrong thing at a time."""
    yield "a triangle is missing", triangles[1:]
    yield "a triangle is there twice", triangles[:1] + triangles
    yield "two triangles have changed places", triangles[5:] + triangles[:5]
    turned = copy.deepcopy(triangles)
    turned[0][0], turned[0][1] = turned[0][1], turned[0][0]
    yield "a triangle is turned over", turned
    moved = copy.deepcopy(triangles)
    x, y, z = moved[0][0]
    moved[0][0] = (x ^ 1, y, z)
    yield "one bit of a coordinate differs", moved


class Checks:
    passed = failed = 0

    def __call__(self, sentence, holds):
        self.passed += bool(holds)
        self.failed += not holds
        if not holds:
            print(f"FAIL {sentence}")


def binary_stl(count, order):
    facet = struct.pack(order + "12f", *range(12)) + b"\0\0"
    return b" " * 80 + struct.pack(order + "I", count) + facet * 3


def half_way():
    """Just above the middle of two singles, by less than a double can tell."""
    low = bits_of(1.1)
    middle = (Fraction(value_of(low)) + Fraction(value_of(low + 1))) / 2
    exact = Decimal(middle.numerator) / Decimal(middle.denominator)
    return bits_of_text(f"{exact}000000000000001") == low + 1


def main():
    check = Checks()
    for made in SHAPES:
        mesh = mesh_of(made)
        found = lambda faces: [[mesh.positions[c] for c in face] for face in faces]
        right = found(made["triangles"])
        check(f"{made['name']} is right", mesh_difference(mesh, right) is None)
        for what, wrong in spoilt(right):
            check(f"{made['name']}: {what}", mesh_difference(mesh, wrong))
        if made["name"] in ("prism", "ell"):
            fans = found(t for polygon in made["polygons"] for t in fan(polygon))
            check(f"{made['name']}: caps cut as fans", mesh_difference(mesh, fans))
    check("a decimal is rounded once", half_way())
    long = parser.read_stl(binary_stl(9, "<"))
    check("the size of an STL counts", len(long.polygons) == 3)
    swapped = parser.read_stl(binary_stl(3, ">"))
    check("a big-endian STL is turned round", swapped.positions == long.positions)
    print(f"compare: {check.passed} passed, {check.failed} failed")
    return 1 if check.failed else 0


if __name__ == "__main__":
    sys.exit(main())
